#pragma once

#include <hachure/runtime/gpu/frame_graph_key.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace hachure {

/// A light as shaders see it, in the world.
struct ShadingLight {
    glm::vec4 position{0.0f, 1.0f, 0.0f, 0.0f}; ///< place, w = 1; or direction towards the light, w = 0 (directional)
    glm::vec3 direction{0.0f, -1.0f, 0.0f};     ///< where a spot points, unit
    glm::vec3 color{1.0f};                      ///< linear RGB, relative to the strongest light of the scene
    float range = 0.0f;                         ///< metres; 0 for no limit
    bool spot = false;
    float inner_cone = 0.0f; ///< radians
    float outer_cone = 0.0f; ///< radians
    bool gaze = false;       ///< directional; turns from the camera's axis to the line of sight to each point

    friend bool operator==(const ShadingLight&, const ShadingLight&) = default;
};

/// The lights of this frame, the strongest first; systems/light gathers them. A resource.
struct LightList {
    static constexpr std::size_t max_lights = 16;

    std::vector<ShadingLight> lights;

    /// What a pass that uses the lights depends on.
    [[nodiscard]] std::uint64_t key() const {
        gpu::KeyHash hash;
        for (const ShadingLight& light : lights) {
            hash.add(light.position);
            hash.add(light.direction);
            hash.add(light.color);
            hash.add(light.range);
            hash.add(light.spot);
            hash.add(light.inner_cone);
            hash.add(light.outer_cone);
            hash.add(light.gaze);
        }
        return hash.value();
    }

    friend bool operator==(const LightList&, const LightList&) = default;
};

} // namespace hachure
