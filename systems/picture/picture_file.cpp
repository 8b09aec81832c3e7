#include <hachure/runtime/app/log.h>
#include <hachure/runtime/assets/frame_pattern.h>
#include <hachure/systems/picture/picture_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

/// Of a frame's length, so that a moment just before a frame, as rounding leaves it, is in it (VideoFile::frame_at).
constexpr double given_frames = 0.1;

int video_frame_at(const assets::VideoFile& video, const Picture& picture, double time) {
    if (!picture.loop) return video.frame_at(time);
    const double given = given_frames / (video.frames_per_second() > 0.0 ? video.frames_per_second() : 30.0);
    const double length = video.duration();
    return video.frame_at(time - length * std::floor((time + given) / length));
}

int sequence_frame_at(const assets::ImageSequence& sequence, const Picture& picture, double time) {
    const double count = sequence.files().frame_count();
    double frame = std::floor(time * double(picture.frames_per_second) + given_frames);
    if (picture.loop) frame -= count * std::floor(frame / count);
    return sequence.files().shown_frame(static_cast<int>(std::clamp(frame, 0.0, count - 1.0)));
}

/// The lowest number that is missing, of files that lack some.
std::int64_t first_missing(const assets::NumberedFiles& files) {
    const auto gap = std::ranges::adjacent_find(files.numbers(), [](auto a, auto b) { return b > a + 1; });
    return *gap + 1;
}

void warn_of_missing(const assets::NumberedFiles& files) {
    const std::string first = assets::frame_file(files.pattern(), first_missing(files)).filename().string();
    log_warning(fmt::format("{}: frames that are missing ({} of {}, {}{}) show the one before",
                            files.pattern().string(), files.missing(), files.frame_count(), first,
                            files.missing() == 1 ? "" : " the first"));
}

} // namespace

PictureFile::PictureFile(const std::string& file) : file_(file) {
    if (assets::is_video_name(file)) {
        video_.emplace(file);
        info_.size = {video_->width(), video_->height()};
    } else if (assets::is_numbered_name(file)) {
        info_ = sequence_.emplace(file).info();
    } else {
        info_ = assets::read_image_info(file);
    }
}

int PictureFile::frame_at(const Picture& picture, double seconds) const {
    const double time = double(picture.time_offset) + double(picture.speed) * seconds;
    if (video_) return video_frame_at(*video_, picture, time);
    return sequence_ ? sequence_frame_at(*sequence_, picture, time) : 0;
}

assets::LayeredImage PictureFile::read(int frame, assets::WantedLayers wanted) {
    if (sequence_) return sequence_->read_frame(frame, wanted);
    if (!video_) return assets::read_layers(file_, wanted);
    assets::LayeredImage image;
    if (wanted.color) image.color = video_->read_frame(frame);
    return image;
}

PictureFile& PictureFiles::open(Entity entity, const std::string& file) {
    const auto found = files.find(entity);
    if (found != files.end() && found->second.file() == file) return found->second;
    PictureFile& opened = files.insert_or_assign(entity, PictureFile(file)).first->second;
    const assets::NumberedFiles* numbered = opened.numbered();
    if (numbered && numbered->missing() > 0 && warned.insert(file).second) warn_of_missing(*numbered);
    return opened;
}

} // namespace hachure
