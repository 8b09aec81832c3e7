#pragma once

#include <hachure/runtime/assets/frame_rate.h>
#include <hachure/runtime/assets/image.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace hachure::assets {

/// Frames of a video (MP4, MOV, ...) or of an animated image, read through OpenImageIO's FFmpeg reader.
class VideoFile {
public:
    /// Throws Error when the file can't be read or has no frame.
    explicit VideoFile(const std::filesystem::path& path);
    ~VideoFile();
    VideoFile(VideoFile&&) noexcept;
    VideoFile& operator=(VideoFile&&) noexcept;

    [[nodiscard]] int width() const;                ///< pixels
    [[nodiscard]] int height() const;               ///< pixels
    [[nodiscard]] int frame_count() const;          ///< >= 1
    [[nodiscard]] double frames_per_second() const; ///< 0 when the file does not say

    /// The same as a fraction in lowest terms; none when the file does not say, or says one that is outside [1,
    /// max_frame_rate].
    [[nodiscard]] std::optional<FrameRate> frame_rate() const;

    /// Frame `index` in [0, frame_count()), u8 RGB. Reading in order is fast; jumping back seeks.
    [[nodiscard]] Image read_frame(int index);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// True for the extensions that are read as video: mp4, mov, avi, mkv, webm, mpg, m4v, ogv.
[[nodiscard]] bool is_video_name(const std::filesystem::path& path);

} // namespace hachure::assets
