#pragma once

#include <hachure/components/shade_strokes.h>
#include <hachure/systems/shade_strokes/shade_settings.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hachure {

/// What the CPU needs of the component, made sound: a component may hold any number that a script wrote.
[[nodiscard]] inline ShadeSettings shade_settings(const ShadeStrokes& strokes) {
    // std::max is its first argument where the second is no number.
    const auto at_least = [](float least, float value) { return std::max(least, value); };
    return {.amplitude = at_least(1e-4f, strokes.amplitude),
            .amplitude_by_curvature = std::clamp(at_least(0.0f, strokes.amplitude_by_curvature), 0.0f, 1.0f),
            .min_amplitude = at_least(1e-4f, strokes.min_amplitude),
            .max_amplitude = at_least(1e-4f, strokes.max_amplitude),
            .density = at_least(0.01f, strokes.density),
            .chain_turn = std::clamp(at_least(0.0f, strokes.chain_turn), 0.0f, 3.14159265f),
            .trueness = std::clamp(at_least(0.0f, strokes.trueness), 0.0f, 1.0f),
            .dead_band = std::clamp(at_least(0.001f, strokes.dead_band), 0.001f, 0.5f),
            .seed = strokes.seed};
}

/// The tone curve of the component, for lights that are relative to one of the intensity `strongest`.
[[nodiscard]] inline ShadeTone shade_tone(const ShadeStrokes& strokes, float strongest = 1.0f) {
    // So much of what the curve means by 1 is a relative light of 1.
    const float given = strokes.full_light > 0.0f ? std::max(1e-6f, strongest / strokes.full_light) : 1.0f;
    return {.full_shade = std::max(0.0f, strokes.full_shade) / given,
            .no_shade = std::max(0.0f, strokes.no_shade) / given,
            .contrast = std::max(0.01f, strokes.contrast)};
}

/// Strokes that flicker jump whenever this is another number; 0 for those that do not.
[[nodiscard]] inline std::uint32_t flicker_tick(const ShadeStrokes& strokes, float time) {
    if (!(strokes.flicker > 0.0f)) return 0;
    const double tick = std::floor(double{time} * std::max(0.0f, strokes.flicker_rate));
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(tick)) * 0x9e3779b9u + strokes.seed;
}

} // namespace hachure
