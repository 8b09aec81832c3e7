#pragma once

#include <hachure/runtime/assets/image.h>

#include <array>
#include <filesystem>
#include <vector>

namespace hachure::test {

/// A decoded frame of a film. In `planes` are the values as they are stored: Y', Cb, Cr of a video, row by row without
/// padding; of a GIF nothing.
struct FilmFrame {
    double begins = 0;   ///< seconds
    double lasts = 0;    ///< seconds; 0 when the film does not say
    assets::Image image; ///< u8 RGB
    std::array<std::vector<std::uint8_t>, 3> planes;
};

/// What a player sees of a GIF or MP4, decoded with FFmpeg. Videos become RGB by the formulas of BT.709 in double
/// precision, with every chroma value for its four pixels.
struct Film {
    int width = 0, height = 0;                                       ///< pixels
    double duration = 0;                                             ///< seconds
    int matrix = 0, primaries = 0, curve = 0, range = 0, siting = 0; ///< FFmpeg's AVCOL_*, AVCHROMA_LOC_*
    int codec = 0;                                                   ///< AV_CODEC_ID_*
    int pixel_format = 0;                                            ///< AV_PIX_FMT_*
    std::vector<FilmFrame> frames;
};

/// Throws std::runtime_error when FFmpeg can't read it.
Film read_film(const std::filesystem::path& file);

} // namespace hachure::test
