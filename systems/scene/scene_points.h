#pragma once

#include <hachure/systems/scene/build_scene.h>

#include <glm/vec3.hpp>

#include <vector>

namespace hachure {

/// What of the models of a scene a camera must see, in the world: their vertices at rest, or over the clip that their
/// Animation names. Of many models, or large ones, the corners of the box around each. `cache` still has the vertices.
[[nodiscard]] std::vector<glm::vec3> scene_points(const World& world, SceneCache& cache, const BuiltScene& scene);

} // namespace hachure
