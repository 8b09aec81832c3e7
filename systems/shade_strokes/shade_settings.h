#pragma once

#include <cstdint>

namespace hachure {

/// How chains are laid: what of the component ShadeStrokes the CPU needs. Lengths are over the model's size (the
/// diagonal of its bounds), so that they suit a model whatever its units.
struct ShadeSettings {
    float amplitude = 0.028f;            ///< half the width of a chain's strokes; positive
    float amplitude_by_curvature = 0.3f; ///< in [0, 1]: how much that follows the radius of the surface's curvature
    float min_amplitude = 0.012f, max_amplitude = 0.04f; ///< positive
    float density = 0.6f;                                ///< shade of what strokes at alpha 1 cover; positive
    float chain_turn = 1.6f;       ///< radians, in [0, pi]: how far the normal may turn along a chain, end to end
    float trueness = 0.9f;         ///< in [0, 1]: 1 follows curvature, 0 any direction
    float dead_band = 0.0025f;     ///< shade in (0, 1): |needed - delivered| that is left as it is
    float rib_deviation = 0.0005f; ///< how far the patch between two nodes may leave the surface: half a line's width
    std::uint64_t seed = 1;

    friend bool operator==(const ShadeSettings&, const ShadeSettings&) = default;
};

/// How much shade a light calls for.
struct ShadeTone {
    float full_shade = 0.0f; ///< light in [0, 1] up to which shade is full
    float no_shade = 0.85f;  ///< light from which there is none; above `full_shade`
    float contrast = 1.0f;   ///< exponent of the way between; positive: above 1 keeps shade to the dark

    friend bool operator==(const ShadeTone&, const ShadeTone&) = default;
};

} // namespace hachure
