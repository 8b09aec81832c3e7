#pragma once

#include <hachure/runtime/assets/layered_image.h>
#include <hachure/runtime/assets/numbered_files.h>

namespace hachure::assets {

/// Numbered images that are the frames of a film.
class ImageSequence {
public:
    /// Reads the headers of all of them. Throws Error as NumberedFiles and read_image_info do, and for the first file
    /// that has another size than the one with the lowest number, or lacks normals or depth that this one has.
    explicit ImageSequence(const std::filesystem::path& pattern);

    [[nodiscard]] const NumberedFiles& files() const { return files_; }
    [[nodiscard]] const ImageInfo& info() const { return info_; } ///< of the file with the lowest number

    /// The layers of frame `index`, as read_layers. Throws Error, also where the file has changed since its header was
    /// read.
    [[nodiscard]] LayeredImage read_frame(int index, WantedLayers wanted) const;

private:
    NumberedFiles files_;
    ImageInfo info_;
};

} // namespace hachure::assets
