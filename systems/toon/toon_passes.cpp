#include <hachure/components/world_transform.h>
#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_defines.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/surface_renderer.h>
#include <hachure/systems/toon/toon_passes.h>

#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

namespace hachure {
namespace {

constexpr std::size_t max_bands = 16; ///< as in the range of Toon::bands
constexpr unsigned ramp_unit = SurfaceShading::first_free_unit;
constexpr unsigned normals_unit = ramp_unit + 1;

/// Null where the surface is shaded with its own normals.
const AbstractedNormals* abstracted_normals_of(const World& world, Entity entity, const Toon& toon) {
    const auto* abstracted = toon.abstraction > 0.0f ? world.find<AbstractedNormals>(entity) : nullptr;
    return abstracted && abstracted->normals && !abstracted->normals->empty() ? abstracted : nullptr;
}

glm::vec3 focus_of(const World& world, const Toon& toon) {
    const WorldTransform* place = toon.focus ? world.find<WorldTransform>(toon.focus) : nullptr;
    return place ? glm::vec3(place->matrix[3]) : toon.focus_point;
}

std::size_t band_count(const Toon& toon) {
    return static_cast<std::size_t>(std::clamp(toon.bands, 1, static_cast<std::int32_t>(max_bands)));
}

void add_defines(const World& world, Entity entity, std::vector<gpu::ShaderDefine>& defines) {
    const Toon& toon = world.get<Toon>(entity);
    defines.push_back({"DETAIL", std::to_string(static_cast<int>(toon.detail))});
    if (toon.ramp.empty()) {
        defines.push_back({"BANDS", std::to_string(band_count(toon))});
        if (toon.softness > 0.0f) defines.push_back({"SOFT", ""});
    } else {
        defines.push_back({"RAMP", ""});
    }
    if (toon.ramp_use == RampUse::replace) defines.push_back({"TONES_REPLACE", ""});
    if (toon.rim > 0.0f) defines.push_back({"RIM", ""});
    if (toon.specular > 0.0f) defines.push_back({"SPECULAR", ""});
    if (!abstracted_normals_of(world, entity, toon)) return;
    defines.push_back({"ABSTRACTED", ""});
    defines.push_back({"NORMALS_UNIT", std::to_string(normals_unit)});
}

/// From shade to light in even steps to the eye, which judges ratios: each colour is the one before times the same.
void set_bands(const Toon& toon, gpu::Program& program) {
    std::array<glm::vec3, max_bands> colors{};
    const std::size_t count = band_count(toon);
    for (std::size_t i = 0; i < count; ++i) {
        const float part = count > 1 ? static_cast<float>(i) / static_cast<float>(count - 1) : 1.0f;
        colors[i] = i + 1 == count
                        ? toon.light
                        : glm::pow(toon.shade, glm::vec3(1.0f - part)) * glm::pow(toon.light, glm::vec3(part));
        if (i == 0 && count > 1) colors[i] = toon.shade;
    }
    std::array<float, max_bands> edges{};
    const float middle = 0.5f * (toon.dark_edge + toon.light_edge);
    for (std::size_t i = 1; i < count; ++i)
        edges[i] = count == 2 ? middle
                              : toon.dark_edge + static_cast<float>(i - 1) / static_cast<float>(count - 2) *
                                                     (toon.light_edge - toon.dark_edge);
    program.set("band_edges", std::span<const float>(edges.data(), count));
    program.set("middle_edge", middle);
    program.set("band_colors", std::span<const glm::vec3>(colors.data(), count));
}

void set_uniforms(const World& world, Entity entity, gpu::Program& program) {
    const Toon& toon = world.get<Toon>(entity);
    program.set("wrap", toon.wrap);
    program.set("softness", toon.softness);
    if (toon.ramp.empty()) set_bands(toon, program);
    program.set("detail_distance", toon.detail_distance);
    program.set("detail_log_ratio", std::log(toon.detail_ratio));
    program.set("detail_power", toon.detail_power);
    if (toon.detail == ToonDetail::focus) program.set("detail_focus", focus_of(world, toon));
    program.set("rim", toon.rim);
    program.set("rim_width", toon.rim_width);
    program.set("rim_edge", toon.rim_lit_only ? toon.dark_edge : -1e6f);
    program.set("rim_color", toon.rim_color);
    program.set("specular", toon.specular);
    program.set("specular_size", toon.specular_size);
    program.set("specular_color", toon.specular_color);
    program.set("abstraction", toon.abstraction);
}

} // namespace

void ToonPasses::declare(World& world) {
    const DrawList& list = world.resource<DrawList>();
    const DrawClaims& claims = world.resource<DrawClaims>();
    std::vector<Entity> drawn;
    gpu::KeyHash key;
    key.add(world.last_changed<Toon>());
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        if (claims.shading[i] != name) continue;
        const Entity entity = list.items[i].entity;
        const Toon& toon = world.get<Toon>(entity);
        const AbstractedNormals* abstracted = abstracted_normals_of(world, entity, toon);
        key.add(abstracted ? abstracted->version : 0);
        if (toon.detail == ToonDetail::focus) key.add(focus_of(world, toon));
        drawn.push_back(entity);
    }
    read_ramps(world, drawn);
    normals_.forget_all_but(drawn);
    add_surface_pass(world,
                     {.name = name,
                      .fragment = "toon/toon.frag",
                      .defines =
                          [&world](Entity entity, auto& defines) {
                              add_defines(world, entity, defines);
                              add_light_defines(world.resource<LightList>(), defines);
                          },
                      .uniforms = [&world](Entity entity, auto& program) { set_uniforms(world, entity, program); },
                      .vertex = "toon/toon.vert",
                      .bind = [this, &world](const DrawItem& item) { bind(world, item); }},
                     key.value());
}

/// Ahead of the pass: a fault of a file ends the frame before anything is drawn.
void ToonPasses::read_ramps(const World& world, const std::vector<Entity>& drawn) {
    for (const Entity entity : drawn)
        if (const Toon& toon = world.get<Toon>(entity); !toon.ramp.empty())
            static_cast<void>(ramps_.texture(toon.ramp));
}

void ToonPasses::bind(const World& world, const DrawItem& item) {
    const Toon& toon = world.get<Toon>(item.entity);
    if (!toon.ramp.empty()) ramps_.texture(toon.ramp).bind(ramp_unit);
    if (const AbstractedNormals* abstracted = abstracted_normals_of(world, item.entity, toon))
        normals_.get(item.entity, abstracted->version, *abstracted->normals).bind(normals_unit);
}

} // namespace hachure
