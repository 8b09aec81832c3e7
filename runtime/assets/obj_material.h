#pragma once

#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/assets/warning_list.h>

#include <filesystem>
#include <span>
#include <string>

namespace hachure::assets {

/// Fills `model.materials` with one material for each of `names`, in their order, from the material libraries beside
/// `obj`, and adds the textures and images that they use. Names without a definition get a default material. Nothing
/// here is a fault of the OBJ file: what is missing, refused or not understood becomes a warning.
void read_obj_materials(const std::filesystem::path& obj, std::span<const std::string> libraries,
                        std::span<const std::string> names, Model& model, WarningList& warnings);

/// Where a file named in `file` may be read: beside it or below. Empty for an absolute path, a drive, a URL, or a path
/// through "..". A backslash separates folders.
[[nodiscard]] std::filesystem::path path_beside(const std::filesystem::path& file, std::string_view name);

} // namespace hachure::assets
