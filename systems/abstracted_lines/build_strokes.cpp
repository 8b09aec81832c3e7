#include <hachure/runtime/parallel.h>
#include <hachure/systems/abstracted_lines/build_strokes.h>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure {
namespace {

/// Points of lines are left out where the rest is this near, pixels: a tenth of what the eye can tell.
constexpr float tolerance = 0.1f;

bool wants(const AbstractedLines& lines, StrokeKind kind) {
    switch (kind) {
    case StrokeKind::dark:
        return lines.dark;
    case StrokeKind::specular_dark:
        return lines.specular_dark;
    case StrokeKind::highlight:
        return lines.highlight;
    case StrokeKind::specular:
        break;
    }
    return lines.specular;
}

bool is_specular(StrokeKind kind) { return kind == StrokeKind::specular || kind == StrokeKind::specular_dark; }
bool is_dark(StrokeKind kind) { return kind == StrokeKind::dark || kind == StrokeKind::specular_dark; }

/// The nearest surface about a place: lines along the rim of a surface are its, whichever side of the rim they are on.
float nearest_depth(const RidgeMaps& maps, glm::vec2 place) {
    const glm::ivec2 pixel(place);
    float nearest = 0.0f;
    for (int y = std::max(0, pixel.y - 1); y <= std::min(maps.height - 1, pixel.y + 1); ++y)
        for (int x = std::max(0, pixel.x - 1); x <= std::min(maps.width - 1, pixel.x + 1); ++x)
            nearest = std::max(nearest, maps.depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(maps.width) +
                                                    static_cast<std::size_t>(x)]);
    return nearest;
}

/// Depths of the points of a line; beside all surfaces, that of the nearest point before, or else after it.
void fill_depths(const geometry::PolylineSet& set, const geometry::Polyline& line, const RidgeMaps& maps,
                 std::vector<float>& depths) {
    float last = 0.0f;
    for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
        const float found = nearest_depth(maps, set.points[i].place);
        last = found > 0.0f ? found : last;
        depths[i] = last;
    }
    for (std::uint32_t i = line.first + line.count - 1; i-- > line.first;)
        if (depths[i] <= 0.0f) depths[i] = depths[i + 1];
}

/// Where the points of lines are in the axes of their owners, in units of a pixel there.
void find_places(const geometry::PolylineSet& set, const StrokeFrame& frame, const View& view,
                 std::span<const float> depths, std::span<glm::vec3> places) {
    const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(view.clip_from_world));
    for (const geometry::Polyline& line : set.lines) {
        const StrokeOwner& owner = frame.owners[line.owner];
        const glm::dmat4 entity_from_clip = owner.entity_from_world * world_from_clip;
        for (std::uint32_t i = line.first; i < line.first + line.count; ++i) {
            const glm::dvec2 ndc = glm::dvec2(set.points[i].place) / glm::dvec2(view.width, view.height) * 2.0 - 1.0;
            // A line of which nothing is known lies far away in no place; so that this is one, it is not at infinity.
            const double depth = std::max(double(depths[i]), 1e-6);
            const glm::dvec4 place = entity_from_clip * glm::dvec4(ndc, depth, 1.0);
            places[i] = glm::vec3(glm::dvec3(place) / place.w * double(owner.pixels_per_unit));
        }
    }
}

} // namespace

void StrokeBuilder::run(Work& work, const RidgeMaps& maps, const StrokeFrame& frame, const View& view) const {
    const bool wanted = std::ranges::any_of(
        frame.owners, [&](const StrokeOwner& owner) { return owner.entity && wants(owner.lines, work.kind); });
    work.simplify.simplified.clear();
    if (!wanted) return;
    const bool specular = is_specular(work.kind);
    work.trace.image = {maps.width, maps.height, specular ? maps.specular_points : maps.points,
                        specular ? maps.specular_directions : maps.directions, maps.owners};
    work.trace.sign = is_dark(work.kind) ? 1.0f : -1.0f;
    work.trace.run();
    work.link.nodes = work.trace.nodes;
    work.link.segments = work.trace.segments;
    work.link.limits = limits_;
    work.link.image = work.trace.image;
    work.link.sign = work.trace.sign;
    work.link.run();
    work.reconcile.lines = &work.link.lines;
    work.reconcile.image = work.trace.image;
    work.reconcile.sign = work.trace.sign;
    work.reconcile.limits = limits_;
    work.reconcile.run();
    const geometry::PolylineSet& lines = work.reconcile.reconciled;
    work.simplify.lines = &lines;
    work.simplify.tolerance = tolerance;
    work.simplify.run();

    work.depths.assign(lines.points.size(), 0.0f);
    work.places.resize(lines.points.size());
    work.origins.clear();
    for (const geometry::Polyline& line : lines.lines) {
        fill_depths(lines, line, maps, work.depths);
        work.origins.push_back(frame.owners[line.owner].origin);
    }
    find_places(lines, frame, view, work.depths, work.places);
    work.phase.lines = &lines;
    work.phase.places = work.places;
    work.phase.origins = work.origins;
    work.phase.run();
}

void StrokeBuilder::append(const Work& work, const StrokeFrame& frame, StrokeSet& set) {
    const geometry::PolylineSet& lines = work.simplify.simplified;
    const auto first = static_cast<std::uint32_t>(set.points.size());
    set.points.insert(set.points.end(), lines.points.begin(), lines.points.end());
    for (std::size_t i = 0; i < lines.lines.size(); ++i) {
        const StrokeOwner& owner = frame.owners[lines.lines[i].owner];
        Stroke stroke{.entity = owner.entity, .kind = work.kind, .line = lines.lines[i], .phase = work.phase.phases[i]};
        stroke.drawn = owner.lines.method == ToneLineMethod::strokes;
        stroke.line.first += first;
        stroke.color = is_dark(work.kind) ? owner.lines.color : owner.lines.highlight_color;
        stroke.taper = owner.lines.taper;
        set.strokes.push_back(stroke);
    }
}

void StrokeBuilder::build(const RidgeMaps& maps, const StrokeFrame& frame, const View& view, StrokeSet& set) {
    limits_.clear();
    for (const StrokeOwner& owner :
         frame.owners) { // lines that pixels draw are known with every speck and gap of those
        const bool as_pixels = owner.lines.method == ToneLineMethod::pixels;
        limits_.push_back({owner.lines.min_length * owner.width, as_pixels, as_pixels});
    }
    parallel_for(works_.size(), [&](std::size_t i) {
        works_[i].kind = static_cast<StrokeKind>(i);
        run(works_[i], maps, frame, view);
    });
    set.points.clear();
    set.strokes.clear();
    set.width = maps.width;
    set.height = maps.height;
    for (const Work& work : works_) append(work, frame, set);
}

} // namespace hachure
