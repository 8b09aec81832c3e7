#pragma once

#include <hachure/runtime/assets/model.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace hachure {

/// Place of every node in its scene, from the nodes' own transforms. `nodes` may be a model's own, or those in a pose.
[[nodiscard]] std::vector<glm::mat4> node_matrices(std::span<const assets::Node> nodes);

/// The vertices of a node's mesh, by primitive, morphed by the node's weights (else the mesh's), then skinned linearly
/// where it has a skin; `matrices` are those of its nodes. Skinned vertices are in the scene's space, since glTF ignores
/// the transform of a skinned node; others in the node's. A vertex without weight stays where its morph targets leave it.
[[nodiscard]] std::vector<std::vector<glm::vec3>> posed_vertices(const assets::Model& model, const assets::Node& node,
                                                                 const std::vector<glm::mat4>& matrices);

/// Every vertex that a triangle uses, of every mesh of the default scene, in the scene, with the nodes as given.
[[nodiscard]] std::vector<glm::vec3> scene_points(const assets::Model& model, std::span<const assets::Node> nodes);

} // namespace hachure
