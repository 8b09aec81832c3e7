#pragma once

#include <cstdint>
#include <vector>

namespace hachure::assets {

enum class TriangleMode : std::uint8_t { list, strip, fan };

/// The triangles of a list, strip or fan of vertex indices as a list, with the winding that glTF 2.0 gives them
/// (section 3.7.2.1). Vertices at the end that do not make a triangle are dropped.
[[nodiscard]] std::vector<std::uint32_t> triangle_list(TriangleMode mode, std::vector<std::uint32_t> vertices);

} // namespace hachure::assets
