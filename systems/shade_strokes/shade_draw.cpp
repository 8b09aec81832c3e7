#include <hachure/runtime/gpu/gl.h>
#include <hachure/systems/shade_strokes/shade_draw.h>
#include <hachure/systems/shade_strokes/stroke_layout.h>
#include <hachure/systems/shade_strokes/stroke_tip.h>
#include <hachure/systems/shade_strokes/zigzag_tables.h>

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hachure {
namespace {

using gpu::BufferBinding;

constexpr int most_fine_samples = 4;
constexpr std::int64_t most_texels = std::int64_t{1} << 25;
constexpr std::int64_t most_side = 16384; // that every context has

/// Points of a zigzag are this many to the size of a model: strokes get no finer, however near they are.
constexpr float points_per_size = 4096.0f;
/// How far strokes lie off the surface besides what their nodes allow for, over that: across folds ribs are straight
/// between their points, too.
constexpr float hugging_margin = 3.0f;

void run_groups(gpu::Program& program, std::size_t threads) {
    program.use();
    gpu::gl().DispatchCompute(static_cast<GLuint>((threads + stroke_layout::group - 1) / stroke_layout::group), 1, 1);
    gpu::gl().MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

/// Two triangles for each four vertices.
gpu::Buffer ribbon_indices() {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t v = 0; v < 4 * stroke_layout::most_ribbons; v += 4)
        indices.insert(indices.end(), {v, v + 1, v + 2, v + 2, v + 1, v + 3});
    return gpu::Buffer(std::span<const std::uint32_t>(indices), "shade ribbons");
}

float scale_of(const glm::mat4& matrix) {
    return std::cbrt(std::max(std::abs(glm::determinant(glm::mat3(matrix))), 1e-30f));
}

/// Which side of a triangle is its front: -1 where the transform mirrors, else 1.
float front_of(const glm::mat4& matrix) { return glm::determinant(glm::mat3(matrix)) < 0.0f ? -1.0f : 1.0f; }

float pen_width(const ShadeStrokes& style) {
    return std::max(0.05f, style.line_width) * stroke_tip(style.tip).width / std::max(0.05f, style.intensity);
}

float stroke_opacity(const ShadeStrokes& style) { return std::clamp(style.opacity, 0.001f, 1.0f); }

} // namespace

StrokePatterns::StrokePatterns()
    : indices(ribbon_indices()), commands(stroke_layout::batches * sizeof(stroke_layout::DrawCommand),
                                          gpu::BufferUsage::immutable, "shade draw commands") {
    const ZigzagTables tables = make_zigzag_tables();
    zigzags = gpu::Buffer(std::span<const glm::vec2>(tables.point), "shade zigzags");
}

int fine_samples(int width, int height) {
    const auto fits = [&](std::int64_t samples) {
        return samples * std::max(width, height) <= most_side && samples * samples * width * height <= most_texels;
    };
    int samples = most_fine_samples;
    while (samples > 1 && !fits(samples)) --samples;
    return samples;
}

void ShadeStrokeDraw::find() const {
    if (buffers->segment_count() == 0) return;
    place_ribs();
    look_at_segments();
    list_segments();
}

void ShadeStrokeDraw::place_ribs() const {
    gpu::ProgramSource source{.compute = "shade_strokes/ribs.comp"};
    if (buffers->shares) source.defines.push_back({"NARROWED", ""});
    gpu::Program& program = shaders->program(source);
    program.set("node_count", buffers->node_count());
    program.set("triangle_count", triangles);
    program.set("world_from_mesh", world_from_mesh);
    indices->bind_base(BufferBinding::storage, 0);
    buffers->nodes.bind_base(BufferBinding::storage, 1);
    buffers->ribs.bind_base(BufferBinding::storage, 2);
    positions->bind_base(BufferBinding::storage, 3);
    if (buffers->shares) buffers->shares.bind_base(BufferBinding::storage, 4);
    run_groups(program, buffers->node_count());
}

void ShadeStrokeDraw::look_at_segments() const {
    gpu::Program& program = shaders->program({.compute = "shade_strokes/segments.comp"});
    program.set("segment_count", buffers->segment_count());
    program.set("unit", size / points_per_size);
    program.set("world_scale", scale_of(world_from_mesh));
    program.set("front", front_of(world_from_mesh));
    program.set("line_width", pen_width(style));
    program.set("solid", stroke_tip(style.tip).solid);
    program.set("density", std::max(0.01f, style.density));
    program.set("darkness", full_darkness);
    program.set("opacity", stroke_opacity(style));
    buffers->segments.bind_base(BufferBinding::storage, 0);
    patterns->zigzags.bind_base(BufferBinding::storage, 3);
    buffers->delivered.bind_base(BufferBinding::storage, 4);
    buffers->seen.bind_base(BufferBinding::storage, 5);
    buffers->counts.bind_base(BufferBinding::storage, 6);
    run_groups(program, buffers->segment_count());
}

void ShadeStrokeDraw::list_segments() const {
    const std::size_t groups = (buffers->segment_count() + stroke_layout::group - 1) / stroke_layout::group;
    gpu::Program& commands = shaders->program({.compute = "shade_strokes/commands.comp"});
    commands.set("group_count", static_cast<std::uint32_t>(groups));
    patterns->commands.bind_base(BufferBinding::storage, 7);
    run_groups(commands, 1);
    gpu::Program& list = shaders->program({.compute = "shade_strokes/list.comp"});
    list.set("segment_count", buffers->segment_count());
    buffers->list.bind_base(BufferBinding::storage, 7);
    run_groups(list, buffers->segment_count());
    gpu::gl().MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

void ShadeStrokeDraw::draw(const gpu::Texture& depth, bool coverage) const {
    if (buffers->segment_count() == 0) return;
    gpu::ProgramSource source{.vertex = "shade_strokes/strokes.vert", .fragment = "shade_strokes/strokes.frag"};
    source.defines.push_back({"SAMPLES", std::to_string(samples)});
    if (coverage) source.defines.push_back({"COVERAGE", ""});
    gpu::Program& program = shaders->program(source);
    const StrokeTip tip = stroke_tip(style.tip);
    program.set("front", front_of(world_from_mesh));
    program.set("flicker", std::clamp(style.flicker, 0.0f, 1.0f));
    program.set("tick", tick);
    program.set("color", style.color);
    program.set("opacity", stroke_opacity(style));
    program.set("lift", tip.lift);
    program.set("grain", tip.grain);
    program.set("hugging", hugging_margin * hugging * size * scale_of(world_from_mesh));
    depth.bind(0);
    buffers->ribs.bind_base(BufferBinding::storage, 2);
    patterns->zigzags.bind_base(BufferBinding::storage, 3);
    buffers->seen.bind_base(BufferBinding::storage, 5);
    program.use();
    buffers->vertex_array.set_index_buffer(patterns->indices);
    buffers->vertex_array.bind();
    patterns->commands.bind(GL_DRAW_INDIRECT_BUFFER);
    gpu::gl().MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr,
                                        static_cast<GLsizei>(stroke_layout::batches), 0);
}

} // namespace hachure
