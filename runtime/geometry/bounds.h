#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <limits>
#include <span>

namespace hachure::geometry {

/// An axis-aligned box; empty until something is included.
struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};

    [[nodiscard]] bool empty() const { return low.x > high.x; }
    [[nodiscard]] glm::vec3 center() const { return empty() ? glm::vec3(0.0f) : 0.5f * low + 0.5f * high; }
    [[nodiscard]] glm::vec3 extent() const { return empty() ? glm::vec3(0.0f) : high - low; }
    [[nodiscard]] float radius() const { return 0.5f * glm::length(extent()); } ///< of the sphere around the box

    void include(glm::vec3 point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void include(const Bounds& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    /// Corner `index` in [0, 8): bit 0 picks x, bit 1 y, bit 2 z.
    [[nodiscard]] glm::vec3 corner(int index) const {
        return {index & 1 ? high.x : low.x, index & 2 ? high.y : low.y, index & 4 ? high.z : low.z};
    }
};

/// Smallest box around `points`.
[[nodiscard]] inline Bounds bounds_of(std::span<const glm::vec3> points) {
    Bounds bounds;
    for (const glm::vec3& point : points) bounds.include(point);
    return bounds;
}

/// Box around the transformed corners of `bounds`.
[[nodiscard]] inline Bounds transformed(const Bounds& bounds, const glm::mat4& matrix) {
    Bounds result;
    if (bounds.empty()) return result;
    for (int i = 0; i < 8; ++i) result.include(glm::vec3(matrix * glm::vec4(bounds.corner(i), 1.0f)));
    return result;
}

} // namespace hachure::geometry
