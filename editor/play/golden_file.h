#pragma once

#include <hachure/editor/play/json_object.h>
#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/scene/view.h>

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

namespace hachure::play {

/// Reads a member that names a picture within `folder` (no way up, not absolute), with that extension (".png"). Throws
/// Error with line and column.
[[nodiscard]] std::filesystem::path parse_picture_path(JsonObject& object, const std::string& key,
                                                       const std::filesystem::path& folder,
                                                       const std::string& extension);

/// The optional member "mask", as parse_picture_path; empty when absent.
[[nodiscard]] std::filesystem::path parse_mask(JsonObject& object, const std::filesystem::path& folder);

/// A golden picture or mask that has the size and type wanted, or why there is none.
struct GoldenFile {
    std::optional<assets::Image> image;
    std::string fault; ///< in words, when there is no image
};

/// Reads it; `channels` 0 takes any. A file that is missing, broken, or of another size or type is a fault.
[[nodiscard]] GoldenFile read_golden(const std::filesystem::path& file, int width, int height, int channels,
                                     assets::PixelType type);

/// Whether two images are the same, byte for byte.
[[nodiscard]] bool identical(const assets::Image& a, const assets::Image& b);

/// Makes the folders that the file lies in. Throws Error.
void make_folder_of(const std::filesystem::path& file);

} // namespace hachure::play
