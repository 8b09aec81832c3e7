#include <hachure/systems/edge_lines/line_builder.h>

namespace hachure {
namespace {

void add_point(LineSet& lines, const geometry::SurfaceSegment& segment, bool end, float lift) {
    lines.points.push_back(end ? segment.end : segment.start);
    lines.weights.push_back(end ? segment.end_weight : segment.start_weight);
    lines.lifts.push_back(lift);
}

} // namespace

void LineBuilder::add(LineSet& lines, DrawnKind kind, std::span<const geometry::SurfaceSegment> segments,
                      std::span<const float> lift, bool chained) {
    const auto lift_of = [&](std::size_t i) { return lift.empty() ? 0.0f : lift[i]; };
    if (!chained) {
        for (std::size_t i = 0; i < segments.size(); ++i) {
            lines.chains.push_back({static_cast<std::uint32_t>(lines.points.size()), 2, kind, false});
            add_point(lines, segments[i], false, lift_of(i));
            add_point(lines, segments[i], true, lift_of(i));
        }
        return;
    }
    ends_.clear();
    for (const geometry::SurfaceSegment& segment : segments) ends_.push_back({segment.start_id, segment.end_id});
    lengths_.assign(segments.size(), 1.0f); // arcs are measured on the screen
    order_.resize(segments.size());
    chains_.ends = ends_;
    chains_.lengths = lengths_;
    chains_.order = order_;
    chains_.run();
    for (const geometry::Chain& chain : chains_.chains) {
        lines.chains.push_back(
            {static_cast<std::uint32_t>(lines.points.size()), chain.count + 1, kind, chain.closed != 0});
        for (std::uint32_t i = chain.first; i < chain.first + chain.count; ++i) {
            const geometry::ChainedSegment& link = order_[i];
            const bool reversed = link.reversed != 0;
            if (i == chain.first) add_point(lines, segments[link.segment], reversed, lift_of(link.segment));
            add_point(lines, segments[link.segment], !reversed, lift_of(link.segment));
        }
    }
}

} // namespace hachure
