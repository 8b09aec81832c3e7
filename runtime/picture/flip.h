#pragma once

#include <hachure/runtime/assets/image.h>

#include <vector>

namespace hachure::picture {

/// The error map of LDR-FLIP (Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images") at its
/// default viewing distance of 67 pixels a degree, one value in [0, 1] per pixel: how visible the difference is to
/// someone who flips between the two. Colours are filtered by the eye's contrast sensitivity and compared in L*a*b*
/// with the Hunt effect (HyAB); differences of edges and points amplify that. Pictures as for compare_pictures.
[[nodiscard]] std::vector<float> flip_error(const assets::Image& a, const assets::Image& b);

} // namespace hachure::picture
