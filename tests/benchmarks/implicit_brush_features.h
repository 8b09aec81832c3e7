#pragma once

#include <hachure/runtime/gpu/context.h>
#include <hachure/tests/benchmarks/bench_report.h>

#include <filesystem>

namespace hachure::bench {

/// What finding features costs with a model that fills half of the view, against full-screen passes of nine RGBA16F
/// fetches in the same run; `quick` takes a small picture. Returns the milliseconds of such a pass.
double report_features(Report& report, gpu::Context& context, const std::filesystem::path& model, bool quick);

} // namespace hachure::bench
