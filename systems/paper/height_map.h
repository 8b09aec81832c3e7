#pragma once

#include <hachure/components/paper.h>
#include <hachure/runtime/assets/image.h>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace hachure {

/// The relief of a sheet: a tile that repeats, a texel a pixel.
struct HeightMap {
    int width = 0, height = 0;        ///< texels
    std::vector<std::uint8_t> texels; ///< rows from the top; each of the 256 values is as frequent as any other
};

inline constexpr int max_paper_side = 4096; ///< texels, of a tile from a file

/// Heights by their rank: then what share of a sheet lies above a height is known, and tones can be kept
/// (transfer.glsl). Equal heights are told apart by chance, always the same. `heights` has width * height of them, rows
/// from the top.
[[nodiscard]] HeightMap ranked_heights(int width, int height, const std::vector<float>& heights);

/// Heights of a picture, its brightness, with `scale` pixels to a texel; its right edge goes on at its left, its lower
/// at its upper. `file` names it in the Error that is thrown where values are not finite or all the same, or where the
/// tile would be larger than `max_paper_side`.
[[nodiscard]] HeightMap picture_heights(const assets::Image& image, float scale, const std::filesystem::path& file);

/// What a sheet looks like.
struct SheetKey {
    PaperKind kind = PaperKind::tooth; ///< counts without a file
    std::uint32_t seed = 0;            ///< likewise
    std::string file;
    float scale = 1.0f; ///< pixels

    friend bool operator==(const SheetKey&, const SheetKey&) = default;
};

/// Throws Error, which names the file, when there is none, it can't be read, or as `picture_heights` does.
[[nodiscard]] HeightMap make_sheet(const SheetKey& key);

} // namespace hachure
