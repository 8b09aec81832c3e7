#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/reconcile_polylines.h>
#include <hachure/runtime/geometry/straight_piece.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hachure::geometry {
namespace {

constexpr std::uint32_t no_middle = std::numeric_limits<std::uint32_t>::max();

/// Lines are looked at this often, pixels.
constexpr float spacing = 0.5f;

/// How far a place of a line may be moved, pixels: a corner amid a junction, not a link over a gap.
constexpr float longest_move = 1.25f;

/// From one claimed middle to the next of the same line, pixels; not farther apart in direction than 50 degrees, as
/// pixels are that see one line (trace_ridges.cpp).
constexpr float shortest_step = 0.5f, longest_step = 1.5f, least_cosine = 0.64f;

/// A line as faint as that does not show what pixels claim strongly.
constexpr float faint = 0.1f;

/// What one pixel alone claims is a dot: its round ends are as long as the pixel. Half the length between them, pixels.
constexpr float half_dot = 0.05f;

/// Of lines that are no longer than so many widths the width is counted.
constexpr float counted_widths = 2.0f;

} // namespace

void ReconcilePolylinesJob::validate() const {
    HACHURE_ASSERT(lines != nullptr, "lines to reconcile");
    HACHURE_ASSERT(reach > 0.0f && reach < longest_move && strong > 0.0f, "a reach and a threshold");
}

/// The points of a line, and more between them.
void ReconcilePolylinesJob::sample(const Polyline& line) {
    samples.clear();
    for (std::uint32_t i = line.first; i + 1 < line.first + line.count; ++i) {
        const LinePoint &a = lines->points[i], &b = lines->points[i + 1];
        const int parts = std::max(1, static_cast<int>(std::ceil(glm::distance(a.place, b.place) / spacing)));
        for (int part = 0; part < parts; ++part) {
            const float t = static_cast<float>(part) / static_cast<float>(parts);
            samples.push_back(
                {glm::mix(a.place, b.place, t), glm::mix(a.width, b.width, t), glm::mix(a.opacity, b.opacity, t)});
        }
    }
    samples.push_back(lines->points[line.first + line.count - 1]);
}

/// Moves a point as little as brings it within reach of where pixels show a line. False where none is near.
bool ReconcilePolylinesJob::move_to_claims(LinePoint& point, std::uint32_t owner) const {
    const auto shown = middles.nearest(point.place, owner, longest_move);
    if (!shown) return false;
    const glm::vec2 off = point.place - *shown;
    const float distance = glm::length(off);
    if (distance > reach) point.place = *shown + 0.8f * reach / distance * off;
    return true;
}

bool ReconcilePolylinesJob::shown_between(const LinePoint& a, const LinePoint& b, std::uint32_t owner) const {
    return middles.nearest(0.5f * (a.place + b.place), owner, reach + 0.02f).has_value();
}

/// A line of the points from `first` on, unless it is but one.
void ReconcilePolylinesJob::finish(const Polyline& from, std::uint32_t first, bool start_joined, bool end_joined) {
    const auto count = static_cast<std::uint32_t>(reconciled.points.size()) - first;
    if (count < 2) return reconciled.points.resize(first);
    Polyline line{.first = first, .count = count, .owner = from.owner};
    for (std::uint32_t i = first + 1; i < first + count; ++i)
        line.length += glm::distance(reconciled.points[i - 1].place, reconciled.points[i].place);
    line.closed = from.closed && start_joined && end_joined;
    line.start_joined = !from.closed && start_joined;
    line.end_joined = !from.closed && end_joined;
    const std::span<LinePoint> points = std::span(reconciled.points).subspan(first);
    if (line.length < counted_widths * points[0].width)
        for (LinePoint& point : points) point.width = shown_width(point, line.owner);
    reconciled.lines.push_back(line);
}

/// The parts of a line that pixels show. `start_joined` and `end_joined` of finish() are, for a closed one, whether the
/// part reaches its first and its last point.
void ReconcilePolylinesJob::reconcile(const Polyline& line) {
    sample(line);
    auto first = static_cast<std::uint32_t>(reconciled.points.size());
    bool from_start = line.closed || line.start_joined;
    for (LinePoint& point : samples) {
        const bool shown = move_to_claims(point, line.owner);
        const bool begins = reconciled.points.size() == first;
        if (!shown || (!begins && !shown_between(reconciled.points.back(), point, line.owner))) {
            finish(line, first, from_start, false);
            first = static_cast<std::uint32_t>(reconciled.points.size());
            from_start = false;
        }
        if (shown) reconciled.points.push_back(point);
    }
    const bool to_end = reconciled.points.size() > first && reconciled.points.back().place == samples.back().place;
    finish(line, first, from_start, to_end && (line.closed || line.end_joined));
}

void ReconcilePolylinesJob::mark_along(glm::vec2 a, glm::vec2 b, std::uint32_t owner) {
    const std::span<const ClaimedMiddle> claims = middles.claims();
    middles.each_near(0.5f * (a + b), reach + 0.5f * glm::distance(a, b), [&](std::uint32_t i) {
        if (claims[i].owner == owner && glm::distance(claims[i].place, nearest_on(a, b, claims[i].place)) <= reach)
            on_line[i] = 1;
    });
}

/// A line is shown by as many pixels per pixel of its length as it is wide. Those that few see are narrower than their
/// style says: warts of a pixel beside lines are no blots.
float ReconcilePolylinesJob::shown_width(const LinePoint& point, std::uint32_t owner) const {
    const std::span<const ClaimedMiddle> claims = middles.claims();
    int count = 0;
    middles.each_near(point.place, 0.5f, [&](std::uint32_t i) {
        count += claims[i].owner == owner && glm::distance(claims[i].place, point.place) <= 0.5f;
    });
    return std::min(point.width, static_cast<float>(std::max(count, 1)));
}

LinePoint ReconcilePolylinesJob::shown_at(const ClaimedMiddle& claim) const {
    LinePoint point{claim.place, claim.width, claim.opacity};
    point.width = shown_width(point, claim.owner);
    return point;
}

/// Of the middles ahead that are on no line yet the one that the line goes on to.
std::uint32_t ReconcilePolylinesJob::next_claim(const ClaimedMiddle& from, glm::vec2 ahead) const {
    const std::span<const ClaimedMiddle> claims = middles.claims();
    std::uint32_t best = no_middle;
    float least = std::numeric_limits<float>::max();
    middles.each_near(from.place, longest_step, [&](std::uint32_t i) {
        const ClaimedMiddle& claim = claims[i];
        if (on_line[i] || claim.owner != from.owner || claim.opacity < strong) return;
        const glm::vec2 step = claim.place - from.place;
        const float along = glm::dot(step, ahead), across = std::abs(step.x * ahead.y - step.y * ahead.x);
        if (along < shortest_step || along > longest_step || across > 0.6f * along) return;
        if (std::abs(glm::dot(claim.tangent, ahead)) < least_cosine) return;
        if (along + 2.0f * across >= least) return;
        if (!shown_between({from.place}, {claim.place}, claim.owner)) return;
        least = along + 2.0f * across;
        best = i;
    });
    return best;
}

/// Appends to `walk` what lies ahead of a claimed middle.
void ReconcilePolylinesJob::walk_from(std::uint32_t claim, glm::vec2 ahead) {
    const std::span<const ClaimedMiddle> claims = middles.claims();
    for (std::uint32_t at = claim;;) {
        const std::uint32_t next = next_claim(claims[at], ahead);
        if (next == no_middle) return;
        mark_along(claims[at].place, claims[next].place, claims[at].owner);
        on_line[next] = 1;
        walk.push_back(shown_at(claims[next]));
        ahead = glm::dot(claims[next].tangent, ahead) < 0.0f ? -claims[next].tangent : claims[next].tangent;
        at = next;
    }
}

/// The line through a middle that is on none, both ways as far as there are others; a dot where there are none.
void ReconcilePolylinesJob::add_line_through(std::uint32_t claim) {
    const ClaimedMiddle& start = middles.claims()[claim];
    on_line[claim] = 1;
    walk.clear();
    walk_from(claim, -start.tangent);
    std::ranges::reverse(walk);
    LinePoint middle = shown_at(start);
    walk.push_back(middle);
    walk_from(claim, start.tangent);
    if (walk.size() == 1) {
        walk.assign(2, middle);
        walk[0].place -= half_dot * start.tangent;
        walk[1].place += half_dot * start.tangent;
        mark_along(walk[0].place, walk[1].place, start.owner);
    }
    const auto first = static_cast<std::uint32_t>(reconciled.points.size());
    reconciled.points.insert(reconciled.points.end(), walk.begin(), walk.end());
    finish({.owner = start.owner}, first, false, false);
}

void ReconcilePolylinesJob::run() {
    reconciled.clear();
    const bool any = limits.empty() || std::ranges::any_of(limits, &LineLimits::gaps);
    middles.fill(any ? image : RidgeImage{}, sign);
    on_line.assign(middles.claims().size(), 0);
    for (const Polyline& line : lines->lines) {
        if (applies(line.owner)) {
            reconcile(line);
            continue;
        }
        Polyline same = line;
        same.first = static_cast<std::uint32_t>(reconciled.points.size());
        const auto points = std::span(lines->points).subspan(line.first, line.count);
        reconciled.points.insert(reconciled.points.end(), points.begin(), points.end());
        reconciled.lines.push_back(same);
    }
    for (const Polyline& line : reconciled.lines)
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
            const LinePoint &a = reconciled.points[i - 1], &b = reconciled.points[i];
            if (std::min(a.opacity, b.opacity) >= faint) mark_along(a.place, b.place, line.owner);
        }
    for (std::uint32_t i = 0; i < on_line.size(); ++i) {
        const ClaimedMiddle& claim = middles.claims()[i];
        if (!on_line[i] && claim.opacity >= strong && applies(claim.owner)) add_line_through(i);
    }
}

} // namespace hachure::geometry
