#pragma once

#include <hachure/runtime/ecs/field_info.h>

#include <filesystem>
#include <string>

/// Fields of components that hold the path of a file. In files they are relative to the folder of the file that says
/// them.
namespace hachure {

/// A text whose unit is "file", "image file", or "image or video file".
[[nodiscard]] bool is_file_field(const FieldInfo& field);

/// What is wrong with the file that such a field names, with its name, as far as it can be told without what uses it:
/// an image must be one that can be read, a video one whose first frame can, numbered images be alike. Empty when
/// nothing is, and for any other file.
[[nodiscard]] std::string file_fault(const FieldInfo& field, const std::filesystem::path& file);

} // namespace hachure
