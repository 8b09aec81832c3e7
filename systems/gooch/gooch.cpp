#include <hachure/components/gooch.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_defines.h>
#include <hachure/runtime/scene/surface_renderer.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/gooch/gooch.h>

namespace hachure {
namespace {

constexpr std::string_view shading_name = "gooch";

void claim_items(Query<With<Gooch>> styled, const DrawList& list, DrawClaims& claims) {
    for (std::size_t i = 0; i < list.items.size(); ++i)
        if (styled.contains(list.items[i].entity)) claims.shading[i] = shading_name;
}

/// The fields that hold for a surface: its own, or the scene's.
const Gooch& parameters_of(const World& world, Entity entity) {
    const Gooch& own = world.get<Gooch>(entity);
    if (own.parameters == GoochParameters::own) return own;
    const Gooch* scene = world.find<Gooch>(world.resource<View>().camera);
    return scene ? *scene : own;
}

void add_defines(const Gooch& gooch, std::vector<gpu::ShaderDefine>& defines) {
    const auto define = [&](const char* name) { defines.push_back({name, ""}); };
    switch (gooch.shading) {
    case GoochShading::tone:
        if (gooch.highlight > 0.0f) define("HIGHLIGHT");
        break;
    case GoochShading::two_lights_per_vertex:
        define("PER_VERTEX");
        [[fallthrough]];
    case GoochShading::two_lights:
        define("TWO_LIGHTS");
        if (gooch.clamp_lights) define("CLAMP_LIGHTS");
        break;
    case GoochShading::phong_per_vertex:
        define("PER_VERTEX");
        [[fallthrough]];
    case GoochShading::phong:
        define("PHONG");
        return;
    }
    if (gooch.printed_equation) define("PRINTED_EQUATION");
}

void set_uniforms(const Gooch& gooch, gpu::Program& program) {
    program.set("b", gooch.b);
    program.set("y", gooch.y);
    program.set("alpha", gooch.alpha);
    program.set("beta", gooch.beta);
    program.set("highlight", gooch.highlight);
    program.set("shininess", gooch.shininess);
    program.set("ambient", gooch.ambient);
    program.set("diffuse", gooch.diffuse);
}

void add_to(gpu::KeyHash& hash, const Gooch& gooch) {
    hash.add(gooch.shading);
    for (const float value :
         {gooch.b, gooch.y, gooch.alpha, gooch.beta, gooch.highlight, gooch.shininess, gooch.ambient, gooch.diffuse})
        hash.add(value);
    hash.add(gooch.printed_equation);
    hash.add(gooch.clamp_lights);
}

/// Declares the pass, which depends on the fields that hold for what it draws: those of a camera that nobody follows,
/// or of a surface that is not seen, run nothing.
class DeclarePass {
public:
    void operator()(World& world) {
        SurfaceShading shading{.name = shading_name, .fragment = "gooch/gooch.frag"};
        shading.vertex = "gooch/gooch.vert";
        shading.defines = [&world](Entity entity, auto& defines) {
            add_defines(parameters_of(world, entity), defines);
            add_light_defines(world.resource<LightList>(), defines);
        };
        shading.uniforms = [&world](Entity entity, auto& program) {
            set_uniforms(parameters_of(world, entity), program);
        };
        add_surface_pass(world, shading, key(world));
    }

private:
    std::uint64_t key(const World& world) {
        const DrawList& list = world.resource<DrawList>();
        const DrawClaims& claims = world.resource<DrawClaims>();
        const Entity camera = world.resource<View>().camera;
        // What could have changed; who is claimed is in the pass's own key.
        const std::uint64_t state = gpu::key_of(list.key, world.last_changed<Gooch>(), camera.index, camera.generation);
        if (state == state_) return key_;
        state_ = state;
        gpu::KeyHash hash;
        for (std::size_t i = 0; i < list.items.size(); ++i)
            if (claims.shading[i] == shading_name) add_to(hash, parameters_of(world, list.items[i].entity));
        return key_ = hash.value();
    }

    std::uint64_t state_ = 0, key_ = 0;
};

} // namespace

void register_gooch(App& app) {
    app.add_component<Gooch>();
    app.add_system(Stage::material, "gooch.claim", claim_items).after("surface.collect");
    app.add_system(Stage::render, "gooch.pass", DeclarePass{}).after("surface.passes");
}

} // namespace hachure
