#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace hachure {

/// A Gaussian as a recursive filter of third order (van Vliet, Young & Verbeek 1998): every sample costs the same
/// however wide the Gaussian is. y[n] = gain x[n] + feedback . (y[n-1], y[n-2], y[n-3]), along the samples; then the
/// same back along the result.
struct RecursiveGaussian {
    double gain = 1.0;
    glm::dvec3 feedback{0.0};
    /// Where the way back starts: beyond the last sample x everything is x. `tail` takes how far the last three results
    /// of the way there (the last first) are from x to how far those of the way back are, one, two and three samples
    /// beyond the end.
    glm::dmat3 tail{0.0};
};

/// `deviation` in samples, from .5 on: the variance is exact.
[[nodiscard]] RecursiveGaussian recursive_gaussian(double deviation);

} // namespace hachure
