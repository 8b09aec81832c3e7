#pragma once

#include <hachure/systems/shade_strokes/shade_settings.h>

#include <algorithm>

namespace hachure {

/// Half the width of strokes on a surface whose first principal curvature has that size (1/m), in the mesh's units;
/// `size`: of the model. The radius of curvature as far as the settings ask for that (section 2.3.3.1: "the inverse of
/// the interpolated curvature"), within their limits, which hold on planes. Always finite.
[[nodiscard]] inline double stroke_amplitude(const ShadeSettings& settings, double curvature, double size) {
    constexpr double usual_radius = 0.25; // over the model's size: there the amplitude is the set one
    const double by = std::clamp(settings.amplitude_by_curvature, 0.0f, 1.0f);
    const double radius = 1.0 / std::max(curvature * size, 1e-3); // over the model's size
    const double wanted = settings.amplitude * (1.0 - by + by * radius / usual_radius);
    const double least = settings.min_amplitude, most = std::max(settings.max_amplitude, settings.min_amplitude);
    return std::clamp(wanted, least, most) * size;
}

} // namespace hachure
