#include <hachure/systems/shade_strokes/chain_direction.h>
#include <hachure/systems/shade_strokes/shade_random.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace hachure {
namespace {

using geometry::WalkPlace;
using geometry::WalkTriangle;

constexpr double wander_length = 8.0; // of a disturbance, over the side of a cell
constexpr double least_inward = 0.02; // sine of the angle to an edge that was come over

/// A smooth random number in [-1, 1] along a chain.
double wander(std::uint64_t random, double x) {
    const double whole = std::floor(x), t = x - whole;
    const auto at = [&](double i) {
        return 2.0 * shade_uniform(random, ShadePurpose::wander, static_cast<std::uint64_t>(std::int64_t(i))) - 1.0;
    };
    const double a = at(whole), b = at(whole + 1.0);
    return a + (b - a) * t * t * (3.0 - 2.0 * t);
}

} // namespace

glm::dvec3 chain_direction(const ShadeMesh& mesh, const WalkTriangle& triangle, const WalkPlace& place,
                           const glm::dvec3& heading, double trueness, std::uint64_t random, double along) {
    const glm::dvec3 x = triangle.tangent(triangle.corner[1] - triangle.corner[0]), y = glm::cross(triangle.normal, x);
    // Lines have no sign: they are averaged by twice their angle.
    double cosine = 0.0, sine = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 line(mesh.directions.along[mesh.sheets.triangles[place.triangle][k]]);
        const double a = glm::dot(line, x), b = glm::dot(line, y), weight = place.weight[static_cast<int>(k)];
        cosine += weight * (a * a - b * b);
        sine += weight * 2.0 * a * b;
    }
    const double size = std::hypot(cosine, sine);
    if (!(size > 1e-6)) return heading;
    double angle = 0.5 * std::atan2(sine, cosine);
    if (trueness < 1.0)
        angle += (1.0 - trueness) * 0.5 * std::numbers::pi * wander(random, along / (wander_length * mesh.cell_side));
    const glm::dvec3 direction = std::cos(angle) * x + std::sin(angle) * y;
    return glm::dot(direction, heading) < 0.0 ? -direction : direction;
}

glm::dvec3 mirrored_inside(const WalkTriangle& triangle, std::uint32_t edge, const glm::dvec3& direction) {
    const glm::dvec3 inward = triangle.inward(edge);
    const double across = glm::dot(direction, inward);
    if (across >= least_inward) return direction;
    const double wanted = across < -least_inward ? -across : least_inward;
    return glm::normalize(direction + (wanted - across) * inward);
}

} // namespace hachure
