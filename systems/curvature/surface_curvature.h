#pragma once

#include <hachure/components/curvature.h>
#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/fill_directions.h>
#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/vertex_neighbours.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace hachure {

/// Computes the curvatures of one surface and keeps its memory. Surfaces do not share it, so that many run at once.
class SurfaceCurvature {
public:
    /// Those of the shape, or of the mesh's own where there is none.
    void recompute(const SurfaceMesh& mesh, const Curvature& wanted, const Deformed* shape, PrincipalCurvatures& out);

    /// Those of the rest pose, computed once for a mesh and what is wanted, moved along by the skin that made `shape`.
    void carry(const SurfaceMesh& mesh, const Curvature& wanted, const Deform& settings, const Deformed& shape,
               PrincipalCurvatures& out);

private:
    void take_topology(const SurfaceMesh& mesh, bool neighbours);
    void fill(PrincipalCurvatures& out);

    // Of the mesh, whatever its shape.
    const SurfaceMesh* topology_of_ = nullptr;
    std::vector<std::uint32_t> weld_;
    geometry::VertexNeighbours neighbours_; ///< where something asked for them

    std::vector<glm::vec3> normals_;
    geometry::SmoothNormalsJob smooth_;
    geometry::CurvatureJob job_;
    geometry::FillDirectionsJob fill_;
    PrincipalCurvatures rest_;
    const SurfaceMesh* rest_of_ = nullptr;
    Curvature rest_as_; ///< what was wanted of `rest_`
};

} // namespace hachure
