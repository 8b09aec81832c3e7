#pragma once

#include <glm/mat4x4.hpp>

namespace hachure {

/// The entity's place in the world; systems/transform computes it from Transform and the parents.
struct WorldTransform {
    glm::mat4 matrix{1.0f}; ///< entity space to world space

    friend bool operator==(const WorldTransform&, const WorldTransform&) = default;
};

/// Replaces translation, rotation and scale where a file gives a matrix that they can't express (shear).
struct LocalMatrix {
    glm::mat4 matrix{1.0f};
};

} // namespace hachure
