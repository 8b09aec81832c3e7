#pragma once

#include <glm/vec3.hpp>

namespace hachure::geometry {

/// On which side of the plane through a, b and c a point d lies: 1 where the three run counter-clockwise as seen from
/// it, -1 where they run clockwise, 0 where it lies in their plane. Exact for all finite floats: the determinant in
/// double where its rounding cannot matter (Shewchuk 1997), else summed without any rounding.
[[nodiscard]] int orientation(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

} // namespace hachure::geometry
