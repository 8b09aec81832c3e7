#pragma once

#include <hachure/components/deformed.h>
#include <hachure/components/toon.h>
#include <hachure/runtime/geometry/diffused_normals.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace hachure {

/// What the normals of an abstracted shape follow from, beside the mesh.
struct AbstractedShapeKey {
    std::uint32_t mesh = 0;
    AbstractedShape shape = AbstractedShape::smoothed;
    float radius = 0.0f; ///< 0 where the shape has none

    AbstractedShapeKey() = default;
    AbstractedShapeKey(std::uint32_t mesh_index, const Toon& toon)
        : mesh(mesh_index), shape(toon.abstracted_shape),
          radius(toon.abstracted_shape == AbstractedShape::smoothed ? toon.abstraction_radius : 0.0f) {}

    friend auto operator<=>(const AbstractedShapeKey&, const AbstractedShapeKey&) = default;
};

using SharedNormals = std::shared_ptr<const std::vector<glm::vec3>>;

/// Of a mesh in its own shape; none of a mesh without normals.
[[nodiscard]] SharedNormals abstracted_normals(const SurfaceMesh& mesh, const AbstractedShapeKey& key);

/// The same, moved along by the skin that made `shape`, into `carried`.
void carry_abstracted_normals(const SurfaceMesh& mesh, const std::vector<glm::vec3>& rest, geometry::SkinMethod method,
                              const Deformed& shape, std::vector<glm::vec3>& carried);

} // namespace hachure
