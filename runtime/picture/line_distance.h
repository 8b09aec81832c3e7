#pragma once

#include <hachure/runtime/assets/image.h>

#include <vector>

namespace hachure::picture {

/// How far a line pixel of one picture is from the nearest of the other, at most, both ways. A pixel is on a line when
/// all its channels are below 64/255; its partner needs only be below 96/255, so that a pixel at the very threshold
/// does not decide. Infinite when only one picture has lines. Pictures as for compare_pictures.
[[nodiscard]] double line_distance(const assets::Image& a, const assets::Image& b);

/// Whether each pixel is on a line, as `line_distance` sees it. Row by row.
[[nodiscard]] std::vector<bool> line_pixels(const assets::Image& image);

/// Squared distance in pixels from every pixel to the nearest one that is set, exact (Felzenszwalb & Huttenlocher
/// 2012); infinite where none is set. Row by row.
[[nodiscard]] std::vector<double> squared_distances(const std::vector<bool>& set, int width, int height);

} // namespace hachure::picture
