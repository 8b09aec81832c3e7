#include <hachure/systems/shade_strokes/shade_ribs.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

using geometry::WalkPlace;
using geometry::WalkTriangle;

constexpr double usual_radius = 0.25; // of curvature, over the model's size: there the amplitude is the set one
constexpr double facing = 0.0;        // ribs end where the surface turns by 90 degrees

/// Walks across a chain; writes the points halfway and at the end, returns how far it came.
double lay_half(const ShadeMesh& mesh, const WalkPlace& from, const glm::dvec3& across, const glm::dvec3& normal,
                double length, SurfacePoint& halfway, SurfacePoint& outermost) {
    const auto walk = [&](WalkPlace& place, glm::dvec3& direction, double most) {
        return geometry::walk_straight(mesh.sheets, place, direction, most, normal, facing);
    };
    WalkPlace place = from;
    glm::dvec3 direction = across;
    double done = walk(place, direction, 0.5 * length);
    halfway = mesh.point(place.triangle, place.weight);
    if (done >= 0.5 * length) done += walk(place, direction, 0.5 * length);
    outermost = mesh.point(place.triangle, place.weight);
    if (done < length) { // it ended before: halfway is nearer
        WalkPlace again = from;
        direction = across;
        walk(again, direction, 0.5 * done);
        halfway = mesh.point(again.triangle, again.weight);
    }
    return done;
}

} // namespace

float shade_amplitude(const ShadeMesh& mesh, const ShadeSettings& settings, const WalkPlace& place) {
    const auto& corner = mesh.sheets.triangles[place.triangle];
    double curvature = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
        curvature += place.weight[static_cast<int>(k)] * double{mesh.directions.curvature[corner[k]]};
    const double size = mesh.size, by = std::clamp(settings.amplitude_by_curvature, 0.0f, 1.0f);
    const double radius = 1.0 / std::max(curvature * size, 1e-3); // over the model's size
    const double wanted = settings.amplitude * (1.0 - by + by * radius / usual_radius);
    const double least = settings.min_amplitude, most = std::max(settings.max_amplitude, settings.min_amplitude);
    return static_cast<float>(std::clamp(wanted, least, most) * size);
}

ShadeNode make_shade_node(const ShadeMesh& mesh, const ShadeSettings& settings, const WalkPlace& place,
                          const glm::dvec3& heading, double along) {
    const WalkTriangle triangle(mesh.sheets, place.triangle);
    const double wanted = shade_amplitude(mesh, settings, place);
    const glm::dvec3 left = triangle.tangent(glm::cross(triangle.normal, heading));
    ShadeNode node{};
    node.rib[2] = mesh.point(place.triangle, place.weight);
    const double right_length = lay_half(mesh, place, -left, triangle.normal, wanted, node.rib[1], node.rib[0]);
    const double left_length = lay_half(mesh, place, left, triangle.normal, wanted, node.rib[3], node.rib[4]);
    node.amplitude = static_cast<float>(0.5 * (left_length + right_length));
    node.along = static_cast<float>(along);
    return node;
}

} // namespace hachure
