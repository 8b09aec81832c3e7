#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/deformed_bounds.h>
#include <hachure/systems/deform/shape_bounds.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure {
namespace {

/// Around the displacements of the vertices that follow each palette entry, and zero.
std::vector<geometry::Bounds> moves_of(const SurfaceMesh& mesh, const geometry::MorphTargets::Array& array,
                                       std::size_t entries) {
    std::vector<geometry::Bounds> moves(entries, {glm::vec3(0.0f), glm::vec3(0.0f)});
    const geometry::SkinWeights& skin = mesh.skin;
    for (std::size_t i = 0; i < array.deltas.size(); ++i) {
        const std::size_t v = array.vertices.empty() ? i : array.vertices[i];
        if (skin.vertex_count() == 0) moves[0].include(array.deltas[i]);
        for (std::size_t k = 0; skin.vertex_count() > 0 && k < skin.influences(); ++k)
            if (skin.weight(v, k) > 0.0f) moves[skin.joint(v, k)].include(array.deltas[i]);
    }
    return moves;
}

/// The box that all points of `bounds` are in when each is moved by `weight` times a point of `move`.
void add(geometry::Bounds& bounds, float weight, const geometry::Bounds& move) {
    const glm::vec3 a = weight * move.low, b = weight * move.high;
    bounds.low += glm::min(a, b);
    bounds.high += glm::max(a, b);
}

} // namespace

ShapeBounds shape_bounds(const SurfaceMesh& mesh) {
    ShapeBounds bounds;
    if (mesh.skin.vertex_count() > 0)
        bounds.rest = geometry::rest_joint_bounds(mesh.skin, mesh.positions);
    else
        bounds.rest = {geometry::bounds_of(mesh.positions)};
    for (std::size_t t = 0; t < mesh.morphs.size(); ++t)
        bounds.moves.push_back(moves_of(mesh, mesh.morphs[t].positions, bounds.rest.size()));
    return bounds;
}

geometry::Bounds bounds_of_shape(const ShapeBounds& bounds, std::span<const float> weights,
                                 std::span<const geometry::JointMatrix> palette, geometry::SkinMethod method) {
    HACHURE_ASSERT(weights.empty() || weights.size() == bounds.moves.size(), "one weight per target or none");
    std::vector<geometry::Bounds> morphed = bounds.rest;
    for (std::size_t t = 0; t < weights.size(); ++t)
        for (std::size_t j = 0; weights[t] != 0.0f && std::isfinite(weights[t]) && j < morphed.size(); ++j)
            if (!morphed[j].empty()) add(morphed[j], weights[t], bounds.moves[t][j]);
    if (palette.empty()) return geometry::deformed_bounds(morphed, std::vector<geometry::JointMatrix>(morphed.size()));
    geometry::Bounds result = geometry::deformed_bounds(morphed, palette);
    if (method == geometry::SkinMethod::linear || result.empty()) return result;
    const glm::vec3 margin(result.radius());
    return {result.low - margin, result.high + margin};
}

} // namespace hachure
