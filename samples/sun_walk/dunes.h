#pragma once

#include <hachure/runtime/assets/model.h>

namespace sun_walk {

constexpr double dunes_radius = 6.0; ///< metres: a round island, flat at its shore
constexpr double path_radius = 2.6;  ///< of the circle that the figure follows

/// Height of the ground, metres: three dunes around the path and a hill in its middle, smooth everywhere.
[[nodiscard]] double dune_height(double x, double z);

/// The ground as a model of one mesh.
[[nodiscard]] hachure::assets::Model dunes_model();

} // namespace sun_walk
