#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/assets/image_layers.h>

#include <OpenImageIO/imageio.h>

#include <span>
#include <string>
#include <vector>

/// Pixels of OpenEXR files, by channel. Not for users of the folder.
namespace hachure::assets {

/// A channel, and the channel of an f32 image of the display window's size that takes it.
struct ChannelRead {
    ImageChannel from;
    Image* into = nullptr;
    int channel = 0;
};

/// All channels of all parts that are not deep. In files of several parts, a channel that belongs to no layer gets its
/// part's name for one (without the view, "left" or "right", that it may end with).
[[nodiscard]] std::vector<ImageChannel> exr_channels(OIIO::ImageInput& input);

/// Reads channels; each part that has some of them is decoded once, in bands of rows. Half, float and unsigned integers
/// give their values. Pixels of the display window that the file does not have stay as they are; others that it has are
/// left out. Throws Error, also when the parts differ in their display windows.
void read_exr(OIIO::ImageInput& input, const std::string& name, std::span<const ChannelRead> reads);

/// The colour of the file, or its first channels, at most four: see read_image. Throws Error.
[[nodiscard]] Image read_exr_color(OIIO::ImageInput& input, const std::string& name);

} // namespace hachure::assets
