#include <hachure/runtime/assert.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/edge_lines/clip_lines.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

constexpr float unbounded = 1e30f;

/// Gaps shorter than this are no gaps, pixels: neighbours of a surface meet without one, up to rounding.
constexpr double shortest_gap = 1.0 / 64.0;

LineSegment piece_of(const LineSegment& s, double begin, double end) {
    const auto b = static_cast<float>(begin), e = static_cast<float>(end);
    const auto part = [&](const glm::vec2& ends) {
        return glm::vec2(glm::mix(ends.x, ends.y, b), glm::mix(ends.x, ends.y, e));
    };
    return {glm::mix(s.start, s.end, b),
            glm::mix(s.start, s.end, e),
            part(s.depth),
            part(s.half_width),
            part(s.weight),
            part(s.arc),
            s.ends};
}

/// Narrows [begin, end] to where value(t) = at0 + t * (at1 - at0) is above zero.
void narrow(ClipLinesJob::Interval& interval, double at0, double at1) {
    if (at0 <= 0.0 && at1 <= 0.0) {
        interval.end = -1.0;
    } else if (at0 <= 0.0) {
        interval.begin = std::max(interval.begin, at0 / (at0 - at1));
    } else if (at1 <= 0.0) {
        interval.end = std::min(interval.end, at0 / (at0 - at1));
    }
}

/// Where a triangle hides a segment.
ClipLinesJob::Interval hidden_by(const ScreenTriangle& triangle, const PreciseEnds& segment) {
    const glm::dvec2 &p = segment.start, &q = segment.end, &z = segment.depth;
    ClipLinesJob::Interval interval{0.0, 1.0};
    const auto above = [&](const glm::dvec2& at, double depth) { // reversed depth: nearer is more
        return triangle.depth.x * at.x + triangle.depth.y * at.y + triangle.depth.z -
               depth * (1.0 + ClipLinesJob::rounding);
    };
    narrow(interval, above(p, z.x), above(q, z.y));
    for (std::size_t i = 0; i < 3 && interval.begin < interval.end; ++i) {
        const glm::dvec2 &a = triangle.corners[i], side = triangle.corners[(i + 1) % 3] - a;
        const auto left = [&](const glm::dvec2& at) { return side.x * (at.y - a.y) - side.y * (at.x - a.x); };
        narrow(interval, left(p), left(q));
    }
    return interval;
}

bool outside(const glm::vec2& at, const glm::vec2& viewport) {
    return at.x <= 0.0f || at.y <= 0.0f || at.x >= viewport.x || at.y >= viewport.y;
}

bool goes_on(const LineSegment& a, const LineSegment& b) { return a.arc.y == b.arc.x && a.end == b.start; }

} // namespace

void ClipLinesJob::validate() const {
    HACHURE_ASSERT(occluders && pieces, "there is something to clip against, and room for what is left");
    std::uint32_t next = 0;
    for (const SegmentRange& line : lines) {
        HACHURE_ASSERT(line.first == next && line.count > 0, "lines follow each other");
        next += line.count;
    }
    HACHURE_ASSERT(next == segments.size(), "every segment is of a line");
    HACHURE_ASSERT(ends.size() == segments.size(), "every segment has its ends in full precision");
}

/// Appends the intervals of one segment that triangles hide, joined and sorted.
void ClipLinesJob::find_hidden(std::uint32_t index, std::vector<Interval>& intervals) const {
    const glm::dvec2 &p = ends[index].start, &q = ends[index].end;
    const std::size_t first = intervals.size();
    // A triangle in several cells along the segment is met more than once: its interval joins itself.
    occluders->each_along(p, q, [&](std::uint32_t triangle) {
        const Interval interval = hidden_by(occluders->triangles()[triangle], ends[index]);
        if (interval.begin < interval.end) intervals.push_back(interval);
    });
    const auto own = std::span(intervals).subspan(first);
    std::ranges::sort(own, {}, &Interval::begin);
    const double gap = shortest_gap / std::max(glm::distance(p, q), shortest_gap);
    std::size_t count = 0;
    for (const Interval& interval : own) {
        if (count > 0 && interval.begin <= own[count - 1].end + gap)
            own[count - 1].end = std::max(own[count - 1].end, interval.end);
        else
            own[count++] = interval;
    }
    intervals.resize(first + count);
    if (count == 0) return;
    if (intervals[first].begin < gap) intervals[first].begin = 0.0;
    if (intervals.back().end > 1.0 - gap) intervals.back().end = 1.0;
}

void ClipLinesJob::find_hidden(std::size_t chunk) {
    Chunk& found = chunks[chunk];
    found.intervals.clear();
    found.counts.clear();
    const std::size_t end = std::min(segments.size(), (chunk + 1) * chunk_size);
    for (std::size_t i = chunk * chunk_size; i < end; ++i) {
        const std::size_t before = found.intervals.size();
        find_hidden(static_cast<std::uint32_t>(i), found.intervals);
        found.counts.push_back(static_cast<std::uint32_t>(found.intervals.size() - before));
    }
}

std::span<const ClipLinesJob::Interval> ClipLinesJob::next(Cursor& cursor) const {
    if (cursor.segment == chunk_size) cursor = {cursor.chunk + 1, 0, 0};
    const Chunk& chunk = chunks[cursor.chunk];
    const std::uint32_t count = chunk.counts[cursor.segment++];
    const auto intervals = std::span(chunk.intervals).subspan(cursor.interval, count);
    cursor.interval += count;
    return intervals;
}

void ClipLinesJob::cut_segment(const LineSegment& segment, std::span<const Interval> intervals) {
    double seen_from = 0.0;
    for (const Interval& interval : intervals) {
        if (interval.begin > seen_from) pieces->push_back(piece_of(segment, seen_from, interval.begin));
        hidden_pieces.push_back(piece_of(segment, interval.begin, interval.end));
        seen_from = interval.end;
    }
    if (seen_from < 1.0) pieces->push_back(intervals.empty() ? segment : piece_of(segment, seen_from, 1.0));
}

/// Gives the pieces of a line from `first` on their ends: where a run of them begins and ends.
void ClipLinesJob::end_runs(std::size_t first, std::vector<LineSegment>& all, bool closed) const {
    const std::size_t end = all.size();
    // A closed line that is seen where it begins and where it ends goes on there.
    const bool wraps = closed && end > first && all[end - 1].end == all[first].start;
    for (std::size_t i = first; i < end;) {
        std::size_t last = i;
        while (last + 1 < end && goes_on(all[last], all[last + 1])) ++last;
        glm::vec2 run(all[i].arc.x, all[last].arc.y);
        if (outside(all[i].start, viewport) || (wraps && i == first)) run.x = -unbounded;
        if (outside(all[last].end, viewport) || (wraps && last + 1 == end)) run.y = unbounded;
        for (; i <= last; ++i) all[i].ends = run;
    }
}

void ClipLinesJob::append_kind(std::size_t kind, std::size_t& line, Cursor& cursor) {
    const std::uint32_t kind_end = kinds[kind].first + kinds[kind].count;
    seen[kind].first = static_cast<std::uint32_t>(pieces->size());
    hidden[kind].first = static_cast<std::uint32_t>(hidden_pieces.size());
    for (; line < lines.size() && lines[line].first < kind_end; ++line) {
        const std::size_t first_seen = pieces->size(), first_hidden = hidden_pieces.size();
        for (std::uint32_t i = lines[line].first; i < lines[line].first + lines[line].count; ++i)
            cut_segment(segments[i], next(cursor));
        const bool closed = segments[lines[line].first].ends.y == unbounded;
        end_runs(first_seen, *pieces, closed);
        end_runs(first_hidden, hidden_pieces, closed);
    }
    seen[kind].count = static_cast<std::uint32_t>(pieces->size()) - seen[kind].first;
    hidden[kind].count = static_cast<std::uint32_t>(hidden_pieces.size()) - hidden[kind].first;
}

void ClipLinesJob::run() {
    pieces->clear();
    hidden_pieces.clear();
    seen = hidden = {};
    const std::size_t count = (segments.size() + chunk_size - 1) / chunk_size;
    if (chunks.size() < count) chunks.resize(count);
    parallel_for(count, [this](std::size_t chunk) { find_hidden(chunk); });
    std::size_t line = 0;
    Cursor cursor;
    for (std::size_t kind = 0; kind < drawn_kinds; ++kind)
        if (kinds[kind].count > 0) append_kind(kind, line, cursor);
    const auto all_seen = static_cast<std::uint32_t>(pieces->size());
    pieces->insert(pieces->end(), hidden_pieces.begin(), hidden_pieces.end());
    for (SegmentRange& range : hidden) range.first += all_seen;
}

} // namespace hachure
