#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hachure {

/// The world as a scene file: every entity that is not Unsaved, with what of its components differs from what a scene
/// gives it anyway; of models and other scenes the reference, the look and the overrides that SceneReference has: what
/// moved since in a model, as its clips do, is none. Paths are written relative to `folder`, that of the file to be. The
/// text is canonical: loading it and saving again gives the same.
///
/// What a scene file can't say goes into `warnings`, when given, a line each: surfaces that came from no file,
/// references to entities that have no name of their own. Throws Error for values that no file may hold (a number that
/// is not finite) and for trees deeper than a file may be.
[[nodiscard]] std::string save_scene(const World& world, const TypeRegistry& types, const std::filesystem::path& folder,
                                     std::vector<std::string>* warnings = nullptr);

/// Writes it, whole or not at all. Returns the warnings. Throws Error, also for what can't be written.
std::vector<std::string> write_scene(const World& world, const TypeRegistry& types, const std::filesystem::path& file);

} // namespace hachure
