#pragma once

#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/texture_desc.h>
#include <hachure/systems/implicit_brush/footprint.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace hachure {

struct TipBitmap;

/// Noise that takes from the paint, as rough canvas.
struct CanvasNoise {
    std::uint32_t texture = 0; ///< of the stamps' size; -1 takes nothing, 1 takes `amount`
    glm::vec4 channel{1.0f, 0.0f, 0.0f, 0.0f};
    float amount = 0.0f; ///< 0 to 1
};

/// The stamps of one brush, from which StampConvolver paints its lines: the convolution of section 4.1 and its tone
/// mapping. Textures are ids of the frame graph's back end, all of one size; pixels count from the bottom left.
///
/// Pixel y adds w(y) b(x - y) to pixel x (equation 3), scaled by `radius` over its stamp's own radius, so that lines
/// don't fade where they are thinner. Pixels whose weight is 0, or whose stamp has values that are no numbers, add
/// nothing. Colours beyond 16 are cut.
struct ConvolveJob {
    BrushMethod method = BrushMethod::automatic;

    std::uint32_t places = 0; ///< middle of the stamp from the pixel's centre, px x, y; radius, px; angle, rad
    std::uint32_t inks = 0;   ///< colour times weight; weight, 0 to 1
    gpu::Rect stamps;         ///< the pixels that may stamp; what other texels hold does not matter

    /// Set when all stamps have that place, radius and angle: `places` is not read.
    std::optional<glm::vec4> same_place = {};
    /// Set when all have that colour: sums are of one channel.
    std::optional<glm::vec3> same_color = {};

    Footprint footprint = {};
    const TipBitmap* bitmap = nullptr; ///< of BrushTip::bitmap
    float radius = 1.0f;               ///< of a stamp as the brush has it, px; the white point is of this size
    float largest_radius = 1.0f;       ///< px; larger stamps are cut to it
    float largest_shift = 0.0f;        ///< of middles from their pixels' centres, px

    float peak = 1.0f;     ///< the largest weight there can be
    float contrast = 8.0f; ///< p of the tone mapping, at least 1
    float opacity = 1.0f;  ///< of the lines
    CanvasNoise canvas = {};

    /// Of the sums that splats are added up in: rgba32f, or rgba16f, which is off by up to 1e-2.
    gpu::Format sums = gpu::Format::rgba32f;

    std::uint32_t target = 0; ///< what lines are laid over, premultiplied

    /// Textures that it works in, for stamps of a picture of that size.
    [[nodiscard]] std::vector<gpu::TextureDesc> scratch(int width, int height) const;

    /// Whether sums are of opacity alone: all stamps have one colour, and the tip has none of its own.
    [[nodiscard]] bool sums_opacity() const;

    /// Whether stamps may be added up that way.
    [[nodiscard]] bool may_use(BrushMethod which) const;

    /// How far from its pixel a stamp has ink, px.
    [[nodiscard]] int reach() const;

    /// The part of a picture that gets ink.
    [[nodiscard]] gpu::Rect painted(int width, int height) const;
};

} // namespace hachure
