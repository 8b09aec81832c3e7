#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/frame_graph_key.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace hachure {

/// Size of the picture, pixels. A resource that the program sets.
struct Canvas {
    int width = 1024;
    int height = 768;

    friend bool operator==(const Canvas&, const Canvas&) = default;
};

/// The view of this frame, from the active camera; systems/camera computes it. A resource.
///
/// Depth is reversed: 1 at the near plane, 0 at the far plane or at infinity, which keeps float depth precise far away.
struct View {
    glm::mat4 view_from_world{1.0f};
    glm::mat4 clip_from_view{1.0f};
    glm::mat4 clip_from_world{1.0f};
    glm::vec4 eye{0.0f, 0.0f, 1.0f, 0.0f}; ///< place (w = 1, perspective) or direction towards it (w = 0, orthographic)
    glm::vec3 right{1.0f, 0.0f, 0.0f};     ///< the camera's axes in the world, unit
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    glm::vec3 backward{0.0f, 0.0f, 1.0f};
    int width = 1;  ///< pixels
    int height = 1; ///< pixels
    /// Metres that one pixel spans: at depth 1 in a perspective view, at every depth in an orthographic one.
    float pixel_size = 1.0f;
    Entity camera = Entity::null;

    /// What a pass that draws this view depends on.
    [[nodiscard]] std::uint64_t key() const { return gpu::key_of(view_from_world, clip_from_view, width, height); }

    friend bool operator==(const View&, const View&) = default;
};

} // namespace hachure
