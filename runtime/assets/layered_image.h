#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/image_layers.h>

#include <filesystem>
#include <optional>

/// Images with what a renderer knows of the pixels beside their colours: layers of an EXR.
namespace hachure::assets {

/// What a header says. Of files that are no EXR the colour's channels are those of read_image, and there is nothing
/// else.
struct ImageInfo {
    ImageSize size; ///< as read_upright_size has it
    ImageLayers layers;
};

/// Throws Error.
[[nodiscard]] ImageInfo read_image_info(const std::filesystem::path& path);

/// Which layers are read.
struct WantedLayers {
    bool color = false, normal = false, depth = false;
};

/// Depth where nothing is, metres.
inline constexpr float no_depth = 1e10f;

/// Depth from which on nothing is there, whatever a renderer writes for it: 1e10, 1e30, infinity. Metres.
inline constexpr float far_depth = 1e9f;

/// Layers of one size, those that were asked for and are there.
struct LayeredImage {
    /// As read_upright_image, finite; of an EXR without any it is f32 RGBA and transparent.
    std::optional<Image> color;
    std::optional<Image> normal; ///< f32, 3 channels: of length 1, or 0 where nothing is
    std::optional<Image> depth;  ///< f32, 1 channel: in (0, far_depth), or no_depth
};

/// Decodes layers of an image, each part of the file once. Normals shorter than 1e-4 are nothing, others get length 1
/// (filtering shortens them); depths that are 0, negative, infinite, or far_depth and more are nothing. Throws Error
/// for a file that can't be read and for values that are not finite, depths but NaN aside, with layer, channel, column
/// and row.
[[nodiscard]] LayeredImage read_layers(const std::filesystem::path& path, WantedLayers wanted);

} // namespace hachure::assets
