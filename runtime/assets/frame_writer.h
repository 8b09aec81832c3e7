#pragma once

#include <hachure/runtime/assets/frame_rate.h>
#include <hachure/runtime/assets/image.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hachure::assets {

/// What frames are written as.
enum class FrameFormat : std::uint8_t {
    png, ///< a file per frame, u8
    exr, ///< a file per frame, f32
    gif, ///< one file, u8 RGB: 255 colours a frame, repeats for ever
    mp4, ///< one file, u8 RGB: H.264
    svg, ///< a file per frame: lines and no image (svg_file.h)
};

/// The format of a file's extension; nothing when it is none of .png, .exr, .gif, .mp4, .svg.
[[nodiscard]] std::optional<FrameFormat> frame_format(const std::filesystem::path& file);

/// Whether all frames go into one file.
[[nodiscard]] inline bool is_film(FrameFormat format) {
    return format == FrameFormat::gif || format == FrameFormat::mp4;
}

/// Most frames per second of a GIF: its times are whole hundredths of a second, and browsers slow down what is shown
/// for less than two.
inline constexpr int max_gif_rate = 50;

/// Writes the frames of a sequence, one after the other. The same frames give the same bytes on any machine. Every file
/// appears whole or not at all; a writer that is destroyed before `finish` takes its film with it.
class FrameSequenceWriter {
public:
    virtual ~FrameSequenceWriter() = default;

    /// The next frame; numbers (0 or more) ascend. Films take u8 RGB images of one size, PNG u8, EXR f32. Throws Error
    /// naming the file.
    virtual void write(std::int64_t number, const Image& image) = 0;

    /// After the last frame; a film has at least one. The film is in its place when this returns. Throws Error.
    virtual void finish() = 0;
};

/// What a writer needs to know of its frames.
struct FrameWriterOptions {
    FrameRate rate;                         ///< of films; a GIF's is at most max_gif_rate
    std::vector<std::string> channel_names; ///< of EXR files, one per channel
};

/// A writer for `file`, whose extension is one of frame_format's for images. PNG and EXR names may number frames (see
/// frame_pattern.h); without a '#', each frame replaces the one before. Throws Error when `file` can't be written.
///
/// MP4: H.264 (x264, crf 18), yuv420p in limited range with the matrix and primaries of BT.709 and the transfer curve
/// of sRGB, all of it tagged; the index comes first. An odd width or height gets one more column or row, a copy of the
/// last, as 4:2:0 counts pixels in pairs.
[[nodiscard]] std::unique_ptr<FrameSequenceWriter> make_frame_writer(const std::filesystem::path& file,
                                                                     const FrameWriterOptions& options);

} // namespace hachure::assets
