#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/systems/scene/scene_cache.h>
#include <hachure/systems/styles/style.h>

#include <filesystem>
#include <optional>

namespace hachure {

/// Sets the world's Spawner (runtime/scene/spawner.h). It reads models and scenes in the folder of `file` and below, no
/// others, and gives what it spawns the style. `cache` holds what has been read already.
void set_scene_spawner(App& app, const std::filesystem::path& file, std::optional<Style> style, SceneCache cache = {});

} // namespace hachure
