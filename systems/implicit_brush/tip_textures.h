#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/gpu/texture.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hachure {

/// The form of a bitmap tip: premultiplied colour and opacity, 4 values a pixel, the top row first.
struct TipImage {
    int width = 0, height = 0;
    bool colored = false; ///< its colours replace the ink's
    std::vector<float> pixels;

    /// What is over all as much opacity.
    [[nodiscard]] float mean() const;
};

inline constexpr int max_tip_size = 1024;

/// The tip of a picture: its alpha where it has some, else its darkness; its colours, in linear light, where it has
/// alpha and they are not all grey. Throws Error naming the file for values that are not finite, and for a tip that is
/// clear all over.
[[nodiscard]] TipImage tip_of(const assets::Image& image, const std::filesystem::path& file);

/// A bitmap tip on the GPU, with mipmaps.
struct TipBitmap {
    gpu::Texture texture; ///< premultiplied
    bool colored = false;
    float mean = 1.0f; ///< Footprint::bitmap_mean
};

[[nodiscard]] TipBitmap make_tip_bitmap(const TipImage& image);

/// Those of a world, each made once.
class TipTextures {
public:
    /// Of a picture's file. Throws Error, which names the file, when there is none, it is too large or it is no tip.
    [[nodiscard]] const TipBitmap& get(const std::string& file);

private:
    std::map<std::string, TipBitmap> textures_;
};

} // namespace hachure
