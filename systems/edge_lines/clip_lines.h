#pragma once

#include <hachure/systems/edge_lines/occluders.h>
#include <hachure/systems/edge_lines/project_lines.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// Cuts lines on the screen into what is seen and what is hidden, exactly: a piece of a line is hidden by a triangle
/// where it runs inside it, behind its plane. Both are linear, so that each triangle hides one interval. What lies on
/// the plane is seen, up to `rounding` of its depth. Ends of seen pieces become ends of the line, for its taper.
struct ClipLinesJob {
    static constexpr double rounding = 2e-6;

    std::span<const LineSegment> segments;
    std::span<const PreciseEnds> ends;   ///< of each segment
    std::span<const SegmentRange> lines; ///< which segments, one after the other, are a line; in order, none left out
    std::array<SegmentRange, drawn_kinds> kinds;
    const Occluders* occluders = nullptr; ///< filled along the segments
    glm::vec2 viewport{1.0f};             ///< pixels: no line ends outside of it

    std::vector<LineSegment>* pieces = nullptr;     ///< out: those that are seen by kind, then those that are hidden
    std::array<SegmentRange, drawn_kinds> seen{};   ///< out: ranges of `pieces`
    std::array<SegmentRange, drawn_kinds> hidden{}; ///< out: likewise

    void validate() const;
    /// On several threads; the result does not depend on them.
    void run();

    /// A part of a segment, which goes from 0 to 1.
    struct Interval {
        double begin, end;
    };
    /// Consecutive segments that one thread looks at, and what of them is hidden: joined and sorted, one after the
    /// other.
    struct Chunk {
        std::vector<Interval> intervals;
        std::vector<std::uint32_t> counts; ///< per segment
    };
    /// Scratch, kept from run to run.
    std::vector<Chunk> chunks{};
    std::vector<LineSegment> hidden_pieces{};

private:
    static constexpr std::size_t chunk_size = 128; ///< segments

    /// Reads what was found of segments, in their order.
    struct Cursor {
        std::size_t chunk = 0, segment = 0, interval = 0;
    };

    void find_hidden(std::size_t chunk);
    void find_hidden(std::uint32_t segment, std::vector<Interval>& intervals) const;
    std::span<const Interval> next(Cursor& cursor) const;
    void cut_segment(const LineSegment& segment, std::span<const Interval> intervals);
    void end_runs(std::size_t first, std::vector<LineSegment>& all, bool closed) const;
    void append_kind(std::size_t kind, std::size_t& line, Cursor& cursor);
};

} // namespace hachure
