#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/line_layer.h>
#include <hachure/runtime/scene/stroke_set.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/abstracted_lines/stroke_passes.h>
#include <hachure/systems/abstracted_lines/tone_line_frame.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace hachure {
namespace {

using gpu::TextureHandle;

/// The textures that strokes are made of.
struct RidgeTextures {
    TextureHandle points, directions, specular_points, specular_directions, owners, depth;
};

struct BuildPass {
    RidgeTextures from;
};

struct DrawPass {
    RidgeTextures from;
    LineTarget lines;
    TextureHandle coverage;
};

RidgeTextures read_all(gpu::FrameGraph& graph, gpu::PassBuilder& pass) {
    const auto read = [&](const char* name) { return pass.read(graph.find(name)); };
    return {read("ridge_points"),          read("ridge_directions"),
            read("specular_ridge_points"), read("specular_ridge_directions"),
            read("ridge_owner"),           read("depth_buffer")};
}

/// What strokes depend on besides those textures.
void depend_on_strokes(World& world, gpu::PassBuilder& pass) {
    pass.depends_on(world.resource<DrawList>().key, world.last_changed<AbstractedLines>(),
                    world.resource<StrokeFrame>().forgotten,
                    world.resource_mutable<RenderContext>().shaders->generation());
}

std::vector<glm::vec4> read_vectors(const gpu::Texture& texture) {
    const std::vector<float> values = texture.read_floats(gpu::RowOrder::bottom_first);
    std::vector<glm::vec4> result(values.size() / 4);
    std::memcpy(result.data(), values.data(), values.size() * sizeof(float));
    return result;
}

RidgeMaps read_maps(RenderContext& render, const RidgeTextures& from, const StrokeFrame& frame,
                    gpu::PassContext& pass) {
    const auto texture = [&](TextureHandle handle) -> const gpu::Texture& {
        return render.backend->texture(pass.texture(handle));
    };
    RidgeMaps maps;
    maps.width = texture(from.points).width();
    maps.height = texture(from.points).height();
    maps.points = read_vectors(texture(from.points));
    maps.directions = read_vectors(texture(from.directions));
    maps.specular_points = read_vectors(texture(from.specular_points));
    maps.specular_directions = read_vectors(texture(from.specular_directions));
    maps.owners = texture(from.owners).read_uints(gpu::RowOrder::bottom_first);
    maps.depths = texture(from.depth).read_floats(gpu::RowOrder::bottom_first);
    for (std::uint32_t& owner : maps.owners)
        if (owner >= frame.owners.size() || !frame.owners[owner].entity) owner = 0;
    return maps;
}

void describe_segments(gpu::VertexArray& vertex_array) {
    const auto attribute = [&](unsigned location, int components, std::size_t offset) {
        vertex_array.set_attribute(
            {.location = location, .components = components, .offset = static_cast<unsigned>(offset)});
    };
    attribute(0, 4, offsetof(StrokeSegment, start));
    attribute(1, 2, offsetof(StrokeSegment, half_width));
    attribute(2, 2, offsetof(StrokeSegment, opacity));
    attribute(3, 2, offsetof(StrokeSegment, arc));
    attribute(4, 2, offsetof(StrokeSegment, ends));
    attribute(5, 3, offsetof(StrokeSegment, ahead));
    attribute(6, 3, offsetof(StrokeSegment, weights));
    attribute(7, 2, offsetof(StrokeSegment, turn));
}

} // namespace

void StrokePasses::declare(World& world) {
    const StrokeFrame& frame = world.resource<StrokeFrame>();
    if (frame.owners.empty()) return;
    // Ahead of the passes: a fault of a file ends the frame before anything is drawn.
    for (const StrokeOwner& owner : frame.owners)
        if (owner.entity && owner.lines.method == ToneLineMethod::strokes)
            static_cast<void>(textures_.get(owner.lines.stroke_texture));
    declare_build(world);
    if (frame.drawn) declare_draw(world);
}

void StrokePasses::declare_build(World& world) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    render.graph.add_pass<BuildPass>(
        "strokes",
        [&](gpu::PassBuilder& pass, BuildPass& data) {
            data.from = read_all(render.graph, pass);
            depend_on_strokes(world, pass);
            pass.side_effect();
        },
        [this, &world, &render](const BuildPass& data, gpu::PassContext& pass) {
            const StrokeFrame& frame = world.resource<StrokeFrame>();
            StrokeSet& set = world.resource_mutable<StrokeSet>();
            builder_.build(read_maps(render, data.from, frame, pass), frame, world.resource<View>(), set);
            batches_.fill(set);
            uploaded_ = false;
        });
}

void StrokePasses::declare_draw(World& world) {
    RenderContext& render = world.resource_mutable<RenderContext>();
    gpu::FrameGraph& graph = render.graph;
    const View& view = world.resource<View>();
    const gpu::Rect rect = world.resource<ToneLineFrame>().rects.lines;
    graph.add_pass<DrawPass>(
        "stroke_lines",
        [&](gpu::PassBuilder& pass, DrawPass& data) {
            data.from = read_all(graph, pass); // for what the strokes depend on
            const gpu::TextureDesc desc{view.width, view.height, gpu::Format::rgba16f};
            data.lines = write_line_layer(world, pass);
            data.coverage = pass.create("stroke_coverage", desc);
            depend_on_strokes(world, pass);
            pass.draws_in(rect);
        },
        [this, &world, &render, rect](const DrawPass& data, gpu::PassContext& pass) {
            bind_line_layer(world, pass, data.lines);
            const gpu::Framebuffer& layer = render.backend->framebuffer({pass.texture(data.lines.layer)});
            const gpu::Rect all{0, 0, layer.width(), layer.height()};
            const std::array nothing{0.0f, 0.0f, 0.0f, 0.0f};
            upload();
            for (const StrokeGroup& group : batches_.groups) {
                const gpu::Framebuffer& coverage = render.backend->framebuffer({pass.texture(data.coverage)});
                coverage.bind();
                gpu::apply({.viewport = all, .scissor = rect});
                coverage.clear_color(0, nothing);
                gpu::apply({.viewport = all, .scissor = rect, .blend = gpu::Blend::max});
                render.view_uniforms.bind(world.resource<View>(), world.resource<LightList>());
                for (const StrokeBatch& batch : group.batches) draw(world, render, batch, group.color);
                layer.bind();
                render.draw_full_screen("compose/overlay.frag",
                                        {.viewport = all, .scissor = rect, .blend = gpu::Blend::premultiplied},
                                        {pass.texture(data.coverage)});
            }
        });
}

void StrokePasses::upload() {
    if (uploaded_ || batches_.segments.empty()) return;
    const std::span<const StrokeSegment> segments(batches_.segments);
    if (buffer_.bytes() < segments.size_bytes()) {
        // Room to grow by half: the count changes with every view.
        buffer_ = gpu::Buffer(segments.size_bytes() + segments.size_bytes() / 2, gpu::BufferUsage::dynamic, "strokes");
        vertex_array_ = gpu::VertexArray("strokes");
        describe_segments(vertex_array_);
        vertex_array_.set_vertex_buffer(0, buffer_, sizeof(StrokeSegment), 0, 1);
    }
    buffer_.update(segments);
    uploaded_ = true;
}

void StrokePasses::draw(World& world, RenderContext& render, const StrokeBatch& batch, const glm::vec3& color) {
    const StrokeOwner& owner = world.resource<StrokeFrame>().owners[batch.owner];
    const StrokeTexture& ink = textures_.get(owner.lines.stroke_texture);
    const TextureOctaves octaves = texture_octaves(owner.lines.texture_length * owner.width, owner.pixels_per_unit);
    gpu::Program& program =
        render.shaders->program({.vertex = "abstracted_lines/stroke.vert", .fragment = "abstracted_lines/stroke.frag"});
    program.set("color", color);
    program.set("taper", owner.lines.taper);
    program.set("fade", owner.lines.fade);
    program.set("texture_strength", owner.lines.texture_strength);
    program.set("texture_length", octaves.length);
    program.set("octave_blend", octaves.blend);
    program.set("mean_ink", ink.mean);
    ink.texture.bind(0);
    program.use();
    vertex_array_.bind();
    gpu::gl().DrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(batch.count), batch.first);
}

} // namespace hachure
