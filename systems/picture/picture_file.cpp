#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/picture/picture_file.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace hachure {
namespace {

void check_finite(const assets::Image& image, const std::string& file) {
    if (image.type != assets::PixelType::f32) return;
    const std::span values(image.f32(), image.pixels.size() / sizeof(float));
    const auto wrong = std::ranges::find_if(values, [](float value) { return !std::isfinite(value); });
    if (wrong == values.end()) return;
    const auto pixel = (wrong - values.begin()) / image.channels;
    throw Error(file, "has values that are not finite",
                "column " + std::to_string(pixel % image.width) + ", row " + std::to_string(pixel / image.width));
}

} // namespace

PictureFile::PictureFile(const std::string& file) : file_(file) {
    if (assets::is_video_name(file)) {
        video_.emplace(file);
        width_ = video_->width();
        height_ = video_->height();
    } else {
        const assets::ImageSize size = assets::read_upright_size(file);
        width_ = size.width;
        height_ = size.height;
    }
}

int PictureFile::frame_at(const Picture& picture, double seconds) const {
    if (!video_) return 0;
    const double time = double(picture.time_offset) + double(picture.speed) * seconds;
    if (!picture.loop) return video_->frame_at(time);
    // As in VideoFile::frame_at, so that a moment just before the end, as rounding leaves it, is the beginning.
    const double given = 0.1 / (video_->frames_per_second() > 0.0 ? video_->frames_per_second() : 30.0);
    const double length = video_->duration();
    return video_->frame_at(time - length * std::floor((time + given) / length));
}

assets::Image PictureFile::read(int frame) {
    assets::Image image = video_ ? video_->read_frame(frame) : assets::read_upright_image(file_);
    check_finite(image, file_);
    return image;
}

PictureFile& PictureFiles::open(Entity entity, const std::string& file) {
    const auto found = files.find(entity);
    if (found != files.end() && found->second.file() == file) return found->second;
    return files.insert_or_assign(entity, PictureFile(file)).first->second;
}

} // namespace hachure
