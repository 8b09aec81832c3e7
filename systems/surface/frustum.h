#pragma once

#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/scene/view.h>

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <limits>

namespace hachure {

/// Whether a box in the world lies wholly on the outer side of one of the planes of the view; with reversed depth, what
/// is seen has -w <= x, y <= w and 0 <= z <= w.
[[nodiscard]] inline bool outside_frustum(const geometry::Bounds& bounds, const glm::mat4& clip_from_world) {
    if (bounds.empty()) return true;
    int outside[6] = {};
    for (int i = 0; i < 8; ++i) {
        const glm::vec4 c = clip_from_world * glm::vec4(bounds.corner(i), 1.0f);
        outside[0] += c.x < -c.w;
        outside[1] += c.x > c.w;
        outside[2] += c.y < -c.w;
        outside[3] += c.y > c.w;
        outside[4] += c.z < 0.0f;
        outside[5] += c.z > c.w;
    }
    for (const int count : outside)
        if (count == 8) return true;
    return false;
}

/// The pixels that a box in the world can touch, cut to the view; all of them when it reaches behind the eye.
[[nodiscard]] inline gpu::Rect screen_rect(const geometry::Bounds& bounds, const View& view) {
    glm::vec2 low(1.0f), high(-1.0f);
    for (int i = 0; i < 8; ++i) {
        const glm::vec4 c = view.clip_from_world * glm::vec4(bounds.corner(i), 1.0f);
        if (c.z > c.w || c.w <= 0.0f) return {0, 0, view.width, view.height};
        low = glm::min(low, glm::vec2(c) / c.w);
        high = glm::max(high, glm::vec2(c) / c.w);
    }
    const glm::vec2 size(static_cast<float>(view.width), static_cast<float>(view.height));
    const glm::ivec2 first(glm::floor((glm::clamp(low, -1.0f, 1.0f) * 0.5f + 0.5f) * size));
    const glm::ivec2 last(glm::ceil((glm::clamp(high, -1.0f, 1.0f) * 0.5f + 0.5f) * size));
    return {first.x, first.y, last.x - first.x, last.y - first.y};
}

/// Metres from the eye's plane to the nearest corner of a box in the world; those behind the near plane count as on it.
[[nodiscard]] inline float nearest_depth(const geometry::Bounds& bounds, const View& view) {
    float nearest = std::numeric_limits<float>::max();
    for (int i = 0; i < 8; ++i)
        nearest = std::min(nearest, -(view.view_from_world * glm::vec4(bounds.corner(i), 1.0f)).z);
    // Reversed depth: where the near plane is, clip z and w are the same.
    const float near_plane = view.clip_from_view[3][2] / (1.0f + view.clip_from_view[2][2]);
    return std::max({nearest, view.eye.w > 0.0f ? near_plane : nearest, 1e-6f});
}

} // namespace hachure
