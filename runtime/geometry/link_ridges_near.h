#pragma once

#include <hachure/runtime/geometry/link_ridges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

/// What the parts of LinkRidgesJob share: nodes near a place. Not for users of the folder.
namespace hachure::geometry {

inline constexpr std::uint32_t no_link = std::numeric_limits<std::uint32_t>::max();

/// Two lines nearer than this cross or touch, pixels: ridges side by side are more than a pixel apart.
inline constexpr float touch = 0.75f;

template <class Visit> void LinkRidgesJob::each_near(const Grid& grid, glm::vec2 at, Visit&& visit) const {
    const glm::ivec2 middle((at - grid.origin) / grid.cell);
    for (int y = std::max(0, middle.y - 1); y <= std::min(grid.rows - 1, middle.y + 1); ++y) {
        for (int x = std::max(0, middle.x - 1); x <= std::min(grid.columns - 1, middle.x + 1); ++x) {
            const std::size_t cell =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(x);
            for (std::uint32_t i = cell_starts[cell]; i < cell_starts[cell + 1]; ++i) visit(cell_nodes[i]);
        }
    }
}

} // namespace hachure::geometry
