#pragma once

#include <hachure/runtime/assets/frame_writer.h>

/// What make_frame_writer chooses from for films.
namespace hachure::assets {

[[nodiscard]] std::unique_ptr<FrameSequenceWriter> make_gif_writer(const std::filesystem::path& file, FrameRate rate);
[[nodiscard]] std::unique_ptr<FrameSequenceWriter> make_mp4_writer(const std::filesystem::path& file, FrameRate rate);

} // namespace hachure::assets
