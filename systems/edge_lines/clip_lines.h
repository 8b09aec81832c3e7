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
    void run();

    /// Scratch, kept from run to run.
    struct Interval {
        double begin, end;
    };
    std::vector<Interval> intervals{};
    std::vector<std::uint32_t> looked_at{}; ///< per triangle: 1 + the last segment that met it
    std::vector<LineSegment> hidden_pieces{};

private:
    void find_hidden(std::uint32_t segment);
    void cut_segment(const LineSegment& segment);
    void end_runs(std::size_t first, std::vector<LineSegment>& all, bool closed) const;
    void append_kind(std::size_t kind, std::size_t& line);
};

} // namespace hachure
