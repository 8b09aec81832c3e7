#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/gpu/texture.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace hachure {

/// A ramp as shaders/toon/tones.glsl reads it: sums along rows, so that the mean over any stretch of tones is a
/// difference of two of them.
struct RampSums {
    int columns = 0;           ///< of the ramp; a row has one texel more
    int rows = 0;              ///< row 0 is for no detail: the bottom of the picture
    std::vector<float> texels; ///< RGBA, rows * (columns + 1), linear; texel x sums those left of it, over `columns`
};

inline constexpr int max_ramp_columns = 4096, max_ramp_rows = 1024;

/// Colours of 8-bit pictures are sRGB, those of float ones linear. Throws Error, which names the file, for values that
/// are not finite.
[[nodiscard]] RampSums sum_ramp(const assets::Image& image, const std::filesystem::path& file);

/// Reads a ramp's picture. Throws Error when there is none, or it is too large.
[[nodiscard]] RampSums read_ramp(const std::filesystem::path& file);

/// The ramps of a world on the GPU: each is read once, and shared.
class ToonRamps {
public:
    /// Throws Error as `read_ramp` does.
    [[nodiscard]] const gpu::Texture& texture(const std::string& file);

private:
    std::map<std::string, gpu::Texture> textures_;
};

} // namespace hachure
