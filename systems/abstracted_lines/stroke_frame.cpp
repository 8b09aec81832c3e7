#include <hachure/systems/abstracted_lines/stroke_frame.h>
#include <hachure/systems/abstracted_lines/tone_line_style.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

StrokeOwner make_owner(const DrawItem& item, const AbstractedLines& lines, const MeshStore& store, const View& view) {
    StrokeOwner owner{.entity = item.entity, .lines = lines};
    const glm::dmat4 world_from_entity(item.world_from_entity);
    owner.entity_from_world = glm::inverse(world_from_entity);
    const glm::vec3 middle = store.mesh(item.mesh).bounds.center();
    const glm::dvec4 clip = glm::dmat4(view.clip_from_world) * world_from_entity * glm::dvec4(middle, 1.0);
    // Behind the eye there is no place in the picture; its corner is as good as any.
    const double depth = std::max(clip.w, 1e-6);
    const glm::dvec2 size(view.width, view.height);
    owner.origin = glm::vec2(glm::clamp((glm::dvec2(clip) / depth * 0.5 + 0.5) * size, -100.0 * size, 100.0 * size));
    // The clip w of a point is its depth in a perspective view and 1 in an orthographic one.
    const double units = std::cbrt(std::abs(glm::determinant(glm::dmat3(world_from_entity))));
    owner.pixels_per_unit = static_cast<float>(std::clamp(units / (double(view.pixel_size) * depth), 1e-6, 1e9));
    owner.width = std::max(full_width(lines, view), 1.0f);
    return owner;
}

} // namespace

TextureOctaves texture_octaves(float wanted, float pixels_per_unit) {
    const double octave = std::log2(double(pixels_per_unit));
    const double part = octave - std::floor(octave);
    return {static_cast<float>(double(wanted) * std::exp2(part)),
            static_cast<float>(glm::smoothstep(0.25, 0.75, part))};
}

void select_strokes(Query<const AbstractedLines> styled, const DrawList& list, const MeshStore& store, const View& view,
                    FrameRequests& requests, StrokeFrame& frame, StrokeSet& set) {
    frame.owners.clear();
    frame.drawn = false;
    bool any = false;
    for (const DrawItem& item : list.items) {
        const auto found = styled.find(item.entity);
        if (!found || !draws_anything(std::get<const AbstractedLines&>(*found))) continue;
        const AbstractedLines& lines = std::get<const AbstractedLines&>(*found);
        any = true;
        frame.drawn = frame.drawn || lines.method == ToneLineMethod::strokes;
        if (frame.owners.size() <= item.object_id) frame.owners.resize(item.object_id + 1);
        frame.owners[item.object_id] = make_owner(item, lines, store, view);
    }
    if (any && (frame.drawn || set.wanted)) {
        requests.textures.insert("ridge_points");
        requests.textures.insert("object_id");
        return;
    }
    frame.owners.clear();
    ++frame.forgotten;
    set.points.clear();
    set.strokes.clear();
    set.width = view.width;
    set.height = view.height;
}

} // namespace hachure
