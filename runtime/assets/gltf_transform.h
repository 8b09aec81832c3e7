#pragma once

#include <hachure/runtime/assets/model.h>

namespace hachure::assets {

/// Sets the node's translation, rotation and scale from `matrix` when it is a product of those (a mirroring becomes a
/// negative scale of x); otherwise, for sheared, flat or projective matrices, keeps it as `Node::matrix`.
void set_transform(Node& node, const glm::mat4& matrix);

} // namespace hachure::assets
