#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/deform/deform_pass.h>
#include <hachure/systems/deform/gpu_deformer.h>

namespace hachure {
namespace {

/// It writes buffers, which the frame graph does not know: a side effect, declared before what draws from them. Those
/// passes depend on the DrawList, whose key changes with every shape.
struct DeformPass {};

void declare_pass(World& world) {
    RenderContext* render = world.find_resource<RenderContext>();
    const DrawList* list = world.find_resource<DrawList>();
    if (!render || !list) return; // nothing is drawn
    GpuDeformer& deformer = world.resource_mutable<GpuDeformer>();
    if (!deformer.plan(*list, world.resource<DeformInputs>(), *render)) return;
    render->graph.add_pass<DeformPass>(
        "deform",
        [&](gpu::PassBuilder& pass, DeformPass&) {
            pass.side_effect();
            pass.depends_on(deformer.runs());
        },
        [&world, render, &deformer](const DeformPass&, gpu::PassContext&) {
            deformer.run(world.resource<MeshStore>(), world.resource<DeformInputs>(), *render);
        });
}

} // namespace

void register_deform_pass(App& app) {
    app.world().set_resource(DeformInputs{});
    app.world().set_resource(GpuDeformer{});
    app.add_system(Stage::render, "deform.pass", declare_pass)
        .before("surface.passes")
        .before("gooch.pass")
        .before("edge_lines.pass")
        .before("velocity.pass")
        .before("compose.passes");
}

} // namespace hachure
