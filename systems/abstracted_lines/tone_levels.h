#pragma once

#include <cstddef>
#include <vector>

namespace hachure {

/// The blur for lines of a width: a Gaussian of half of it, which finds every bar of that width (recall 1.00; a third
/// of it .92, a sixth .84).
[[nodiscard]] constexpr double blur_sigma(double width) { return 0.5 * width; }

/// The widths, px, ascending, that a stack of blurred images is made for: one for one width; else from the narrowest to
/// the widest in steps of at most the root of two, between which lines blend their tones by variance.
[[nodiscard]] std::vector<double> stack_widths(double narrowest, double widest);

/// By how much each image of a stack blurs the one before it, px.
[[nodiscard]] std::vector<double> stack_steps(const std::vector<double>& widths);

/// How many texels to each side a blur looks at: 2.75 deviations, beyond which a 170th of a Gaussian lies.
[[nodiscard]] int blur_radius(double sigma);

/// Weights of a Gaussian for offsets 0, 1, ..., blur_radius(sigma); over both sides they sum to 1.
[[nodiscard]] std::vector<float> blur_weights(double sigma);

} // namespace hachure
