#pragma once

#include <hachure/components/implicit_brush.h>

namespace hachure {

/// What an extraction of a feature depends on; brushes that agree in it share one.
struct FeatureKey {
    BrushFeature feature = BrushFeature::contours;
    BrushSource source = BrushSource::surface; ///< `luminance` for luminance edges, `surface` for contours and edges
    int diffusion = 0;                         ///< steps
    float window = 6.0f;                       ///< half the length of a profile; pixels, or metres
    bool world_window = false;                 ///< `window` is in metres

    friend bool operator==(const FeatureKey&, const FeatureKey&) = default;
};

} // namespace hachure
