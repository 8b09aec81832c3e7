#pragma once

#include <hachure/runtime/geometry/skin.h>

#include <glm/mat3x3.hpp>

#include <cstddef>
#include <span>

namespace hachure::geometry {

/// The linear part of what a vertex's joints do to it together, in double: as SkinJob blends it.
[[nodiscard]] glm::dmat3 blended_matrix(const SkinWeights& weights, std::span<const JointMatrix> palette,
                                        std::size_t vertex);
[[nodiscard]] glm::dmat3 blended_motion(const SkinWeights& weights, std::span<const JointMotion> motions,
                                        std::size_t vertex);

} // namespace hachure::geometry
