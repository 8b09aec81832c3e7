#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>

namespace hachure::geometry {

/// Where on the straight piece from a to b the place is that is nearest to another: 0 at a, 1 at b.
[[nodiscard]] inline float nearest_part(glm::vec2 a, glm::vec2 b, glm::vec2 place) {
    const glm::vec2 step = b - a;
    return std::clamp(glm::dot(place - a, step) / std::max(glm::dot(step, step), 1e-12f), 0.0f, 1.0f);
}

/// That place.
[[nodiscard]] inline glm::vec2 nearest_on(glm::vec2 a, glm::vec2 b, glm::vec2 place) {
    return a + nearest_part(a, b, place) * (b - a);
}

} // namespace hachure::geometry
