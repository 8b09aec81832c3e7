#include <hachure/runtime/assert.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/abstracted_lines/line_finder.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace hachure {
namespace {

/// The spacing of taps where it is a whole number of texels, so that the first fit needs no filtering.
std::optional<int> whole_spacing(const LineFindJob& job) {
    if (job.levels.size() > 1 || job.quality.taps == ToneTaps::wide) return {};
    const double spacing = 0.5 * double(job.width);
    if (spacing != std::floor(spacing)) return {};
    return static_cast<int>(spacing);
}

/// `channels`: 1 for the diffuse one, 2 for the specular one, 3 for both.
gpu::ProgramSource program_source(const LineFindJob& job, int channels) {
    gpu::ProgramSource source{.vertex = job.mark_first ? "abstracted_lines/marked.vert" : "common/full_screen.vert",
                              .fragment = "abstracted_lines/lines.frag"};
    const auto define = [&](const char* name, const std::string& value) { source.defines.push_back({name, value}); };
    define("CHANNELS", std::to_string(channels));
    define("TAPS", std::to_string(static_cast<int>(job.quality.taps)));
    define("ITERATIONS", std::to_string(job.quality.iterations));
    if (const auto spacing = whole_spacing(job)) define("WHOLE_SPACING", std::to_string(*spacing));
    if (job.levels.size() > 1) define("STACK", "");
    if (job.object_ids == 0) define("UNIFORM_STYLE", "");
    if (job.output == LineOutput::maps) define("MAPS", "");
    if (job.output == LineOutput::points) define("POINTS", "");
    return source;
}

void set_uniforms(const LineFindJob& job, const gpu::TextureDesc& desc, gpu::Program& program) {
    program.set("search_width", job.width);
    program.set("least_curvature", job.least_curvature);
    if (job.object_ids == 0) return;
    program.set("object_area", glm::ivec4(0, 0, desc.width - 1, desc.height - 1));
    const double widest = std::max<double>(job.levels.back().width, job.width);
    program.set("owner_reach", static_cast<float>(std::ceil(widest)));
}

/// The least threshold of each kind of line that some style draws.
glm::vec4 least_thresholds(std::span<const ToneLineStyle> styles) {
    glm::vec4 least(std::numeric_limits<float>::max());
    for (const ToneLineStyle& style : styles) {
        const glm::vec4& limits = style.thresholds;
        const glm::vec4 of_kind(limits.x, limits.z, limits.z, limits.x);
        for (int kind = 0; kind < 4; ++kind)
            if (style.kinds[kind] > 0.0f && style.line.w > 0.0f) least[kind] = std::min(least[kind], of_kind[kind]);
    }
    return least;
}

void set_level(const LineFindJob& job, std::size_t i, gpu::Program& program) {
    program.set("level_widths", glm::vec2(job.levels[i].width, job.levels[i + 1].width));
    program.set("first_level", i == 0);
    program.set("last_level", i + 2 == job.levels.size());
}

} // namespace

void LineFinder::upload(const LineFindJob& job) {
    const bool uniform = job.object_ids == 0;
    const std::span<const ToneLineStyle> styles = uniform ? job.styles.first(1) : job.styles;
    if (buffer_.bytes() != styles.size_bytes() || uniform != uniform_)
        buffer_ = gpu::Buffer(styles.size_bytes(), gpu::BufferUsage::dynamic, "abstracted line styles");
    uniform_ = uniform;
    buffer_.update(styles);
    if (uniform)
        buffer_.bind_base(gpu::BufferBinding::uniform, 2);
    else
        buffer_.bind_base(gpu::BufferBinding::storage, 0);
}

void LineFinder::mark_candidates(RenderContext& render, const LineFindJob& job) const {
    const int spacing = std::max(1, static_cast<int>(std::lround(0.5f * job.width)));
    const int taps = std::min(static_cast<int>(job.quality.taps), 1); // of a 5 x 5 fit the 3 x 3 tells enough
    gpu::Program& program = render.shaders->program(
        {.vertex = "common/full_screen.vert",
         .fragment = "abstracted_lines/candidates.frag",
         .defines = {{"TAPS", std::to_string(taps)}, {"WHOLE_SPACING", std::to_string(spacing)}}});
    program.set("thresholds", least_thresholds(job.styles));
    program.set("slack", whole_spacing(job) ? 1.0f : 0.6f);
    const gpu::TextureDesc& desc = render.backend->texture(job.levels.front().texture).desc();
    gpu::apply({.viewport = {0, 0, desc.width, desc.height},
                .scissor = job.rect,
                .depth_test = gpu::DepthTest::always,
                .depth_write = true,
                .color_write = {false, false, false, false}});
    render.backend->texture(job.levels.front().texture).bind(0);
    program.use();
    render.full_screen.draw();
}

void LineFinder::search(RenderContext& render, const LineFindJob& job, int channels) const {
    const gpu::TextureDesc& desc = render.backend->texture(job.levels.front().texture).desc();
    gpu::Program& program = render.shaders->program(program_source(job, channels));
    set_uniforms(job, desc, program);
    program.set("depth", 0.25f * static_cast<float>(channels));
    gpu::apply({.viewport = {0, 0, desc.width, desc.height},
                .scissor = job.rect,
                .depth_test = job.mark_first ? gpu::DepthTest::equal : gpu::DepthTest::off,
                .blend = job.output == LineOutput::layer ? gpu::Blend::premultiplied : gpu::Blend::off});
    if (job.object_ids) render.backend->texture(job.object_ids).bind(2);
    program.use();
    const std::size_t passes = std::max<std::size_t>(1, job.levels.size() - 1);
    for (std::size_t i = 0; i < passes; ++i) {
        render.backend->texture(job.levels[i].texture).bind(0);
        if (job.levels.size() > 1) {
            render.backend->texture(job.levels[i + 1].texture).bind(1);
            render.backend->texture(job.widths).bind(3);
            set_level(job, i, program);
        }
        render.full_screen.draw();
    }
}

void LineFinder::run(RenderContext& render, const LineFindJob& job) {
    HACHURE_ASSERT(!job.levels.empty() && !job.styles.empty(), "there is a tone image, and a style");
    HACHURE_ASSERT(!job.mark_first || job.levels.size() == 1, "candidates are of one width");
    upload(job);
    if (!job.mark_first) return search(render, job, 3);
    mark_candidates(render, job);
    for (const int channels : {1, 2, 3}) search(render, job, channels);
}

} // namespace hachure
