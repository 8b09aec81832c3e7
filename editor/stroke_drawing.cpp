#include <hachure/components/abstracted_lines.h>
#include <hachure/components/compose.h>
#include <hachure/components/name.h>
#include <hachure/editor/stroke_drawing.h>
#include <hachure/runtime/ecs/hierarchy.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/stroke_set.h>
#include <hachure/runtime/scene/view.h>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

/// Into how many pieces the thinning end of a stroke is cut.
constexpr int taper_steps = 8;

/// The points of a stroke, with more of them where it thins out.
class StrokeSampler {
public:
    StrokeSampler(const StrokeSet& set, const Stroke& stroke) : set_(set), stroke_(stroke) {
        const bool tapers = stroke.drawn && stroke.taper > 0.0f && !stroke.line.closed;
        begin_ = tapers && !stroke.line.start_joined ? 0.0f : -1e6f;
        end_ = tapers && !stroke.line.end_joined ? stroke.line.length : 1e6f;
    }

    [[nodiscard]] assets::SvgLine sample() const {
        assets::SvgLine line;
        line.closed = stroke_.line.closed;
        float arc = 0.0f;
        const std::uint32_t first = stroke_.line.first;
        line.points.push_back(at(set_.points[first], 0.0f));
        for (std::uint32_t i = first + 1; i < first + stroke_.line.count; ++i) {
            const geometry::LinePoint &a = set_.points[i - 1], &b = set_.points[i];
            const float length = glm::distance(a.place, b.place), reach = std::max(a.width, b.width) * stroke_.taper;
            const bool thins = arc < begin_ + reach || arc + length > end_ - reach;
            const float step = reach / static_cast<float>(taper_steps);
            const int parts = thins && step > 0.0f ? std::max(1, static_cast<int>(std::ceil(length / step))) : 1;
            for (int part = 1; part <= parts; ++part) {
                const float t = static_cast<float>(part) / static_cast<float>(parts);
                line.points.push_back(at(
                    {glm::mix(a.place, b.place, t), glm::mix(a.width, b.width, t), glm::mix(a.opacity, b.opacity, t)},
                    arc + t * length));
            }
            arc += length;
        }
        return line;
    }

private:
    [[nodiscard]] assets::SvgPoint at(const geometry::LinePoint& point, float arc) const {
        assets::SvgPoint result{
            {point.place.x, static_cast<float>(set_.height) - point.place.y}, point.width, point.opacity};
        const float from_end = std::max(std::min(arc - begin_, end_ - arc), 0.0f);
        if (stroke_.taper > 0.0f) // as shaders/abstracted_lines/stroke.frag
            result.width *= std::sqrt(std::min(from_end / std::max(point.width * stroke_.taper, 1e-6f), 1.0f));
        return result;
    }

    const StrokeSet& set_;
    const Stroke& stroke_;
    float begin_, end_;
};

/// The names of the entity and of what it stands below, as in paths of `--set`: "fox/body".
std::string label_of(const World& world, Entity entity) {
    std::string label;
    for (Entity at = entity; at;) {
        if (const Name* name = world.find<Name>(at); name && !name->text.empty())
            label = label.empty() ? name->text : name->text + "/" + label;
        const Parent* parent = world.find<Parent>(at);
        at = parent ? parent->entity : Entity::null;
    }
    return label.empty() ? fmt::format("entity {}", entity.index) : label;
}

} // namespace

void want_strokes(World& world, const std::string& output) {
    if (world.query<const AbstractedLines>().empty())
        throw Error(output, "nothing to draw has abstracted_lines, whose lines an SVG file holds: --style lines gives "
                            "them to all surfaces");
    world.resource_mutable<StrokeSet>().wanted = true;
}

assets::SvgDrawing stroke_drawing(const World& world) {
    const StrokeSet& set = world.resource<StrokeSet>();
    assets::SvgDrawing drawing{.width = set.width, .height = set.height};
    const Compose* compose = world.find<Compose>(world.resource<View>().camera);
    drawing.background = compose ? compose->background : Compose{}.background;
    std::vector<const Stroke*> strokes;
    for (const Stroke& stroke : set.strokes) strokes.push_back(&stroke);
    std::ranges::stable_sort(strokes, {}, [](const Stroke* stroke) { return stroke->line.owner; });
    for (const Stroke* stroke : strokes) {
        const std::string entity = fmt::format("entity-{}", stroke->line.owner);
        if (drawing.layers.empty() || drawing.layers.back().id != entity)
            drawing.layers.push_back(
                {.label = label_of(world, stroke->entity), .id = entity, .lines = {}, .layers = {}});
        std::vector<assets::SvgLayer>& kinds = drawing.layers.back().layers;
        const std::string kind(name_of(stroke->kind));
        if (kinds.empty() || kinds.back().label != kind)
            kinds.push_back(
                {.label = kind, .id = entity + "-" + kind, .color = stroke->color, .lines = {}, .layers = {}});
        kinds.back().lines.push_back(StrokeSampler(set, *stroke).sample());
    }
    return drawing;
}

} // namespace hachure
