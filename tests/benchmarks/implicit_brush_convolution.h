#pragma once

#include <hachure/runtime/gpu/context.h>
#include <hachure/tests/benchmarks/bench_report.h>

#include <filesystem>
#include <iosfwd>

namespace hachure::bench {

/// What adding up the stamps of a brush of radius 10 costs against one quad for every pixel, as Vergne et al. 2011 do:
/// for ridges of bunny, or `model`, that fills half of a view of 1024x768, with every method that suits them.
void report_convolution(Report& report, gpu::Context& context, const std::filesystem::path& model, bool quick);

/// Error against time: rows panel,series,label,x,y for the panels `radius` (x: ms of a megapixel, of each method),
/// `sums` (their storage) and `cutoff` (of splats); y is the largest error after tone mapping, in 1/255, against double
/// precision.
void write_convolution_rows(std::ostream& file, gpu::Context& context, const std::filesystem::path& model, bool quick);

} // namespace hachure::bench
