#pragma once

#include <hachure/runtime/ecs/field_info.h>

#include <filesystem>
#include <string>

/// Fields of components that hold the path of a file. In files they are relative to the folder of the file that says
/// them.
namespace hachure {

/// A text whose unit is "file", or "image file" for a picture.
[[nodiscard]] bool is_file_field(const FieldInfo& field);

/// What is wrong with the file that such a field names, with its name, as far as it can be told without what uses it:
/// a picture must be one that can be read. Empty when nothing is, and for any other file.
[[nodiscard]] std::string file_fault(const FieldInfo& field, const std::filesystem::path& file);

} // namespace hachure
