#pragma once

#include <hachure/runtime/assets/image.h>

#include <gtest/gtest.h>

#include <vector>

/// Whether two pictures are alike. A lost line is a small error on average, so no figure here is a mean: lines are held
/// to a distance, tones to the worst percentile.
namespace hachure::test {

struct PictureDifference {
    double max_difference = 0.0;     ///< largest difference of a channel, in 255ths
    double differing_fraction = 0.0; ///< of the pixels: those with a channel more than `same_driver_step` apart
    double flip_p99 = 0.0;           ///< 99th percentile of the FLIP error
    double flip_max = 0.0;
    double line_distance = 0.0; ///< symmetric Hausdorff distance of the lines, pixels; infinite if one has none
    bool finite = true;         ///< neither picture holds NaN or infinity
};

/// What the same driver may do between two runs or two ways to its context.
inline constexpr double same_driver_step = 5.0; // 255ths

/// Compares pictures of 3 or more channels and one size: u8 as sRGB, f32 as values in [0, 1] that are already encoded.
[[nodiscard]] PictureDifference compare_pictures(const assets::Image& a, const assets::Image& b);

/// At most 5/255 apart but for .1 % of the pixels, FLIP p99 <= .05, lines within 2 px of each other, all finite.
[[nodiscard]] ::testing::AssertionResult same_driver_gate(const assets::Image& a, const assets::Image& b);

/// The error map of LDR-FLIP (Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images") at its
/// default viewing distance of 67 pixels a degree, one value in [0, 1] per pixel: how visible the difference is to
/// someone who flips between the two. Colours are filtered by the eye's contrast sensitivity and compared in L*a*b*
/// with the Hunt effect (HyAB); differences of edges and points amplify that.
[[nodiscard]] std::vector<float> flip_error(const assets::Image& a, const assets::Image& b);

/// How far a line pixel of one picture is from the nearest of the other, at most, both ways. A pixel is on a line when
/// all its channels are below 64/255; its partner needs only be below 96/255, so that a pixel at the very threshold
/// does not decide. Infinite when only one picture has lines.
[[nodiscard]] double line_distance(const assets::Image& a, const assets::Image& b);

/// Squared distance in pixels from every pixel to the nearest one that is set, exact (Felzenszwalb & Huttenlocher
/// 2012); infinite where none is set. Row by row.
[[nodiscard]] std::vector<double> squared_distances(const std::vector<bool>& set, int width, int height);

} // namespace hachure::test
