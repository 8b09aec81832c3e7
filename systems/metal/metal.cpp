#include <hachure/components/deformed.h>
#include <hachure/components/metal.h>
#include <hachure/components/surface.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/app/log.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_defines.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/surface_renderer.h>
#include <hachure/systems/metal/metal.h>
#include <hachure/systems/metal/metal_frame.h>
#include <hachure/systems/metal/stripe_layout.h>

namespace hachure {
namespace {

constexpr std::string_view shading_name = "metal";

void claim_items(Query<With<Metal>> styled, const DrawList& list, DrawClaims& claims) {
    for (std::size_t i = 0; i < list.items.size(); ++i)
        if (styled.contains(list.items[i].entity)) claims.shading[i] = shading_name;
}

/// One surface of metal, as its shaders see it.
class DrawnMetal {
public:
    DrawnMetal(const World& world, Entity entity)
        : metal(world.get<Metal>(entity)), mesh_index(world.get<Surface>(entity).mesh),
          mesh(world.resource<MeshStore>().mesh(mesh_index)), source(stripe_source(mesh, metal)),
          by_angle(source == MetalSource::around_axis && !world.has<Deformed>(entity)) {}

    const Metal& metal;
    std::uint32_t mesh_index;
    const SurfaceMesh& mesh;
    MetalSource source;
    bool by_angle; ///< of every fragment; else by a coordinate of the vertices

    [[nodiscard]] std::uint64_t layout_key() const { return stripe_layout_key(mesh_index, mesh, metal); }

    [[nodiscard]] StripeSet stripe_set() const {
        return {metal.seed, metal.count, metal.low, metal.high, source == MetalSource::curvature};
    }

    void add_defines(std::vector<gpu::ShaderDefine>& defines) const {
        if (by_angle) defines.push_back({"AROUND_AXIS", ""});
        if (source == MetalSource::curvature) defines.push_back({"SMOOTH_NORMAL", ""});
        if (metal.highlight == MetalHighlight::halfway) defines.push_back({"HALFWAY", ""});
        if (metal.cool_to_warm > 0.0f) defines.push_back({"COOL_TO_WARM", ""});
    }

    void set_uniforms(gpu::Program& program, const RampBuffer& ramp) const {
        program.set("knot_count", ramp.knot_count);
        program.set("ramp_mean", ramp.mean);
        program.set("light_stripe", metal.light_stripe);
        program.set("tint", metal.tint);
        set_place(program);
        if (metal.cool_to_warm <= 0.0f) return;
        program.set("cool_to_warm", metal.cool_to_warm);
        program.set("b", metal.b);
        program.set("y", metal.y);
        program.set("alpha", metal.alpha);
        program.set("beta", metal.beta);
    }

private:
    void set_place(gpu::Program& program) const {
        const float count = static_cast<float>(metal.count);
        if (by_angle) {
            const StripeAxis axis = stripe_axis(mesh, metal);
            program.set("axis_from_entity", axis.axis_from_entity);
            program.set("axis_point", axis.point);
            program.set("stripes_per_unit", sets_around(metal) * count);
        } else {
            program.set("stripes_per_unit", count);
            if (source == MetalSource::curvature) program.set("object_size", 2.0f * mesh.bounds.radius());
            program.set("natural_unit", source == MetalSource::around_axis ? sets_around(metal) : metal.sets);
        }
    }
};

/// Lays out what is to be drawn for the first time, and drops what nothing carries any more.
void update_layouts(const World& world, MetalFrame& frame) {
    const DrawList& list = world.resource<DrawList>();
    const DrawClaims& claims = world.resource<DrawClaims>();
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        if (claims.shading[i] != shading_name) continue;
        const DrawnMetal drawn(world, list.items[i].entity);
        if (!drawn.by_angle) frame.want_layout(drawn.layout_key(), drawn.mesh, drawn.metal);
    }
    frame.lay_out_wanted();
    if (!frame.may_forget()) return;
    std::unordered_set<std::uint64_t> carried;
    world.query<With<Metal>, With<Surface>>().each(
        [&](Entity entity) { carried.insert(DrawnMetal(world, entity).layout_key()); });
    frame.surfaces.forget_but(list.items, carried);
}

SurfaceShading shading(World& world, MetalFrame& frame) {
    const auto ramp = [&world, &frame](Entity entity) -> const RampBuffer& {
        return frame.ramp(DrawnMetal(world, entity).stripe_set());
    };
    return {
        .name = shading_name,
        .fragment = "metal/metal.frag",
        .defines =
            [&world](Entity entity, auto& defines) {
                DrawnMetal(world, entity).add_defines(defines);
                add_light_defines(world.resource<LightList>(), defines);
            },
        .uniforms = [&world, ramp](Entity entity,
                                   auto& program) { DrawnMetal(world, entity).set_uniforms(program, ramp(entity)); },
        .vertex = "metal/metal.vert",
        .bind = [ramp](const DrawItem& item) { ramp(item.entity).buffer.bind_base(gpu::BufferBinding::uniform, 2); },
        .vertex_array = [&world, &frame](const DrawItem& item) -> const gpu::VertexArray* {
            const DrawnMetal drawn(world, item.entity);
            if (drawn.by_angle) return nullptr;
            return frame.surfaces.vertex_array(drawn.mesh, item, drawn.layout_key());
        }};
}

void declare_pass(World& world) {
    MetalFrame& frame = world.resource_mutable<MetalFrame>();
    frame.begin();
    update_layouts(world, frame);
    add_surface_pass(world, shading(world, frame), world.last_changed<Metal>());
}

} // namespace

void register_metal(App& app) {
    app.add_component<Metal>();
    app.world().set_resource(MetalFrame{});
    app.add_system(Stage::material, "metal.claim", claim_items).after("surface.collect").after("gooch.claim");
    app.add_system(Stage::render, "metal.pass", declare_pass).after("surface.passes").after("gooch.pass");
}

} // namespace hachure
