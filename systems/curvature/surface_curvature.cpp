#include <hachure/runtime/geometry/skin.h>
#include <hachure/runtime/geometry/weld.h>
#include <hachure/systems/curvature/surface_curvature.h>

#include <span>

namespace hachure {

void SurfaceCurvature::take_topology(const SurfaceMesh& mesh, bool neighbours) {
    if (topology_of_ != &mesh) {
        weld_ = geometry::weld_positions(mesh.positions);
        neighbours_.first.clear();
        topology_of_ = &mesh;
    }
    if (neighbours && neighbours_.first.empty()) neighbours_.build(mesh.indices, weld_);
}

void SurfaceCurvature::recompute(const SurfaceMesh& mesh, const Curvature& wanted, const Deformed* shape,
                                 PrincipalCurvatures& out) {
    const bool neighbours = wanted.fill || wanted.method != geometry::CurvatureMethod::one_ring;
    take_topology(mesh, neighbours);
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
    out.confidences.resize(wanted.fill ? positions.size() : 0);
    job_.positions = positions;
    job_.normals = normals_;
    job_.indices = mesh.indices;
    job_.weld = weld_;
    job_.curvatures = out.curvatures;
    job_.directions = out.directions;
    job_.confidences = out.confidences;
    job_.method = wanted.method;
    job_.neighbours = neighbours ? &neighbours_ : nullptr;
    job_.run();
    if (wanted.fill) fill(out);
    out.version = shape ? shape->version : 0;
}

void SurfaceCurvature::fill(PrincipalCurvatures& out) {
    fill_.normals = normals_;
    fill_.weld = weld_;
    fill_.neighbours = &neighbours_;
    fill_.directions = out.directions;
    fill_.confidences = out.confidences;
    fill_.filled = out.directions;
    fill_.run();
}

void SurfaceCurvature::carry(const SurfaceMesh& mesh, const Curvature& wanted, const Deform& settings,
                             const Deformed& shape, PrincipalCurvatures& out) {
    if (rest_of_ != &mesh || !(rest_as_ == wanted)) {
        recompute(mesh, wanted, nullptr, rest_);
        rest_of_ = &mesh;
        rest_as_ = wanted;
    }
    out.curvatures.resize(mesh.positions.size());
    out.directions.resize(mesh.positions.size());
    out.confidences = rest_.confidences;
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
