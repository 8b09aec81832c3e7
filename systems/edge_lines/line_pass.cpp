#include <hachure/components/edge_lines.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/surface_renderer.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/edge_lines/line_frame.h>
#include <hachure/systems/edge_lines/line_pass.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace hachure {
namespace {

/// Probes of depth per pixel and axis. One leaves lines a pixel off where features are small, four cost four times as
/// much as two (docs/edge-lines.md).
constexpr int probes_per_pixel = 2;

struct LinePass {
    gpu::TextureHandle layer, hidden_layer, coverage, probe_depth, probe_slope;
    ImageLines::Textures image;
};

/// A line pass while it runs.
class LineDrawing {
public:
    LineDrawing(World& world, const LinePass& data, gpu::PassContext& pass)
        : world_(world), render_(world.resource_mutable<RenderContext>()),
          frame_(world.resource_mutable<EdgeLineFrame>()), view_(world.resource<View>()), data_(data), pass_(pass) {}

    void run() {
        if (data_.probe_depth) draw_probes();
        draw_layer(data_.layer, frame_.picture.groups(), frame_.image.any());
        if (data_.hidden_layer) draw_layer(data_.hidden_layer, frame_.hidden.groups(), false);
    }

private:
    const gpu::Texture& texture(gpu::TextureHandle handle) const {
        return render_.backend->texture(pass_.texture(handle));
    }

    gpu::DrawState line_state(gpu::Blend blend) const {
        return {.viewport = {0, 0, view_.width, view_.height}, .scissor = frame_.rect, .blend = blend};
    }

    void draw_probes() {
        const gpu::Framebuffer& framebuffer =
            render_.backend->framebuffer({pass_.texture(data_.probe_slope)}, pass_.texture(data_.probe_depth));
        framebuffer.bind();
        gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()},
                    .depth_test = gpu::DepthTest::always,
                    .depth_write = true});
        framebuffer.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
        framebuffer.clear_depth(0.0f);
        const gpu::Rect& rect = frame_.rect;
        draw_all_surfaces(world_, render_, "edge_lines/probe.frag",
                          {-rect.x * probes_per_pixel, -rect.y * probes_per_pixel, view_.width * probes_per_pixel,
                           view_.height * probes_per_pixel});
    }

    void bind_cleared(gpu::TextureHandle target, const std::optional<gpu::Rect>& where) {
        const gpu::Framebuffer& framebuffer = render_.backend->framebuffer({pass_.texture(target)});
        framebuffer.bind();
        gpu::DrawState state = line_state(gpu::Blend::off);
        state.scissor = where;
        gpu::apply(state);
        framebuffer.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    }

    /// Compose looks at the rectangle of all lines alone, who asks for the layer as an AOV at all of it.
    void clear_layer(gpu::TextureHandle layer) {
        const bool whole = !world_.resource<FrameRequests>().aovs.empty();
        bind_cleared(layer, whole ? std::nullopt : std::optional(world_.resource<LineLayer>().rect()));
    }

    /// The first group lies on nothing: it needs no layer of its own.
    void draw_layer(gpu::TextureHandle layer, std::span<const LineGroup> groups, bool with_image) {
        clear_layer(layer);
        if (with_image) {
            render_.view_uniforms.bind(view_, world_.resource<LightList>());
            frame_.image.draw(render_, pass_, data_.image, layer);
        }
        for (std::size_t i = 0; i < groups.size(); ++i) {
            const bool on_nothing = i == 0 && !with_image;
            if (!on_nothing) bind_cleared(data_.coverage, frame_.rect);
            draw_group(groups[i]);
            if (!on_nothing) lay_over(layer);
        }
    }

    void lay_over(gpu::TextureHandle layer) {
        render_.backend->framebuffer({pass_.texture(layer)}).bind();
        render_.draw_full_screen("compose/overlay.frag", line_state(gpu::Blend::premultiplied),
                                 {pass_.texture(data_.coverage)});
    }

    void draw_group(const LineGroup& group) {
        gpu::apply(line_state(gpu::Blend::max));
        render_.view_uniforms.bind(view_, world_.resource<LightList>());
        if (data_.probe_depth) {
            texture(data_.probe_depth).bind(0);
            texture(data_.probe_slope).bind(1);
        }
        for (const LineDraw& draw : group.draws) draw_lines(group, draw);
    }

    void draw_lines(const LineGroup& group, const LineDraw& draw) {
        gpu::ProgramSource source{.vertex = "edge_lines/edge_lines.vert", .fragment = "edge_lines/edge_lines.frag"};
        if (!draw.exact) source.defines.push_back({"PROBES", std::to_string(probes_per_pixel)});
        if (!draw.exact && draw.hidden) source.defines.push_back({"HIDDEN", ""});
        gpu::Program& program = render_.shaders->program(source);
        program.set("color", group.color);
        program.set("width_factor", draw.width_factor);
        program.set("taper", draw.taper);
        program.set("dash", draw.dash);
        program.set("probe_origin", glm::vec2(frame_.rect.x, frame_.rect.y));
        program.use();
        EdgeLineBatch& batch = frame_.batches.get(draw.entity);
        batch.upload();
        batch.vertex_array.bind();
        gpu::gl().DrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(draw.segments.count),
                                                  draw.segments.first);
    }

    World& world_;
    RenderContext& render_;
    EdgeLineFrame& frame_;
    const View& view_;
    const LinePass& data_;
    gpu::PassContext& pass_;
};

/// Sizes of probes grow in steps, so that a rectangle that moves with what it holds does not need new textures.
int stepped(int pixels) {
    constexpr int step = 64;
    return (pixels + step - 1) / step * step * probes_per_pixel;
}

void declare_textures(World& world, gpu::FrameGraph& graph, gpu::PassBuilder& pass, LinePass& data) {
    const EdgeLineFrame& frame = world.resource<EdgeLineFrame>();
    const View& view = world.resource<View>();
    const auto layer = [&](const char* name) {
        return pass.create(name, {view.width, view.height, gpu::Format::rgba16f});
    };
    data.layer = layer("line_layer");
    graph.publish("line_layer", data.layer);
    if (world.resource<FrameRequests>().wants("hidden_lines")) {
        data.hidden_layer = layer("hidden_lines");
        graph.publish("hidden_lines", data.hidden_layer);
    }
    if (frame.image.any()) data.image = frame.image.declare(graph, pass, view);
    if (frame.image.any() || frame.picture.groups().size() > 1 || frame.hidden.groups().size() > 1)
        data.coverage = layer("line_coverage");
    if (!frame.probes) return;
    const int width = stepped(frame.rect.width), height = stepped(frame.rect.height);
    data.probe_depth = pass.create("line_probe_depth", {width, height, gpu::Format::depth32f});
    data.probe_slope = pass.create("line_probe_slope", {width, height, gpu::Format::rg16f});
}

} // namespace

void declare_line_pass(World& world) {
    EdgeLineFrame& frame = world.resource_mutable<EdgeLineFrame>();
    // Here and not where edges are chosen, which happens on any thread: batches own buffers of the context.
    frame.batches.forget_all_but(frame.drawn);
    const FrameRequests& requests = world.resource<FrameRequests>();
    // Who asks for a layer of lines gets one, also when nothing is on it.
    const bool asked_for = requests.wants("line_layer") || requests.wants("hidden_lines");
    if (!asked_for && (frame.rect.width <= 0 || frame.rect.height <= 0)) return;
    RenderContext& render = world.resource_mutable<RenderContext>();
    const gpu::Rect cleared = world.resource<LineLayer>().rect();
    render.graph.add_pass<LinePass>(
        "edge_lines",
        [&](gpu::PassBuilder& pass, LinePass& data) {
            declare_textures(world, render.graph, pass, data);
            pass.depends_on(world.resource<DrawList>().key, world.last_changed<EdgeLines>(),
                            render.shaders->generation(), cleared);
            pass.draws_in(frame.rect);
        },
        [&world](const LinePass& data, gpu::PassContext& pass) { LineDrawing(world, data, pass).run(); });
}

} // namespace hachure
