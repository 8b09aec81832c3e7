#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/scene/view.h>

#include <glm/vec3.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace hachure {

/// Puts the model into the app's world, with a camera that frames it and the default light where the file has none. It
/// plays `clip`; the first one it has, if any, for an empty name; without a name it stands in its rest pose. Warnings
/// go to stderr. Throws Error when there is nothing to draw, or no such clip.
void load_model(App& app, const assets::Model& model, const std::filesystem::path& file, Canvas canvas,
                const std::optional<std::string>& clip = std::nullopt);

/// Throws Error when a point lies where floats can't draw it.
void check_drawable(const std::filesystem::path& file, std::span<const glm::vec3> points);

} // namespace hachure
