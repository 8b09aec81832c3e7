#pragma once

#include <hachure/systems/model/spawn_model.h>

#include <string>

namespace samples {

/// Spawns the model of a file, or where `file` is empty a lay figure of that girth, `height` metres high. It plays the
/// first of its clips with "walk" in its name, else its first. Throws Error where there is nothing to draw, or nothing that
/// is high.
[[nodiscard]] hachure::SpawnedModel spawn_walking_figure(hachure::World& world, const std::string& file, float height,
                                                         float girth);

} // namespace samples
