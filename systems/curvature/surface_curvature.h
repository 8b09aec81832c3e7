#pragma once

#include <hachure/components/curvature.h>
#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/normals.h>
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
    void recompute(const SurfaceMesh& mesh, const Deformed* shape, PrincipalCurvatures& out);

    /// Those of the rest pose, moved along by the skin that made `shape`.
    void carry(const SurfaceMesh& mesh, const Deform& settings, const Deformed& shape, PrincipalCurvatures& out);

private:
    std::vector<std::uint32_t> weld_;
    const SurfaceMesh* welded_ = nullptr;
    std::vector<glm::vec3> normals_;
    geometry::SmoothNormalsJob smooth_;
    geometry::CurvatureJob job_;
    PrincipalCurvatures rest_;
    const SurfaceMesh* rest_of_ = nullptr;
};

} // namespace hachure
