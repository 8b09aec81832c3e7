#pragma once

#include <filesystem>

namespace hachure::bench {

/// What finding the silhouettes costs on meshes of more and more triangles, while the eye moves and while the mesh
/// deforms. CSV for edge_lines_chart.gp: panel,series,triangles,ms. `quick` takes small meshes.
void write_edge_lines_chart(const std::filesystem::path& path, bool quick);

} // namespace hachure::bench
