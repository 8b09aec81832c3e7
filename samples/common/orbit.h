#pragma once

#include <hachure/runtime/ecs/world.h>

#include <glm/vec3.hpp>

namespace samples {

/// Turns and moves a camera about a point.
class Orbit {
public:
    /// About the point `distance` metres before `camera`, which must outlive it.
    Orbit(hachure::World& world, hachure::Entity camera, float distance);

    void turn(float yaw, float pitch); ///< radians, as the hand drags
    void approach(float factor);       ///< of the distance; between .3 and 10 times the first one

private:
    void place();

    hachure::World& world_;
    hachure::Entity camera_;
    glm::vec3 pivot_;
    float distance_;
    float zoom_ = 1.0f;
};

} // namespace samples
