#pragma once

#include <hachure/runtime/geometry/chain_segments.h>
#include <hachure/runtime/geometry/surface_segment.h>
#include <hachure/systems/edge_lines/line_set.h>

#include <span>
#include <vector>

namespace hachure {

/// Makes lines of segments: each of its own, or linked where it matters where a line begins and ends.
class LineBuilder {
public:
    /// Appends to `lines`. `lift`, per segment or empty, is how far (metres) a line is taken towards the eye when it is
    /// asked whether it is seen.
    void add(LineSet& lines, DrawnKind kind, std::span<const geometry::SurfaceSegment> segments,
             std::span<const float> lift, bool chained);

private:
    geometry::ChainSegmentsJob chains_;
    std::vector<geometry::SegmentEnds> ends_;
    std::vector<float> lengths_;
    std::vector<geometry::ChainedSegment> order_;
};

} // namespace hachure
