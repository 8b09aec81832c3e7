#include <hachure/systems/shade_strokes/half_rib.h>
#include <hachure/systems/shade_strokes/shade_ribs.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hachure {
namespace {

using geometry::WalkPlace;
using geometry::WalkTriangle;

constexpr double usual_radius = 0.25; // of curvature, over the model's size: there the amplitude is the set one

std::array<double, rib_points> sides(const ShadeNode& node) { return {-1.0, node.bend[0], 0.0, node.bend[1], 1.0}; }

/// The patch between two nodes, `part` of the way: what patch.glsl draws on.
struct PatchLine {
    std::array<double, rib_points> side;
    std::array<glm::dvec3, rib_points> point;

    PatchLine(const ShadeMesh& mesh, const ShadeNode& from, const ShadeNode& to, double part) {
        for (std::size_t k = 0; k < rib_points; ++k) {
            side[k] = std::lerp(sides(from)[k], sides(to)[k], part);
            point[k] = glm::mix(mesh.at(from.rib[k]), mesh.at(to.rib[k]), part);
        }
    }

    [[nodiscard]] glm::dvec3 at(double s) const {
        std::size_t k = s < 0.0 ? 0 : 2;
        if (s > side[k + 1]) ++k;
        return glm::mix(point[k], point[k + 1], std::clamp((s - side[k]) / (side[k + 1] - side[k]), 0.0, 1.0));
    }
};

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

ShadeRib make_shade_rib(const ShadeMesh& mesh, const ShadeSettings& settings, const WalkPlace& place,
                        const glm::dvec3& heading, double along) {
    const WalkTriangle triangle(mesh.sheets, place.triangle);
    const HalfRibWish wish{shade_amplitude(mesh, settings, place), double{settings.rib_deviation} * mesh.size};
    const glm::dvec3 left = triangle.tangent(glm::cross(triangle.normal, heading));
    const HalfRib right_half = walk_half_rib(mesh, place, -left, wish);
    const HalfRib left_half = walk_half_rib(mesh, place, left, wish);
    ShadeNode node{};
    node.rib[0] = right_half.outer;
    node.rib[1] = right_half.bend;
    node.rib[2] = mesh.point(place.triangle, place.weight);
    node.rib[3] = left_half.bend;
    node.rib[4] = left_half.outer;
    node.bend[0] = static_cast<float>(-right_half.bend_part);
    node.bend[1] = static_cast<float>(left_half.bend_part);
    node.amplitude = static_cast<float>(0.5 * (left_half.length + right_half.length));
    node.along = static_cast<float>(along);
    return {node, {right_half.ends, left_half.ends}};
}

double patch_deviation(const ShadeMesh& mesh, const ShadeNode& from, const ShadeNode& to, const ShadeRib& between,
                       double part) {
    const PatchLine patch(mesh, from, to, part);
    const ShadeNode& node = between.node;
    double most = 0.0;
    for (std::size_t k = 0; k < rib_points; ++k) {
        const glm::dvec3 off = patch.at(sides(node)[k]) - mesh.at(node.rib[k]);
        const WalkTriangle triangle(mesh.sheets, mesh.sheets.triangle_of[node.rib[k].triangle]);
        most = std::max(most, std::abs(glm::dot(off, triangle.normal)));
    }
    for (const std::size_t half : {0, 1}) {
        if (!between.ends[half]) continue;
        const std::size_t outer = half == 0 ? 0 : rib_points - 1;
        const glm::dvec3 end = mesh.at(node.rib[outer]), out = end - mesh.at(node.rib[half == 0 ? 1 : 3]);
        const double size = glm::length(out);
        if (size > 0.0) most = std::max(most, glm::dot(patch.point[outer] - end, out) / size);
    }
    return most;
}

} // namespace hachure
