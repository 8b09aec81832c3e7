#pragma once

#include <hachure/runtime/assets/image.h>

/// Whether two pictures are alike. A lost line is a small error on average, so no figure here is a mean: lines are held
/// to a distance, tones to the worst percentile.
namespace hachure::picture {

struct PictureDifference {
    double max_difference = 0.0;     ///< largest difference of a channel, in 255ths
    double differing_fraction = 0.0; ///< of the pixels: those with a channel more than a step apart
    double flip_p99 = 0.0;           ///< 99th percentile of the FLIP error, rounding apart (`rounding_step`)
    double flip_max = 0.0;
    double line_distance = 0.0; ///< symmetric Hausdorff distance of the lines, pixels; infinite if one has none
    bool finite = true;         ///< neither picture holds NaN or infinity; if one does, nothing else is measured
};

/// What the same driver may do between two runs or two ways to its context.
inline constexpr double same_driver_step = 5.0; // 255ths

/// What rounding may do to a channel: pixels within it are one to FLIP.
inline constexpr double rounding_step = 1.0 + 1e-6; // 255ths

/// How pictures are compared.
struct CompareOptions {
    double step = same_driver_step; ///< 255ths; see PictureDifference::differing_fraction

    /// Of the pictures' size; null for none. Where its first channel is below one half, the pictures are not compared:
    /// `b` is taken to be as `a` there, and the pixel counts in no fraction or percentile.
    const assets::Image* mask = nullptr;
};

/// Compares pictures of 3 or more channels and one size: u8 as sRGB, f32 as values in [0, 1] that are already encoded.
/// Where a mask leaves no pixel to compare, they do not differ.
[[nodiscard]] PictureDifference compare_pictures(const assets::Image& a, const assets::Image& b,
                                                 const CompareOptions& options = {});

/// How two buffers of floats differ.
struct BufferDifference {
    double max_difference = 0.0;     ///< largest of a channel, in the buffer's own unit
    double differing_fraction = 0.0; ///< of the pixels: those with a channel more than the step apart
    bool finite = true;              ///< neither holds NaN or infinity; if one does, nothing else is measured
};

/// Compares f32 buffers of one shape value by value; `options.step` is in their own unit.
[[nodiscard]] BufferDifference compare_buffers(const assets::Image& a, const assets::Image& b,
                                               const CompareOptions& options);

} // namespace hachure::picture
