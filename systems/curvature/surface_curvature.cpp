#include <hachure/runtime/geometry/skin.h>
#include <hachure/runtime/geometry/weld.h>
#include <hachure/systems/curvature/surface_curvature.h>

#include <span>

namespace hachure {

void SurfaceCurvature::recompute(const SurfaceMesh& mesh, const Deformed* shape, PrincipalCurvatures& out) {
    if (welded_ != &mesh) {
        weld_ = geometry::weld_positions(mesh.positions);
        welded_ = &mesh;
    }
    const std::span<const glm::vec3> positions = shape ? std::span<const glm::vec3>(shape->positions) : mesh.positions;
    normals_.resize(positions.size());
    // Normals of the smooth surface, whatever hard edges are shaded with: curvature is about the shape.
    smooth_.positions = positions;
    smooth_.indices = mesh.indices;
    smooth_.weld = weld_;
    smooth_.normals = normals_;
    smooth_.run();
    out.curvatures.resize(positions.size());
    out.directions.resize(positions.size());
    job_.positions = positions;
    job_.normals = normals_;
    job_.indices = mesh.indices;
    job_.weld = weld_;
    job_.curvatures = out.curvatures;
    job_.directions = out.directions;
    job_.run();
    out.version = shape ? shape->version : 0;
}

void SurfaceCurvature::carry(const SurfaceMesh& mesh, const Deform& settings, const Deformed& shape,
                             PrincipalCurvatures& out) {
    if (rest_of_ != &mesh) {
        recompute(mesh, nullptr, rest_);
        rest_of_ = &mesh;
    }
    out.curvatures.resize(mesh.positions.size());
    out.directions.resize(mesh.positions.size());
    geometry::CarryCurvatureJob job{.method = settings.method,
                                    .rest_normals = mesh.normals,
                                    .rest_curvatures = rest_.curvatures,
                                    .rest_directions = rest_.directions,
                                    .weights = &mesh.skin,
                                    .palette = shape.palette,
                                    .motions = shape.motions,
                                    .curvatures = out.curvatures,
                                    .directions = out.directions};
    job.run();
    out.version = shape.version;
}

} // namespace hachure
