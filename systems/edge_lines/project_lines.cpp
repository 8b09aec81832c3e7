#include <hachure/runtime/assert.h>
#include <hachure/systems/edge_lines/project_lines.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

constexpr float no_end = 1e30f; ///< pixels: the end of a line that has none

struct ScreenPoint {
    glm::dvec2 at;
    double depth, half_width, weight;
};

ScreenPoint mixed(const ScreenPoint& a, const ScreenPoint& b, double t) {
    return {glm::mix(a.at, b.at, t), glm::mix(a.depth, b.depth, t), glm::mix(a.half_width, b.half_width, t),
            glm::mix(a.weight, b.weight, t)};
}

/// The part [low, high] of the way from a to b that lies in a box; empty when low > high.
glm::dvec2 part_inside(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& low, const glm::dvec2& high) {
    glm::dvec2 part(0.0, 1.0);
    for (int axis = 0; axis < 2; ++axis) {
        const double along = b[axis] - a[axis];
        if (along == 0.0) {
            if (a[axis] < low[axis] || a[axis] > high[axis]) return {1.0, 0.0};
            continue;
        }
        double enter = (low[axis] - a[axis]) / along, leave = (high[axis] - a[axis]) / along;
        if (enter > leave) std::swap(enter, leave);
        part = {std::max(part.x, enter), std::min(part.y, leave)};
    }
    return part;
}

/// One line on its way to the screen.
class LineProjector {
public:
    explicit LineProjector(const ProjectLinesJob& job) : job_(job) {}

    void project(const LineChain& chain) {
        const std::size_t first = job_.segments->size();
        arc_ = 0.0;
        for (std::uint32_t i = chain.first; i + 1 < chain.first + chain.count; ++i) add_segment(i);
        const glm::vec2 ends = chain.closed ? glm::vec2(-no_end, no_end) : glm::vec2(0.0f, static_cast<float>(arc_));
        for (std::size_t i = first; i < job_.segments->size(); ++i) (*job_.segments)[i].ends = ends;
        if (job_.segments->size() > first)
            job_.lines_out->push_back(
                {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(job_.segments->size() - first)});
    }

private:
    glm::dvec4 clip(std::uint32_t i) const {
        return job_.clip_from_entity * glm::dvec4(glm::dvec3(job_.lines->points[i]), 1.0);
    }

    ScreenPoint on_screen(const glm::dvec4& clip, double weight, double lift) const {
        const glm::dvec2 at = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * job_.viewport;
        const double wide = job_.width.half_width / (job_.width.by_distance ? clip.w : 1.0);
        if (lift == double(never_seen))
            return {at, -1.0, wide, weight}; // behind everything: depth is 0 at the far plane
        const double nearer_w = std::max(clip.w + lift * job_.clip_per_metre.y, 0.1 * clip.w);
        return {at, (clip.z + lift * job_.clip_per_metre.x) / nearer_w, wide, weight};
    }

    void add_segment(std::uint32_t i) {
        glm::dvec4 a = clip(i), b = clip(i + 1);
        double weight_a = double(job_.lines->weights[i]), weight_b = double(job_.lines->weights[i + 1]);
        // What lies before the near plane has z > w; there the clip w of what is drawn stays positive.
        const double inside_a = a.w - a.z, inside_b = b.w - b.z;
        if (inside_a < 0.0 && inside_b < 0.0) return;
        const double t = inside_a / (inside_a - inside_b);
        if (inside_a < 0.0) {
            a = glm::mix(a, b, t);
            weight_a = glm::mix(weight_a, weight_b, t);
        } else if (inside_b < 0.0) {
            b = glm::mix(a, b, t);
            weight_b = glm::mix(weight_a, weight_b, t);
        }
        if (a.w <= 0.0 || b.w <= 0.0) return;
        cut_to_picture(on_screen(a, weight_a, double(job_.lines->lifts[i])),
                       on_screen(b, weight_b, double(job_.lines->lifts[i + 1])));
    }

    void cut_to_picture(const ScreenPoint& a, const ScreenPoint& b) {
        const double length = glm::distance(a.at, b.at), arc = arc_;
        arc_ += length;
        const double reach = std::max(a.half_width, b.half_width) + 1.0;
        const glm::dvec2 part = part_inside(a.at, b.at, glm::dvec2(-reach), job_.viewport + reach);
        if (!(part.x <= part.y)) return;
        const ScreenPoint p = mixed(a, b, part.x), q = mixed(a, b, part.y);
        if (job_.ends) job_.ends->push_back({p.at, q.at, {p.depth, q.depth}});
        job_.segments->push_back({.start = glm::vec2(p.at),
                                  .end = glm::vec2(q.at),
                                  .depth = {p.depth, q.depth},
                                  .half_width = {p.half_width, q.half_width},
                                  .weight = {p.weight, q.weight},
                                  .arc = {arc + part.x * length, arc + part.y * length}});
    }

    const ProjectLinesJob& job_;
    double arc_ = 0.0;
};

} // namespace

void ProjectLinesJob::validate() const {
    HACHURE_ASSERT(lines && segments && lines_out, "there are lines and room for what comes of them");
    HACHURE_ASSERT(lines->weights.size() == lines->points.size(), "one weight per point");
    HACHURE_ASSERT(lines->lifts.size() == lines->points.size(), "one lift per point");
    HACHURE_ASSERT(std::ranges::is_sorted(lines->chains, {}, &LineChain::kind), "lines are sorted by kind");
    for (const LineChain& chain : lines->chains)
        HACHURE_ASSERT(std::size_t{chain.first} + chain.count <= lines->points.size(), "a line's points exist");
}

void ProjectLinesJob::run() {
    segments->clear();
    if (ends) ends->clear();
    lines_out->clear();
    kinds = {};
    LineProjector projector(*this);
    for (const LineChain& chain : lines->chains) {
        const auto before = static_cast<std::uint32_t>(segments->size());
        projector.project(chain);
        SegmentRange& range = kinds[static_cast<std::size_t>(chain.kind)];
        if (range.count == 0) range.first = before;
        range.count += static_cast<std::uint32_t>(segments->size()) - before;
    }
}

} // namespace hachure
