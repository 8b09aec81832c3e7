#pragma once

#include <hachure/systems/shade_strokes/shade_chains.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace hachure {

/// How much of their amplitude strokes keep where a surface bends more than it did when they were laid: chains and
/// their nodes stay as they are, and are drawn narrower. ShadeNarrowingJob finds it.
struct StrokeNarrowing {
    std::span<const float> shares{};          ///< per vertex of the mesh, in (0, 1]; or none: all of it everywhere
    std::span<const std::uint32_t> indices{}; ///< 3 per triangle of the mesh; where there are shares

    /// The share that a node keeps, as shaders/shade_strokes/ribs.comp has it: that of its middle.
    [[nodiscard]] float of(const ShadeNode& node) const {
        if (shares.empty()) return 1.0f;
        const SurfacePoint& middle = node.rib[rib_points / 2];
        const std::uint32_t* corner = &indices[3 * std::size_t{middle.triangle}];
        const float share = shares[corner[0]];
        return share + middle.u * (shares[corner[1]] - share) + middle.v * (shares[corner[2]] - share);
    }

    /// The share of the area between two nodes that their strokes keep.
    [[nodiscard]] double of(const ShadeNode& from, const ShadeNode& to) const {
        if (shares.empty()) return 1.0;
        const double a = from.amplitude, b = to.amplitude;
        return a + b > 0.0 ? (a * of(from) + b * of(to)) / (a + b) : 1.0;
    }
};

} // namespace hachure
