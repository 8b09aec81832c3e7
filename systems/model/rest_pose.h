#pragma once

#include <hachure/runtime/assets/model.h>

#include <glm/mat4x4.hpp>

#include <vector>

namespace hachure {

/// Place of every node of the model in its scene, from the nodes' own transforms (no clip applied).
[[nodiscard]] std::vector<glm::mat4> node_matrices(const assets::Model& model);

/// The mesh of a node as it stands at rest: default morph weights applied, then, when the node has a skin, linear blend
/// skinning with the joints where the nodes put them. Skinned vertices are in the scene's space, since glTF ignores the
/// transform of a skinned node; others in the node's. Weights that don't sum to 1 are normalised; a vertex without
/// weight stays where its morph targets leave it.
[[nodiscard]] std::vector<assets::Primitive> rest_pose(const assets::Model& model, const assets::Node& node,
                                                       const std::vector<glm::mat4>& matrices);

} // namespace hachure
