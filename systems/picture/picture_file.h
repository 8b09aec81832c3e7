#pragma once

#include <hachure/components/picture.h>
#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/runtime/ecs/entity.h>

#include <map>
#include <optional>
#include <string>

namespace hachure {

/// An image or, told by its extension, a video on disk.
class PictureFile {
public:
    /// Reads the header. Throws Error when there is none that can be read.
    explicit PictureFile(const std::string& file);

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] int width() const { return width_; }   ///< pixels
    [[nodiscard]] int height() const { return height_; } ///< pixels

    /// The frame that a picture of this file shows at second `seconds` of the scene; 0 for an image.
    [[nodiscard]] int frame_at(const Picture& picture, double seconds) const;

    /// Decodes a frame: u8 sRGB, or f32 linear and finite. In order is fast. Throws Error.
    [[nodiscard]] assets::Image read(int frame);

private:
    std::string file_;
    std::optional<assets::VideoFile> video_;
    int width_ = 0, height_ = 0;
};

/// The open files of the world's pictures, by entity: each video is read at its own place. A resource.
struct PictureFiles {
    std::map<Entity, PictureFile> files;

    /// The file of an entity, opened when it is not. Throws Error.
    PictureFile& open(Entity entity, const std::string& file);
};

} // namespace hachure
