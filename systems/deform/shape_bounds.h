#pragma once

#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <span>
#include <vector>

namespace hachure {

/// What a box around a mesh follows from, however it is deformed, without a look at its vertices.
struct ShapeBounds {
    /// By palette entry: around the rest positions of the vertices that follow it; a single one for a mesh without
    /// skin.
    std::vector<geometry::Bounds> rest;
    /// By morph target, by the same: around the displacements of those vertices and zero.
    std::vector<std::vector<geometry::Bounds>> moves;
};

[[nodiscard]] ShapeBounds shape_bounds(const SurfaceMesh& mesh);

/// A box around the mesh that `bounds` was made of, morphed by `weights` (one per target, or none), then skinned by
/// `palette` (empty for no skin). Weights that are not finite count as zero.
///
/// It holds every vertex that is blended linearly, since each is a mean of points of the boxes. Two rigid motions blend
/// along an arc of half a turn at most, which leaves the points that it joins by no more than half their distance: for
/// dual quaternions the box is grown by half its diagonal.
[[nodiscard]] geometry::Bounds bounds_of_shape(const ShapeBounds& bounds, std::span<const float> weights,
                                               std::span<const geometry::JointMatrix> palette,
                                               geometry::SkinMethod method);

} // namespace hachure
