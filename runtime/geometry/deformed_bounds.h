#pragma once

#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/skin_palette.h>
#include <hachure/runtime/geometry/skin_weights.h>

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace hachure::geometry {

/// Per palette entry: the box around the rest positions of the vertices that follow it; empty where none does.
[[nodiscard]] std::vector<Bounds> rest_joint_bounds(const SkinWeights& weights,
                                                    std::span<const glm::vec3> rest_positions);

/// A box around the mesh deformed by linear blending, from the boxes of `rest_joint_bounds` alone: for skinning on the
/// GPU and for culling before vertices are touched. It holds every vertex, since each is a mean of points of those
/// boxes as their joints move them, up to rounding (of which a margin of 1e-5 of its size takes care), and is larger
/// than the tight one that `SkinJob` gives. One box per palette entry is asserted.
[[nodiscard]] Bounds deformed_bounds(std::span<const Bounds> joint_bounds, std::span<const JointMatrix> palette);

} // namespace hachure::geometry
