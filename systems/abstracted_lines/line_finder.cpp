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

void set_owners(const LineFindJob& job, const gpu::TextureDesc& desc, gpu::Program& program) {
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

gpu::TextureDesc LineFinder::found_desc(int width, int height) { return {width, height, gpu::Format::rgba16f}; }

/// `channels`: 1 for the diffuse one, 2 for the specular one, 3 for both.
gpu::ProgramSource LineFinder::program_source(const LineFindJob& job, int channels, Step step) {
    gpu::ProgramSource source{.vertex = job.candidates ? "common/marked.vert" : "common/full_screen.vert",
                              .fragment = step == Step::draw ? "abstracted_lines/draw_lines.frag"
                                                             : "abstracted_lines/lines.frag"};
    const auto define = [&](const char* name, const std::string& value) { source.defines.push_back({name, value}); };
    define("CHANNELS", std::to_string(channels));
    if (job.levels.size() > 1) define("STACK", "");
    if (job.object_ids == 0) define("UNIFORM_STYLE", "");
    if (step == Step::draw) return source;
    define("TAPS", std::to_string(static_cast<int>(job.quality.taps)));
    define("ITERATIONS", std::to_string(job.quality.iterations));
    if (const auto spacing = whole_spacing(job)) define("WHOLE_SPACING", std::to_string(*spacing));
    if (step == Step::compare) define(job.output == LineOutput::maps ? "MAPS" : "POINTS", "");
    return source;
}

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

void LineFinder::draw(RenderContext& render, const LineFindJob& job, int channels, Step step) const {
    const gpu::TextureDesc& desc = render.backend->texture(job.levels.front().texture).desc();
    gpu::Program& program = render.shaders->program(program_source(job, channels, step));
    if (step != Step::draw) program.set("search_width", job.width);
    if (step != Step::draw) program.set("least_curvature", job.least_curvature);
    if (job.object_ids) set_owners(job, desc, program);
    if (job.candidates) program.set("depth", 0.25f * static_cast<float>(channels));
    gpu::apply({.viewport = {0, 0, desc.width, desc.height},
                .scissor = job.rect,
                .depth_test = job.candidates ? gpu::DepthTest::equal : gpu::DepthTest::off,
                .blend = step == Step::draw ? gpu::Blend::premultiplied : gpu::Blend::off});
    if (job.object_ids) render.backend->texture(job.object_ids).bind(2);
    if (job.levels.size() > 1) render.backend->texture(job.widths).bind(3);
    program.use();
    const std::size_t passes = step == Step::draw ? 1 : std::max<std::size_t>(1, job.levels.size() - 1);
    for (std::size_t i = 0; i < passes; ++i) {
        if (step != Step::draw) render.backend->texture(job.levels[i].texture).bind(0);
        if (step != Step::draw && job.levels.size() > 1) {
            render.backend->texture(job.levels[i + 1].texture).bind(1);
            set_level(job, i, program);
        }
        render.full_screen.draw();
    }
}

/// What each pixel finds, for itself.
void LineFinder::find(RenderContext& render, const LineFindJob& job) const {
    const gpu::Framebuffer& found = render.backend->framebuffer({job.found[0], job.found[1]}, job.candidates);
    found.bind();
    // Middles of lines may be outside of where pixels are searched, by half a width and a pixel at most.
    const int reach = static_cast<int>(std::ceil(0.5 * std::max<double>(job.levels.back().width, job.width))) + 2;
    const gpu::Rect looked_at{job.rect.x - reach, job.rect.y - reach, job.rect.width + 2 * reach,
                              job.rect.height + 2 * reach};
    gpu::apply({.viewport = {0, 0, found.width(), found.height()},
                .scissor = looked_at,
                .depth_test = gpu::DepthTest::always,
                .depth_write = true});
    for (const int i : {0, 1}) found.clear_color(i, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    if (!job.candidates) return draw(render, job, 3, Step::find);
    found.clear_depth(1.0f);
    mark_candidates(render, job);
    for (const int channels : {1, 2, 3}) draw(render, job, channels, Step::find);
}

/// As far as pixels agree.
void LineFinder::write(RenderContext& render, const LineFindJob& job) const {
    job.target->bind();
    render.backend->texture(job.found[0]).bind(4);
    render.backend->texture(job.found[1]).bind(5);
    const Step step = job.output == LineOutput::layer ? Step::draw : Step::compare;
    if (!job.candidates) return draw(render, job, 3, step);
    for (const int channels : {1, 2, 3}) draw(render, job, channels, step);
}

void LineFinder::run(RenderContext& render, const LineFindJob& job) {
    HACHURE_ASSERT(!job.levels.empty() && !job.styles.empty(), "there is a tone image, and a style");
    HACHURE_ASSERT(job.target != nullptr && job.found[0] && job.found[1], "something to draw into");
    HACHURE_ASSERT(!job.candidates || job.levels.size() == 1, "candidates are of one width");
    upload(job);
    find(render, job);
    write(render, job);
}

} // namespace hachure
