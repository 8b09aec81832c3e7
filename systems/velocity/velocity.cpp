#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/velocity/motion_history.h>
#include <hachure/systems/velocity/velocity.h>

#include <array>

namespace hachure {
namespace {

struct VelocityPass {
    gpu::TextureHandle depth_buffer, velocity;
};

void draw_motion(RenderContext& render, const MotionHistory& history, const Motion& motion) {
    gpu::ProgramSource source{.vertex = "velocity/velocity.vert", .fragment = "velocity/velocity.frag"};
    if (motion.deforms) source.defines.push_back({"DEFORMED", ""});
    gpu::Program& program = render.shaders->program(source);
    program.set("world_from_entity", motion.world_from_entity);
    program.set("previous_clip_from_entity", history.previous_clip() * motion.previous_world);
    program.use();
    motion.vertex_array->bind();
    gpu::gl().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(motion.index_count), GL_UNSIGNED_INT, nullptr);
}

void draw(const World& world, RenderContext& render, const VelocityPass& data, gpu::PassContext& pass) {
    const View& view = world.resource<View>();
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer({pass.texture(data.velocity)});
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, view.width, view.height}});
    framebuffer.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    render.view_uniforms.bind(view, world.resource<LightList>());
    render.backend->texture(pass.texture(data.depth_buffer)).bind(0);
    const MotionHistory& history = world.resource<MotionHistory>();
    for (const Motion& motion : history.motions())
        if (motion.index_count > 0) draw_motion(render, history, motion);
}

void declare_pass(World& world) {
    if (!world.resource<FrameRequests>().wants("velocity")) return;
    RenderContext& render = world.resource_mutable<RenderContext>();
    const View& view = world.resource<View>();
    MotionHistory& history = world.resource_mutable<MotionHistory>();
    history.update(world.resource<MeshStore>(), render.meshes, world.resource<DrawList>(), view.clip_from_world);
    gpu::FrameGraph& graph = render.graph;
    graph.add_pass<VelocityPass>(
        "velocity",
        [&](gpu::PassBuilder& pass, VelocityPass& data) {
            data.depth_buffer = pass.read(graph.find("depth_buffer"));
            data.velocity = pass.create("velocity", {view.width, view.height, gpu::Format::rg32f});
            graph.publish("velocity", data.velocity);
            pass.depends_on(history.key(), render.shaders->generation());
        },
        [&world, &render](const VelocityPass& data, gpu::PassContext& pass) { draw(world, render, data, pass); });
}

} // namespace

void register_velocity(App& app) {
    frame_requests(app.world())
        .known.push_back({"velocity",
                          "motion on the screen since the frame before, pixels right and up; 0 in the first frame and "
                          "where nothing is drawn",
                          {"velocity.X", "velocity.Y"}});
    app.world().set_resource(MotionHistory{});
    app.add_system(Stage::render, "velocity.pass", declare_pass)
        .after("surface.passes")
        .after("gooch.pass")
        .after("metal.pass")
        .after("toon.pass")
        .after("edge_lines.pass")
        .after("abstracted_lines.pass")
        .before("compose.passes");
}

} // namespace hachure
