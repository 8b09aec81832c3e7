#pragma once

#include <hachure/runtime/assets/image.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::assets {

/// Largest image that is decoded, pixels. A file that claims more is refused before anything is allocated.
inline constexpr std::int64_t max_image_pixels = std::int64_t{1} << 27;

/// Reads any still image that OpenImageIO knows (PNG, JPEG, EXR, HDR, TGA, ...). Integer files give u8, float files
/// f32; more than four channels are cut to the first four. Colours of PNG files are not multiplied by alpha. An EXR
/// gives f32: the colour that find_layers (image_layers.h) finds or, where there is none, its first channels, over its
/// display window, 0 where the file has no pixels. Throws Error when the file can't be read or is too large.
[[nodiscard]] Image read_image(const std::filesystem::path& path);

/// The same from bytes in memory; `name` is used in errors and its extension, when it has one, as a hint.
[[nodiscard]] Image read_image_memory(std::string_view name, std::span<const std::byte> bytes);

struct ImageSize {
    int width = 0, height = 0; ///< pixels, >= 1
};

/// The same, turned as its metadata say that it is to be seen (Exif's orientation): for photographs, not for textures.
[[nodiscard]] Image read_upright_image(const std::filesystem::path& path);

/// The size of the image that `read_upright_image` would read, from its header alone. Throws Error when there is none.
[[nodiscard]] ImageSize read_upright_size(const std::filesystem::path& path);

/// An 8-bit PNG. `image` is u8 with 1 to 4 channels, sRGB-encoded, not multiplied by alpha. The file appears whole or
/// not at all.
void write_png(const std::filesystem::path& path, const Image& image);

/// A ZIP-compressed 32-bit float EXR. `channel_names` has one name per channel ("R", "G", "B"; "Z"; ...). The same
/// image gives the same bytes whenever it is written. The file appears whole or not at all.
void write_exr(const std::filesystem::path& path, const Image& image, std::span<const std::string> channel_names);

} // namespace hachure::assets
