#pragma once

#include <hachure/components/picture.h>
#include <hachure/runtime/assets/image_sequence.h>
#include <hachure/runtime/assets/layered_image.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/runtime/ecs/entity.h>

#include <map>
#include <optional>
#include <set>
#include <string>

namespace hachure {

/// An image, numbered images or, told by its extension, a video on disk.
class PictureFile {
public:
    /// Reads the header, of numbered images those of all. Throws Error when there is none that can be read.
    explicit PictureFile(const std::string& file);

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] int width() const { return info_.size.width; }   ///< pixels
    [[nodiscard]] int height() const { return info_.size.height; } ///< pixels
    [[nodiscard]] bool has_normal() const { return !info_.layers.normal.empty(); }
    [[nodiscard]] bool has_depth() const { return !info_.layers.depth.empty(); }

    /// Of numbered images, else null.
    [[nodiscard]] const assets::NumberedFiles* numbered() const { return sequence_ ? &sequence_->files() : nullptr; }

    /// The frame that a picture of this file shows at second `seconds` of the scene; 0 for an image. Where a number of
    /// a sequence is missing it is the frame before.
    [[nodiscard]] int frame_at(const Picture& picture, double seconds) const;

    /// Decodes a frame: colours u8 sRGB, or f32 linear and finite. In order is fast. Throws Error.
    [[nodiscard]] assets::LayeredImage read(int frame, assets::WantedLayers wanted);

private:
    std::string file_;
    std::optional<assets::VideoFile> video_;
    std::optional<assets::ImageSequence> sequence_;
    assets::ImageInfo info_;
};

/// The open files of the world's pictures, by entity: each video is read at its own place. A resource.
struct PictureFiles {
    std::map<Entity, PictureFile> files;
    std::set<std::string> warned; ///< sequences of which a missing frame was told

    /// The file of an entity, opened when it is not. Warns of a sequence that lacks frames, once. Throws Error.
    PictureFile& open(Entity entity, const std::string& file);
};

} // namespace hachure
