#pragma once

#include <hachure/components/metal.h>
#include <hachure/runtime/geometry/stripe_mesh.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace hachure {

/// What the stripes of a mesh are counted along: as asked, but `curvature` where a mesh without texture coordinates is
/// to take its stripes from them.
[[nodiscard]] MetalSource stripe_source(const SurfaceMesh& mesh, const Metal& metal);

/// Everything that `lay_stripes` depends on, as a number; `mesh_index` stands for the mesh.
[[nodiscard]] std::uint64_t stripe_layout_key(std::uint32_t mesh_index, const SurfaceMesh& mesh, const Metal& metal);

/// The mesh with the coordinate that its stripes are counted by, in sets. It is meant for a pattern that repeats with
/// every set, or, of source `curvature`, is mirrored by every other (geometry::StripeMesh). The mesh has normals and
/// triangles. Results of source `curvature` are kept in the user's cache folder.
[[nodiscard]] geometry::StripeMesh lay_stripes(const SurfaceMesh& mesh, const Metal& metal);

/// The axis of sources `around_axis` and `along_axis` in entity space.
struct StripeAxis {
    glm::vec3 point{0.0f};
    glm::mat3 axis_from_entity{1.0f}; ///< a rotation that turns the axis to +Z; angles are counted from +X
};

[[nodiscard]] StripeAxis stripe_axis(const SurfaceMesh& mesh, const Metal& metal);

/// Whole sets about the axis.
[[nodiscard]] float sets_around(const Metal& metal);

} // namespace hachure
