#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <cstdint>

namespace hachure {

/// How much work goes into finding lines: docs/abstracted-lines-accuracy.md has the
/// chart that they were chosen from.
enum class ToneQuality { standard, fast, accurate, custom };

enum class ToneBlur {
    exact,     ///< every texel of the Gaussian, in two dimensions: the reference
    separable, ///< along rows, then along columns
    recursive, ///< a recursive filter along rows and columns: one cost for every width
    half,      ///< separable, at half the resolution, or less, where two texels of a deviation are left
    kawase,    ///< down and up a pyramid (dual Kawase)
};

/// The format of tones. Sixteen bits between 0 and 1 are as good as floats; halves of those have steps of 1/2048 where
/// it is bright, which moves wide, faint lines by up to a tenth of a pixel.
enum class ToneStorage { rg16, rg16f, rg8, rg32f };

/// Where the fitted parabola takes its samples from.
enum class ToneTaps {
    square,   ///< 3 x 3, all alike, as in the paper
    weighted, ///< 3 x 3, weights 1, 4, 1 across
    wide,     ///< 5 x 5
};

/// How the tone image is made and searched, on the camera's entity, or defaults. All but `quality` count for `custom`.
struct ToneImage {
    ToneQuality quality = ToneQuality::standard;
    std::int32_t samples = 1;
    ToneStorage storage = ToneStorage::rg16;
    ToneBlur blur = ToneBlur::recursive;
    ToneTaps taps = ToneTaps::weighted;
    std::int32_t iterations = 5;

    friend bool operator==(const ToneImage&, const ToneImage&) = default;
};

inline void reflect(TypeBuilder<ToneImage>& type) {
    type.name("tone_image").doc("how the image that abstracted lines are found in is made and searched");
    type.field("quality", &ToneImage::quality)
        .doc("how much work goes into finding lines; custom for the fields below")
        .options({"standard", "fast", "accurate", "custom"});
    type.field("samples", &ToneImage::samples)
        .doc("samples of a pixel of the tone image: 1, or 4 for features below a pixel")
        .range(1, 4);
    type.field("storage", &ToneImage::storage).doc("format of tones").options({"rg16", "rg16f", "rg8", "rg32f"});
    type.field("blur", &ToneImage::blur)
        .doc("how the tone image is blurred")
        .options({"exact", "separable", "recursive", "half", "kawase"});
    type.field("taps", &ToneImage::taps)
        .doc("samples that a parabola is fitted to: 3 x 3, 3 x 3 weighted, 5 x 5")
        .options({"square", "weighted", "wide"});
    type.field("iterations", &ToneImage::iterations).doc("fits on the way to a line, at most").range(1, 8);
}

} // namespace hachure
