#pragma once

#include <hachure/components/implicit_brush.h>

#include <cstdint>

namespace hachure {

/// What a field of noise depends on; brushes that agree in it share one.
struct BrushNoiseKey {
    BrushGrain grain = BrushGrain::solid;
    float size = 12.0f;      ///< of a grain: pixels, or metres
    bool world_size = false; ///< `size` is in metres
    float flatness = 1.0f;   ///< [0, 1], as ImplicitBrush::flatness
    std::uint32_t seed = 1;

    friend bool operator==(const BrushNoiseKey&, const BrushNoiseKey&) = default;
};

} // namespace hachure
