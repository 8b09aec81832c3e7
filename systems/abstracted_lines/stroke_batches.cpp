#include <hachure/systems/abstracted_lines/stroke_batches.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace hachure {
namespace {

/// Where a stroke without a free end ends, for its taper.
constexpr float far_away = 1e6f;

void append_segments(const StrokeSet& set, const Stroke& stroke, std::vector<StrokeSegment>& segments) {
    const geometry::Polyline& line = stroke.line;
    StrokeSegment segment{};
    segment.ends = {line.closed || line.start_joined ? -far_away : 0.0f,
                    line.closed || line.end_joined ? far_away : line.length};
    segment.ahead = stroke.phase.ahead - stroke.phase.fraction * line.length;
    segment.weights = stroke.phase.weights;
    segment.turn = {stroke.phase.turn, line.closed ? line.length : 0.0f};
    float arc = 0.0f;
    for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
        const geometry::LinePoint &a = set.points[i - 1], &b = set.points[i];
        const float length = glm::distance(a.place, b.place);
        segment.start = a.place;
        segment.end = b.place;
        segment.half_width = 0.5f * glm::vec2(a.width, b.width);
        segment.opacity = {a.opacity, b.opacity};
        segment.arc = {arc, arc + length};
        segments.push_back(segment);
        arc += length;
    }
}

} // namespace

void StrokeBatches::fill(const StrokeSet& set) {
    segments.clear();
    groups.clear();
    std::vector<const Stroke*> drawn;
    for (const Stroke& stroke : set.strokes)
        if (stroke.drawn) drawn.push_back(&stroke);
    std::ranges::stable_sort(drawn, {}, [](const Stroke* s) { return std::tuple(s->kind, s->line.owner); });
    for (const Stroke* stroke : drawn) {
        if (groups.empty() || groups.back().color != stroke->color) groups.push_back({stroke->color, {}});
        std::vector<StrokeBatch>& batches = groups.back().batches;
        if (batches.empty() || batches.back().owner != stroke->line.owner)
            batches.push_back({stroke->line.owner, static_cast<std::uint32_t>(segments.size()), 0});
        append_segments(set, *stroke, segments);
        batches.back().count = static_cast<std::uint32_t>(segments.size()) - batches.back().first;
    }
}

} // namespace hachure
