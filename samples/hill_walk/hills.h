#pragma once

#include <hachure/runtime/assets/model.h>

#include <glm/vec3.hpp>

namespace hill_walk {

constexpr double hills_radius = 13.0; ///< metres: a round island, flat at its shore
constexpr double path_radius = 5.5;   ///< of the circle that the hills leave a path along

/// Height of the ground, metres. Smooth everywhere: ridges and valleys are rounded over about half a metre.
[[nodiscard]] double ground_height(double x, double z);

/// Of unit length, upwards.
[[nodiscard]] glm::vec3 ground_normal(double x, double z);

/// The ground as a model of one mesh.
[[nodiscard]] hachure::assets::Model hills_model();

} // namespace hill_walk
