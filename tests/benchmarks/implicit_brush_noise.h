#pragma once

#include <hachure/runtime/gpu/context.h>
#include <hachure/tests/benchmarks/bench_report.h>

namespace hachure::bench {

/// Adds a row for each grain of noise: what it adds to a frame of 1024x768 pixels whose view a turning ball half fills,
/// in full-screen passes of nine RGBA16F fetches, one of which takes `pass_ms` milliseconds in the same run; and one
/// for the optical flow between two frames of a video of that size.
void add_noise_rows(Report& report, gpu::Context& context, double pass_ms, bool quick);

} // namespace hachure::bench
