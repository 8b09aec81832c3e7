#pragma once

#include <filesystem>

namespace hachure::bench {

/// How far off curvature is on an irregular torus, and what it costs, by method, rings and noise, beside what was
/// published. CSV for curvature_chart.gp: noise,series,rings,us,rms,degrees. `quick` takes a small mesh, once.
void write_curvature_chart(const std::filesystem::path& path, bool quick);

} // namespace hachure::bench
