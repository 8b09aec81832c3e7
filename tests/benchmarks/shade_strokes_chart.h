#pragma once

#include <filesystem>

namespace hachure::bench {

/// What shade strokes cost the CPU, by what changes, and how exact they are for it. CSV for shade_strokes_chart.gp:
/// panel,series,label,x,y with the panels `touched` (x: cells touched, whose shade changes by a tenth, y: ms of the
/// update; label: the share of the cells), `band` (x: ms a frame while the light turns by a degree, y: mean |needed -
/// delivered|; label: the dead band), `cells` (the same, y: mean |shade by the light at a vertex - delivered|; label:
/// the number of cells) and `prepare` (x: triangles, y: ms once). `quick` takes small meshes.
void write_shade_strokes_chart(const std::filesystem::path& path, bool quick);

} // namespace hachure::bench
