#include <hachure/components/surface.h>
#include <hachure/runtime/scene/light_defines.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/abstracted_lines/tone_shading.h>

#include <glm/geometric.hpp>

#include <string>
#include <vector>

namespace hachure {
namespace {

constexpr unsigned normals_unit = SurfaceShading::first_free_unit;
constexpr unsigned widths_unit = normals_unit + 1;

AbstractedLines lines_of(const World& world, Entity entity) {
    const auto* lines = world.find<AbstractedLines>(entity);
    return lines ? *lines : AbstractedLines{};
}

/// Null where the tone follows the surface's own normals.
const AbstractedNormals* abstracted_normals_of(const World& world, Entity entity) {
    if (!lines_of(world, entity).abstracted_normals || !world.has<Toon>(entity)) return nullptr;
    const auto* abstracted = world.find<AbstractedNormals>(entity);
    return abstracted && abstracted->normals && !abstracted->normals->empty() ? abstracted : nullptr;
}

/// Up to which distance lines have their full width; 0: width does not depend on it.
float full_width_distance(const World& world, const DrawItem& item, const AbstractedLines& lines) {
    if (lines.width_by != LineAbstraction::depth) return 0.0f;
    if (lines.full_width_distance > 0.0f) return lines.full_width_distance;
    const glm::vec3 middle(item.world_from_entity[3]);
    const View& view = world.resource<View>();
    return view.eye.w > 0.0f ? glm::distance(glm::vec3(view.eye), middle)
                             : -(view.view_from_world * glm::vec4(middle, 1.0f)).z;
}

void set_uniforms(const World& world, const DrawItem& item, const ToneLineFrame& frame, gpu::Program& program) {
    const AbstractedLines lines = lines_of(world, item.entity);
    program.set("wrap", lines.wrap);
    program.set("albedo", lines.albedo);
    program.set("shininess", lines.shininess);
    if (abstracted_normals_of(world, item.entity)) program.set("abstraction", world.get<Toon>(item.entity).abstraction);
    if (!frame.varying) return;
    const View& view = world.resource<View>();
    program.set("full_width", full_width(lines, view));
    program.set("least_width", least_width(lines, view));
    program.set("full_width_distance", full_width_distance(world, item, lines));
}

} // namespace

void ToneShading::add_key(const World& world, gpu::KeyHash& key) const {
    for (const DrawItem& item : world.resource<DrawList>().items) {
        const AbstractedNormals* abstracted = abstracted_normals_of(world, item.entity);
        key.add(abstracted ? abstracted->version : 0);
    }
}

void ToneShading::draw(World& world, RenderContext& render, const ToneLineFrame& frame) {
    const DrawList& list = world.resource<DrawList>();
    std::vector<Entity> drawn;
    for (const DrawItem& item : list.items) drawn.push_back(item.entity);
    normals_.forget_all_but(drawn);
    factors_.forget_all_but(drawn);
    const auto widths_of = [&](Entity entity) {
        return frame.varying
                   ? widths_.find(world.resource<MeshStore>(), world.get<Surface>(entity).mesh, lines_of(world, entity))
                   : nullptr;
    };
    const auto defines = [&](Entity entity, std::vector<gpu::ShaderDefine>& result) {
        add_light_defines(world.resource<LightList>(), result);
        if (frame.varying) result.push_back({"WIDTHS", ""});
        if (widths_of(entity)) result.push_back({"WIDTH_FACTORS_UNIT", std::to_string(widths_unit)});
        if (!abstracted_normals_of(world, entity)) return;
        result.push_back({"ABSTRACTED", ""});
        result.push_back({"NORMALS_UNIT", std::to_string(normals_unit)});
    };
    const DrawItem* item = list.items.data();
    const auto uniforms = [&](Entity entity, gpu::Program& program) {
        while (item->entity != entity) ++item; // surfaces are drawn in the order of the list
        set_uniforms(world, *item, frame, program);
    };
    const auto bind = [&](const DrawItem& drawn_item) {
        if (const AbstractedNormals* abstracted = abstracted_normals_of(world, drawn_item.entity))
            normals_.get(drawn_item.entity, abstracted->version, *abstracted->normals).bind(normals_unit);
        if (const VertexWidths* widths = widths_of(drawn_item.entity))
            factors_.get(drawn_item.entity, widths->version, widths->factors).bind(widths_unit);
    };
    const View& view = world.resource<View>();
    draw_all_surfaces(world, render,
                      {.fragment = "abstracted_lines/tone.frag",
                       .defines = defines,
                       .uniforms = uniforms,
                       .vertex = "abstracted_lines/tone.vert",
                       .bind = bind},
                      {0, 0, view.width, view.height}, frame.rects.shaded);
}

} // namespace hachure
