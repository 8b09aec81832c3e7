#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace hachure {

/// The level of detail structure (Sorman & Hult 2005, section 2.2.2): random zigzags of 256 points that go on from
/// their end at their begin. A chain is drawn along one of them, from a random point on; one unit of length is the mean
/// distance of points. Stroke ends across the chain (the paper's LODU) are spread evenly over [-1, 1] among all points
/// and among every 2nd, 4th, ... of them, so that each level is as dark as the others.
struct ZigzagTables {
    static constexpr std::size_t sets = 5;
    static constexpr std::size_t points = 256;
    /// By set and point: where it is along the chain, in [0, 256), rising from 0 (the paper's sums of LODV); and
    /// across it, in [-1, 1].
    std::array<glm::vec2, sets * points> point;
};

/// The same ones always.
[[nodiscard]] ZigzagTables make_zigzag_tables();

/// Which zigzag a chain follows.
struct ZigzagStart {
    std::uint32_t set;   ///< below ZigzagTables::sets
    std::uint32_t point; ///< that the chain's length 0 is at
};

/// Of a node's random number; shaders/shade_strokes/zigzag.glsl has the same.
[[nodiscard]] constexpr ZigzagStart zigzag_start(std::uint32_t random) {
    return {(random >> 8) % std::uint32_t{ZigzagTables::sets}, random % std::uint32_t{ZigzagTables::points}};
}

} // namespace hachure
