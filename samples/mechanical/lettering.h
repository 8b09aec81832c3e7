#pragma once

#include <hachure/runtime/scene/mesh_store.h>

#include <string_view>

/// Text in the single-stroke letters of technical drawings, as a flat mesh: no font file, sharp at every size.
/// In z = 0, facing +Z; the base line is y = 0, a small letter without a stem is 1 high, the middle of the text is x =
/// 0. Knows the letters that labels here need; another one is a gap.
hachure::SurfaceMesh lettering(std::string_view text, glm::vec3 color);

/// From the left end to the right end, in the same units.
float lettering_width(std::string_view text);
