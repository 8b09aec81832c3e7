#pragma once

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/scene/view.h>

#include <filesystem>
#include <string>

namespace hachure {

/// Puts the model into the app's world, with a camera that frames it and the default light where the file has none.
/// Warnings go to stderr. Throws Error when there is nothing to draw.
void load_model(App& app, const assets::Model& model, const std::filesystem::path& file, Canvas canvas);

} // namespace hachure
