#pragma once

#include <hachure/systems/edge_lines/line_set.h>
#include <hachure/systems/edge_lines/line_width.h>

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// Consecutive segments of one kind.
struct SegmentRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// The ends of a segment in full precision, for those who compare them with surfaces.
struct PreciseEnds {
    glm::dvec2 start, end; ///< pixels
    glm::dvec2 depth;      ///< window depth at start and end
};

/// Brings lines to the screen: cuts them at the near plane and at the picture's rim, measures them along, and gives
/// them their width. In double precision; no allocation once `segments` has grown.
struct ProjectLinesJob {
    const LineSet* lines = nullptr;
    glm::dmat4 clip_from_entity{1.0}; ///< reversed depth: what is seen has 0 <= z <= w
    glm::dvec2 clip_per_metre{0.0};   ///< how clip z and w change a metre nearer to the eye's plane
    glm::dvec2 viewport{1.0};         ///< pixels
    LineWidth width;

    std::vector<LineSegment>* segments = nullptr;   ///< out
    std::vector<PreciseEnds>* ends = nullptr;       ///< out: likewise; or null
    std::vector<SegmentRange>* lines_out = nullptr; ///< out: the segments of each line of which any is left
    std::array<SegmentRange, drawn_kinds> kinds;    ///< out: the segments of each kind

    void validate() const;
    void run();
};

} // namespace hachure
