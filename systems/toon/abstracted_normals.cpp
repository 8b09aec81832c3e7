#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/carry_normals.h>
#include <hachure/runtime/geometry/fitted_normals.h>
#include <hachure/runtime/geometry/weld.h>
#include <hachure/systems/toon/abstracted_normals.h>

namespace hachure {
namespace {

geometry::FittedShape fitted_shape(AbstractedShape shape) {
    switch (shape) {
    case AbstractedShape::sphere:
        return geometry::FittedShape::sphere;
    case AbstractedShape::cylinder:
        return geometry::FittedShape::cylinder;
    case AbstractedShape::ellipsoid:
    case AbstractedShape::smoothed:
        break;
    }
    return geometry::FittedShape::ellipsoid;
}

} // namespace

SharedNormals abstracted_normals(const SurfaceMesh& mesh, const AbstractedShapeKey& key) {
    auto result = std::make_shared<std::vector<glm::vec3>>(mesh.positions.size());
    if (mesh.normals.size() != mesh.positions.size()) {
        result->clear(); // nothing to abstract from
        return result;
    }
    if (key.shape != AbstractedShape::smoothed) {
        geometry::FittedNormalsJob job{.shape = fitted_shape(key.shape),
                                       .positions = mesh.positions,
                                       .normals = mesh.normals,
                                       .indices = mesh.indices,
                                       .fitted = *result};
        job.run();
        return result;
    }
    const std::vector<std::uint32_t> weld = geometry::weld_positions(mesh.positions);
    geometry::DiffusedNormalsJob job{.positions = mesh.positions,
                                     .normals = mesh.normals,
                                     .indices = mesh.indices,
                                     .weld = weld,
                                     .radius = static_cast<double>(key.radius * mesh.bounds.radius()),
                                     .diffused = *result};
    job.run();
    return result;
}

void carry_abstracted_normals(const SurfaceMesh& mesh, const std::vector<glm::vec3>& rest, geometry::SkinMethod method,
                              const Deformed& shape, std::vector<glm::vec3>& carried) {
    carried.resize(rest.size());
    geometry::CarryNormalsJob job{.method = method,
                                  .rest = rest,
                                  .weights = &mesh.skin,
                                  .palette = shape.palette,
                                  .motions = shape.motions,
                                  .carried = carried};
    job.run();
}

} // namespace hachure
