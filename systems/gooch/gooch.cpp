#include <hachure/components/gooch.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/surface_renderer.h>
#include <hachure/systems/gooch/gooch.h>

namespace hachure {
namespace {

constexpr std::string_view shading_name = "gooch";

void claim_items(Query<With<Gooch>> styled, const DrawList& list, DrawClaims& claims) {
    for (std::size_t i = 0; i < list.items.size(); ++i)
        if (styled.contains(list.items[i].entity)) claims.shading[i] = shading_name;
}

void add_defines(const Gooch& gooch, std::vector<gpu::ShaderDefine>& defines) {
    if (gooch.printed_equation) defines.push_back({"PRINTED_EQUATION", ""});
    if (gooch.highlight > 0.0f) defines.push_back({"HIGHLIGHT", ""});
}

void set_uniforms(const Gooch& gooch, gpu::Program& program) {
    program.set("b", gooch.b);
    program.set("y", gooch.y);
    program.set("alpha", gooch.alpha);
    program.set("beta", gooch.beta);
    program.set("highlight", gooch.highlight);
    program.set("shininess", gooch.shininess);
}

void declare_pass(World& world) {
    add_surface_pass(
        world,
        {.name = shading_name,
         .fragment = "gooch/gooch.frag",
         .defines = [&world](Entity entity, auto& defines) { add_defines(world.get<Gooch>(entity), defines); },
         .uniforms = [&world](Entity entity, auto& program) { set_uniforms(world.get<Gooch>(entity), program); }},
        world.last_changed<Gooch>());
}

} // namespace

void register_gooch(App& app) {
    app.add_component<Gooch>();
    app.add_system(Stage::material, "gooch.claim", claim_items).after("surface.collect");
    app.add_system(Stage::render, "gooch.pass", declare_pass).after("surface.passes");
}

} // namespace hachure
