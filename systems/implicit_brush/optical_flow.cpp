#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/optical_flow.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace hachure {
namespace {

constexpr int most_levels = 5;
constexpr int least_side = 12; ///< of the coarsest level
constexpr int iterations = 3;  ///< at each level

/// Textures of one level.
struct Level {
    std::uint32_t tones;                    ///< rg: before, now
    std::uint32_t even;                     ///< the same, whatever the exposure
    std::uint32_t even_sums;                ///< what they are made from, added up along rows
    std::array<std::uint32_t, 2> flow;      ///< to and fro
    std::array<std::uint32_t, 3> sums;      ///< terms of the least squares, by pixel
    std::array<std::uint32_t, 3> part_sums; ///< the same, added up along rows
};
constexpr std::size_t textures_of_level = 11;

struct Size {
    int width, height;
};

Size half(Size size) { return {(size.width + 1) / 2, (size.height + 1) / 2}; }

std::vector<Size> level_sizes(int width, int height) {
    std::vector<Size> sizes{half({width, height})};
    while (static_cast<int>(sizes.size()) < most_levels &&
           std::min(sizes.back().width, sizes.back().height) >= 2 * least_side)
        sizes.push_back(half(sizes.back()));
    return sizes;
}

/// Draws over all of the targets.
void draw(RenderContext& render, std::initializer_list<std::uint32_t> targets, const gpu::ProgramSource& source,
          std::initializer_list<std::uint32_t> textures) {
    const gpu::Framebuffer& framebuffer = render.backend->framebuffer(targets);
    framebuffer.bind();
    gpu::apply({.viewport = {0, 0, framebuffer.width(), framebuffer.height()}});
    GLuint unit = 0;
    for (const std::uint32_t id : textures) render.backend->texture(id).bind(unit++);
    render.shaders->program(source).use();
    render.full_screen.draw();
}

gpu::ProgramSource program_source(const char* fragment, std::initializer_list<const char*> defines = {}) {
    gpu::ProgramSource source{.vertex = "common/full_screen.vert", .fragment = fragment};
    for (const char* define : defines) source.defines.push_back({define, ""});
    return source;
}

/// Takes the exposure out of a level's tones.
void make_even(RenderContext& render, const Level& level) {
    draw(render, {level.even_sums}, program_source("implicit_brush/flow_even.frag", {"ROWS"}), {level.tones});
    draw(render, {level.even}, program_source("implicit_brush/flow_even.frag"), {level.tones, level.even_sums});
}

/// Makes the flow of one level from that of the coarser one, 0 for none, and returns it; its last texture is `to`
/// where that is not 0.
std::uint32_t refine(RenderContext& render, const Level& level, std::uint32_t coarser, std::uint32_t to) {
    std::uint32_t from = coarser;
    const char* start = coarser != 0 ? "ENLARGE" : "AT_REST";
    for (int i = 0; i < iterations; ++i) {
        const bool done = i + 1 == iterations && to != 0;
        const std::uint32_t target = done ? to : level.flow[i % 2];
        const std::uint32_t guess = from != 0 ? from : level.flow[1]; // not read at rest
        draw(render, {level.sums[0], level.sums[1], level.sums[2]},
             program_source("implicit_brush/flow_products.frag", {start}), {level.even, guess});
        draw(render, {level.part_sums[0], level.part_sums[1], level.part_sums[2]},
             program_source("implicit_brush/flow_rows.frag"), {level.sums[0], level.sums[1], level.sums[2]});
        draw(render, {target},
             program_source("implicit_brush/flow_solve.frag", {start, done ? "FULL_SIZE" : "HALF_SIZE"}),
             {level.part_sums[0], level.part_sums[1], level.part_sums[2], guess});
        from = target;
        start = "REFINE";
    }
    return from;
}

Level level_at(std::span<const std::uint32_t> scratch, std::size_t index) {
    const auto id = [&](std::size_t i) { return scratch[index * textures_of_level + i]; };
    return {id(0), id(1), id(2), {id(3), id(4)}, {id(5), id(6), id(7)}, {id(8), id(9), id(10)}};
}

} // namespace

gpu::TextureDesc OpticalFlowJob::flow_desc(int width, int height) {
    const Size size = half({width, height});
    return {size.width, size.height, gpu::Format::rg32f};
}

std::vector<gpu::TextureDesc> OpticalFlowJob::scratch(int width, int height) {
    std::vector<gpu::TextureDesc> result;
    using gpu::Format;
    for (const Size& size : level_sizes(width, height))
        for (const Format format :
             {Format::rg32f, Format::rg32f, Format::rgba32f, Format::rg32f, Format::rg32f, Format::rgba32f,
              Format::rgba32f, Format::r32f, Format::rgba32f, Format::rgba32f, Format::r32f})
            result.push_back({size.width, size.height, format});
    return result;
}

void OpticalFlowJob::run(RenderContext& render, std::span<const std::uint32_t> scratch) const {
    const std::size_t levels = scratch.size() / textures_of_level;
    draw(render, {level_at(scratch, 0).tones}, program_source("implicit_brush/flow_halve.frag", {"TWO_PICTURES"}),
         {before, now});
    for (std::size_t i = 1; i < levels; ++i)
        draw(render, {level_at(scratch, i).tones}, program_source("implicit_brush/flow_halve.frag"),
             {level_at(scratch, i - 1).tones});
    for (std::size_t i = 0; i < levels; ++i) make_even(render, level_at(scratch, i));
    std::uint32_t coarser = 0;
    for (std::size_t i = levels; i-- > 0;) coarser = refine(render, level_at(scratch, i), coarser, i == 0 ? to : 0);
}

} // namespace hachure
