#pragma once

#include <cstddef>
#include <cstdint>

namespace hachure::gpu {

/// Texel formats the house uses; names follow OpenGL's sized internal formats.
enum class Format : std::uint8_t {
    r8,
    rg8,
    rgba8,
    srgb8_alpha8,
    rg16,
    rgba16,
    r16f,
    rg16f,
    rgba16f,
    r32f,
    rg32f,
    rgba32f,
    r32ui,
    rg32ui,
    depth32f,
    depth24,
};

/// Bytes of one texel as the driver is expected to store it.
[[nodiscard]] constexpr std::size_t bytes_per_texel(Format format) {
    switch (format) {
    case Format::r8:
        return 1;
    case Format::rg8:
    case Format::r16f:
        return 2;
    case Format::rgba8:
    case Format::srgb8_alpha8:
    case Format::rg16:
    case Format::rg16f:
    case Format::r32f:
    case Format::r32ui:
    case Format::depth32f:
    case Format::depth24:
        return 4;
    case Format::rgba16:
    case Format::rgba16f:
    case Format::rg32f:
    case Format::rg32ui:
        return 8;
    case Format::rgba32f:
        return 16;
    }
    return 0;
}

[[nodiscard]] constexpr bool is_depth(Format format) { return format == Format::depth32f || format == Format::depth24; }

/// Shape of a 2D texture.
struct TextureDesc {
    int width = 0;  ///< texels, >= 1
    int height = 0; ///< texels, >= 1
    Format format = Format::rgba8;
    int levels = 1;  ///< mip levels, >= 1
    int samples = 1; ///< above 1: multisampled, one level

    friend bool operator==(const TextureDesc&, const TextureDesc&) = default;

    /// Bytes of all levels and samples.
    [[nodiscard]] constexpr std::size_t bytes() const {
        std::size_t total = 0;
        int w = width, h = height;
        for (int level = 0; level < levels; ++level) {
            total += static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
            w = w > 1 ? w / 2 : 1;
            h = h > 1 ? h / 2 : 1;
        }
        return total * bytes_per_texel(format) * static_cast<std::size_t>(samples);
    }
};

} // namespace hachure::gpu
