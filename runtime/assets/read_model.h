#pragma once

#include <hachure/runtime/assets/model.h>

#include <filesystem>

namespace hachure::assets {

/// What an input file holds, told by its extension (a trailing .gz is looked through).
enum class InputKind { model, image, video, unknown };

[[nodiscard]] InputKind input_kind(const std::filesystem::path& path);

/// Reads a glTF, GLB, OBJ, PLY, OFF or STL file and computes the normals it lacks. Where a mesh file names no material
/// its surfaces get a neutral grey, drawn on both sides. Throws Error.
[[nodiscard]] Model read_model(const std::filesystem::path& path);

} // namespace hachure::assets
