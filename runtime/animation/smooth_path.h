#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::animation {

/// Where a path is at a time.
struct PathPoint {
    double time = 0.0; ///< seconds, finite
    glm::dvec3 place{0.0};
};

/// A curve through points, each at its time: the centripetal spline of Catmull and Rom (Yuksel, Schaefer and Keyser
/// 2011, "Parameterization and applications of Catmull-Rom curves"), which makes neither cusps nor loops between two
/// points however unevenly they lie, walked at a speed that is continuous: its parameter is a monotone cubic of time
/// (Fritsch and Carlson 1980). Points that lie on one another make it stand still in between.
struct SmoothPath {
    std::vector<double> times; ///< seconds, strictly ascending; at least one
    std::vector<glm::dvec3> points;
    std::vector<glm::dvec3> tangents; ///< by the curve's parameter
    std::vector<double> knots;        ///< the curve's parameter: sums of the square roots of distances
    std::vector<double> rates;        ///< of the parameter, per second
};

/// Points (at least one) have finite numbers and strictly ascending times.
[[nodiscard]] SmoothPath make_path(std::span<const PathPoint> points);

/// The place at a time; the first and the last point hold outside. `cursor` is any number at first, and makes the next
/// call cheap; the result does not depend on it.
[[nodiscard]] glm::dvec3 place_on(const SmoothPath& path, double time, std::uint32_t& cursor);

} // namespace hachure::animation
