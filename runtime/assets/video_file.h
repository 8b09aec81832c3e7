#pragma once

#include <hachure/runtime/assets/frame_rate.h>
#include <hachure/runtime/assets/image.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace hachure::assets {

/// Frames of a video (MP4, MOV, ...) or of an animated GIF, read through FFmpeg's libraries. Which frame is which
/// follows from the times that the file gives them: all of them are read, and each is the same however it was reached.
class VideoFile {
public:
    /// Reads all packets' times and decodes nothing. Throws Error when the file can't be read, has no frame, or ends
    /// before it says.
    explicit VideoFile(const std::filesystem::path& path);
    ~VideoFile();
    VideoFile(VideoFile&&) noexcept;
    VideoFile& operator=(VideoFile&&) noexcept;

    [[nodiscard]] int width() const;                ///< pixels
    [[nodiscard]] int height() const;               ///< pixels
    [[nodiscard]] int frame_count() const;          ///< >= 1
    [[nodiscard]] double frames_per_second() const; ///< on average; 0 when the file does not say

    /// The same as a fraction in lowest terms; none when the file does not say, or says one that is outside [1,
    /// max_frame_rate].
    [[nodiscard]] std::optional<FrameRate> frame_rate() const;

    /// When the last frame ends, seconds after the first begins. Frames of a file that does not say last 1/30 s.
    [[nodiscard]] double duration() const;

    /// The frame that shows at a moment, seconds after the first begins: the first one before it, the last one past the
    /// end. A tenth of a frame is given, since many files round their times.
    [[nodiscard]] int frame_at(double seconds) const;

    /// Frame `index` in [0, frame_count()), u8 RGB, sRGB. Reading in order is fast; jumping back seeks. Throws Error
    /// when it can't be decoded.
    [[nodiscard]] Image read_frame(int index);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// True for the extensions that are read as video: mp4, mov, avi, mkv, webm, mpg, m4v, ogv.
[[nodiscard]] bool is_video_name(const std::filesystem::path& path);

} // namespace hachure::assets
