#include <hachure/components/picture.h>
#include <hachure/editor/input_film.h>
#include <hachure/editor/open_input.h>
#include <hachure/runtime/assets/numbered_files.h>
#include <hachure/runtime/assets/video_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace hachure {
namespace {

/// The field's range is that of rates.
assets::FrameRate sequence_rate(std::span<const Assignment> assignments) {
    double rate = double(Picture{}.frames_per_second);
    for (const Assignment& assignment : assignments)
        if (assignment.field->path == "picture.frames_per_second") rate = std::get<double>(assignment.value);
    return assets::parse_frame_rate(fmt::format("{:.6f}", rate)).value_or(assets::FrameRate{});
}

} // namespace

std::int64_t InputFilm::frames_at(const assets::FrameRate& other) const {
    // A tenth of a frame is given, as where frames are looked up by their time.
    const double frames = std::ceil(seconds * other.frames / other.seconds - 0.1);
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(frames));
}

std::optional<InputFilm> input_film(const std::filesystem::path& input, std::span<const Assignment> assignments) {
    if (!is_picture_name(input)) return {};
    if (assets::is_video_name(input)) {
        const assets::VideoFile video(input);
        return InputFilm{video.frame_rate().value_or(assets::FrameRate{}), video.duration()};
    }
    if (!assets::is_numbered_name(input)) return {};
    const assets::FrameRate rate = sequence_rate(assignments);
    return InputFilm{rate, rate.time_of(assets::NumberedFiles(input).frame_count())};
}

} // namespace hachure
