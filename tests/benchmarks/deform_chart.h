#pragma once

#include <filesystem>

namespace hachure::bench {

/// Bends a cylinder by four angles and writes, for each way to get normals and principal directions on the deformed
/// mesh, its error and its cost. CSV for deform_chart.gp: panel,series,degrees,us,rms. `quick` takes a small mesh.
void write_deform_chart(const std::filesystem::path& path, bool quick);

} // namespace hachure::bench
