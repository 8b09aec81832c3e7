#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/gpu/texture.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hachure {

/// Where there is ink on a stroke: 0 none, 1 all that there can be. From left to right along the stroke, the top row on
/// its left.
struct StrokeInk {
    int width = 0, height = 0;
    std::vector<float> coverage; ///< row by row, the top row first

    /// What is over all as much ink.
    [[nodiscard]] float mean() const;
};

inline constexpr int max_stroke_columns = 4096, max_stroke_rows = 1024;

/// The ink of a picture: its alpha where it has some, else its darkness. Throws Error naming the file for values that
/// are not finite.
[[nodiscard]] StrokeInk ink_of(const assets::Image& image, const std::filesystem::path& file);

/// Dry ink on rough paper: streaks along the stroke, gaps towards its rim.
[[nodiscard]] StrokeInk dry_ink();

/// A texture of strokes on the GPU: one channel with mipmaps, mirrored along strokes.
struct StrokeTexture {
    gpu::Texture texture;
    float mean = 1.0f;
};

/// Those of a world, each made once.
class StrokeTextures {
public:
    /// Of a picture's file, or dry ink for an empty name. Throws Error, which names the file, when there is none or it
    /// is too large.
    [[nodiscard]] const StrokeTexture& get(const std::string& file);

private:
    std::map<std::string, StrokeTexture> textures_;
};

} // namespace hachure
