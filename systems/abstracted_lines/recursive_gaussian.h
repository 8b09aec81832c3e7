#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

namespace hachure {

/// A Gaussian as a recursive filter of third order (van Vliet, Young & Verbeek 1998): every sample costs the same
/// however wide the Gaussian is. Along the samples x, then the same back along the result:
///
///     d[n] = gain (x[n] - y[n-1]) + keep . (d[n-1], d[n-2])
///     y[n] = y[n-1] + d[n]
///
/// This is y[n] = gain x[n] + feedback . (y[n-1], y[n-2], y[n-3]) in differences. There the feedback of a wide Gaussian
/// is nearly (3, -3, 1), so that floats lose what it is all about: at a deviation of 32 samples each way puts a flat
/// tone off by a thousandth. In differences the sum is 1 however numbers are rounded: what is flat stays so, bit for
/// bit, and a shape on a flat ground comes out the same wherever it is.
struct RecursiveGaussian {
    double gain = 1.0;
    glm::dvec2 keep{0.0};
    /// Where the way back starts: beyond the last sample x everything is x. `tail` takes (y - x, d, d of the sample
    /// before) at the end of the way there to the same of the way back, one sample beyond the end.
    glm::dmat3 tail{0.0};
};

/// `deviation` in samples, from .5 on: the variance is exact.
[[nodiscard]] RecursiveGaussian recursive_gaussian(double deviation);

} // namespace hachure
