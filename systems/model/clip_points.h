#pragma once

#include <hachure/runtime/animation/clip.h>
#include <hachure/runtime/assets/model.h>

#include <glm/vec3.hpp>

#include <vector>

namespace hachure {

/// Vertices of the model's default scene, where they are at moments spread over a clip of it: what a camera that is to
/// see the whole clip must see.
[[nodiscard]] std::vector<glm::vec3> clip_points(const assets::Model& model, const animation::ClipSet& set,
                                                 const animation::Clip& clip);

} // namespace hachure
