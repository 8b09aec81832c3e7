#pragma once

#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace hachure::assets {

/// KHR_texture_transform as an affine map of (u, v, 1): scale, then a turn by `rotation` radians, counter-clockwise
/// where v points down, then the offset.
[[nodiscard]] inline glm::mat3x2 texcoord_transform(glm::vec2 offset, glm::vec2 scale, float rotation) {
    const float c = std::cos(rotation), s = std::sin(rotation);
    return {glm::vec2(c, -s) * scale.x, glm::vec2(s, c) * scale.y, offset};
}

} // namespace hachure::assets
