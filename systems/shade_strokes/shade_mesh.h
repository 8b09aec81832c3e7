#pragma once

#include <hachure/runtime/geometry/mesh_health.h>
#include <hachure/runtime/geometry/surface_sheets.h>
#include <hachure/systems/shade_strokes/shade_cells.h>
#include <hachure/systems/shade_strokes/shade_chains.h>
#include <hachure/systems/shade_strokes/shade_directions.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hachure {

/// What a ShadeMesh is made from.
struct ShadeMeshInput {
    std::span<const glm::vec3> positions;    ///< of the rest pose; finite
    std::span<const glm::vec3> normals{};    ///< unit, one per vertex, or none: which edges are hard
    std::span<const std::uint32_t> indices;  ///< 3 per triangle, in range
    std::span<const glm::vec2> curvatures{}; ///< per vertex: k1, k2 with |k1| >= |k2|, 1/metre; or none: computed
    std::span<const glm::vec3> directions{}; ///< per vertex: unit tangent of k1; or none
    std::uint32_t cells = 4000;              ///< about how many cells to divide the surface into
};

/// Where the light on a cell is looked at.
struct ShadeSample {
    SurfacePoint point; ///< of the mesh
    float weight;       ///< the weights of a cell add up to 1
};

/// What shade strokes need to know of a mesh: built once, in the rest pose. Any mesh has one. Chains end at borders, at
/// edges where more than two triangles meet, where two triangles disagree about their front, and at hard edges.
struct ShadeMesh {
    geometry::SurfaceSheets sheets;
    ShadeDirections directions;
    ShadeCells cells;
    std::vector<std::uint32_t> order;        ///< all cells, in a random order that the seed does not change
    std::vector<std::uint32_t> first_sample; ///< per cell, one more at the end: into `samples`
    std::vector<ShadeSample> samples;
    std::vector<glm::vec3> normal; ///< per cell, unit
    geometry::MeshHealth health;   ///< what is wrong with the mesh
    float size = 1.0f;             ///< the diagonal of its bounds, in its units; positive
    float cell_side = 1.0f;        ///< the square root of a cell's mean area; positive

    [[nodiscard]] std::size_t cell_count() const { return cells.count(); }

    /// A place of the sheets as a point of the mesh.
    [[nodiscard]] SurfacePoint point(std::uint32_t triangle, const glm::dvec3& weight) const {
        return {sheets.face[triangle], static_cast<float>(weight[1]), static_cast<float>(weight[2])};
    }
    /// A point of the mesh in the rest pose.
    [[nodiscard]] glm::dvec3 at(const SurfacePoint& point) const;
};

[[nodiscard]] ShadeMesh make_shade_mesh(const ShadeMeshInput& input);

/// One line about what ends chains or is left out in a mesh, to be reported once; empty when nothing does.
[[nodiscard]] std::string shade_mesh_report(const ShadeMesh& mesh);

} // namespace hachure
