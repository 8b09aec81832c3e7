#pragma once

#include <hachure/runtime/assets/image_file.h>

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <memory>
#include <string>

/// OpenImageIO's end of reading images: what the readers of this folder share. Not for users of the folder.
namespace hachure::assets {

/// A file opened at its first part, with colours as it has them: OpenImageIO multiplies those of PNG files by alpha
/// unless told otherwise, which darkens what textures show where alpha is low, and is lossy. PNG files are checked first
/// (png_check.h). Throws Error, also where there is no file.
[[nodiscard]] std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& path);

/// The same from memory; see read_image_memory. `memory` must outlive the result.
[[nodiscard]] std::unique_ptr<OIIO::ImageInput> open_image(const std::string& name, OIIO::Filesystem::IOProxy& memory);

/// First line of one of OpenImageIO's faults, without the file's name, which ours begin with.
[[nodiscard]] std::string image_fault(std::string message, const std::string& name);

/// Throws Error for a part without pixels, with deep ones, and for one that is larger than max_image_pixels.
void check_image_shape(const OIIO::ImageSpec& spec, const std::string& name);

/// Whether it is an OpenEXR file, whatever it is called.
[[nodiscard]] bool is_exr(const OIIO::ImageInput& input);

/// Pixels of the image that is open: of an EXR its display window, of which the file may hold a part. Throws Error for
/// a shape that can't be read.
[[nodiscard]] ImageSize image_size(const OIIO::ImageInput& input, const std::string& name);

/// As orientation.h has it.
[[nodiscard]] int orientation_of(const OIIO::ImageSpec& spec);

} // namespace hachure::assets
