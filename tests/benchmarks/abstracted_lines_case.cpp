#include <hachure/components/abstracted_lines.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/gpu/gl.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/benchmarks/abstracted_lines_case.h>
#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/line_sweep.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>

namespace hachure::bench {
namespace {

assets::Model benchmark_model(const std::filesystem::path& path, bool quick) {
    if (!quick) return assets::read_model(path.empty() ? "/usr/share/glmark2/models/bunny.obj" : path);
    const geometry::Shape shape = geometry::torus(1.0, 0.4, 48, 24);
    assets::Model model;
    model.meshes.push_back(
        {"torus", {{.positions = shape.positions, .normals = shape.normals, .indices = shape.indices}}, {}});
    model.nodes.push_back({.name = "torus", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    return model;
}

/// A model with lines, and a camera around it.
class Stage {
public:
    Stage(gpu::Context& context, const std::filesystem::path& path, bool quick)
        : scene_(context, quick ? Canvas{64, 48} : Canvas{1024, 768}) {
        model_ = spawn_model(scene_.world(), benchmark_model(path, quick));
        for (const Entity camera : model_.cameras) scene_.world().remove<Camera>(camera);
        for (const glm::vec3& p : model_.points) bounds_.include(p);
        distance_ = bounds_.radius() / std::sin(0.3f);
        camera_ = scene_.add(Camera{.yfov = 0.6f, .znear = 0.05f * distance_}, {});
        turn(0.4f);
    }

    [[nodiscard]] World& world() { return scene_.world(); }
    [[nodiscard]] Renderer& renderer() { return scene_.renderer(); }
    [[nodiscard]] Entity camera() const { return camera_; }

    void draw_lines(bool wanted) {
        for (const Entity entity : model_.surfaces) {
            const bool has = world().has<AbstractedLines>(entity);
            if (wanted && !has) world().add(entity, AbstractedLines{});
            if (!wanted && has) world().remove<AbstractedLines>(entity);
        }
    }

    /// Around the model; `aside` looks past it.
    void turn(float angle, bool aside = false) {
        const glm::quat turn = glm::angleAxis(angle, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.3f, glm::vec3(1, 0, 0));
        world().get_mutable<Transform>(camera_) = {
            .translation = bounds_.center() + turn * glm::vec3(aside ? 9.0f * distance_ : 0.0f, 0.0f, distance_),
            .rotation = turn};
    }

    double frame_ms() {
        const double start = now_ms();
        renderer().render_frame();
        renderer().finish();
        return now_ms() - start;
    }

private:
    test::DrawnScene scene_;
    SpawnedModel model_;
    geometry::Bounds bounds_;
    float distance_ = 1.0f;
    Entity camera_;
};

double timed(const auto& work) {
    const double start = now_ms();
    work();
    gpu::gl().Finish();
    return now_ms() - start;
}

} // namespace

test::Tones tones_of(const assets::Image& image) {
    test::Tones tones(image.width, image.height);
    const float* pixels = image.f32();
    const auto channels = static_cast<std::size_t>(image.channels);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            tones.at(x, image.height - 1 - y) =
                pixels[channels * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                   static_cast<std::size_t>(x))];
    return tones;
}

SceneTones scene_tones(gpu::Context& context, const std::filesystem::path& model, bool quick) {
    Stage stage(context, model, quick);
    stage.draw_lines(true);
    stage.renderer().render_frame();
    SceneTones tones;
    tones.rects = stage.world().resource<ToneLineFrame>().rects; // before buffers are wanted whole
    stage.renderer().request_aov("tone");
    stage.renderer().request_aov("tone_specular");
    stage.renderer().render_frame();
    tones.diffuse = tones_of(stage.renderer().read_aov("tone"));
    tones.specular = tones_of(stage.renderer().read_aov("tone_specular"));
    return tones;
}

FrameCost frame_cost(gpu::Context& context, const std::filesystem::path& model, const ToneImage& quality, int frames,
                     bool quick) {
    Stage stage(context, model, quick);
    stage.world().add(stage.camera(), quality);
    const auto added = [&](bool aside) {
        std::vector<double> differences;
        for (int i = -2; i < frames; ++i) {
            stage.turn(0.02f * static_cast<float>(i), aside);
            stage.draw_lines(false);
            const double plain = stage.frame_ms();
            stage.turn(0.02f * static_cast<float>(i) + 0.01f, aside);
            stage.draw_lines(true);
            const double lined = stage.frame_ms();
            if (i >= 0) differences.push_back(lined - plain);
        }
        return median(differences);
    };
    return {added(false), added(true)};
}

std::vector<double> tone_costs(gpu::Context& context, const std::vector<int>& samples, int rounds, bool quick) {
    Stage stage(context, {}, quick);
    stage.draw_lines(true);
    stage.world().add(stage.camera(), ToneImage{});
    std::vector<double> least(samples.size(), std::numeric_limits<double>::max());
    for (int i = -1; i < rounds; ++i)
        for (std::size_t k = 0; k < samples.size(); ++k) {
            stage.world().get_mutable<ToneImage>(stage.camera()) = {.quality = ToneQuality::custom,
                                                                    .samples = samples[k]};
            stage.turn(0.4f + 1e-4f * static_cast<float>(i)); // or the pass keeps its result
            stage.renderer().render_frame();
            stage.renderer().finish();
            for (const gpu::PassStats& pass : stage.renderer().pass_stats())
                if (pass.name == "tone" && i >= 0) least[k] = std::min(least[k], pass.gpu_ms.value_or(pass.cpu_ms));
        }
    return least;
}

NineFetches::NineFetches(int width, int height)
    : from_({width, height, gpu::Format::rg16f}, "from"), to_({width, height, gpu::Format::rg16f}, "to"),
      framebuffer_({&to_}, nullptr, "nine fetches") {
    constexpr const char* fragment = R"(#version 450 core
layout(binding = 0) uniform sampler2D tones;
layout(location = 0) out vec2 out_tones;
void main() {
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(tones, 0) - 1;
    vec2 sum = vec2(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) sum += texelFetch(tones, clamp(here + ivec2(x, y), ivec2(0), last), 0).rg;
    out_tones = sum / 9.0;
}
)";
    constexpr const char* vertex = R"(#version 450 core
void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
)";
    const std::array stages = {gpu::ShaderStage{GL_VERTEX_SHADER, {.text = vertex}},
                               gpu::ShaderStage{GL_FRAGMENT_SHADER, {.text = fragment}}};
    program_ = gpu::Program(stages, "nine fetches");
    from_.clear(std::array{0.5f, 0.5f, 0.0f, 0.0f});
}

void NineFetches::run() const {
    framebuffer_.bind();
    gpu::apply({.viewport = {0, 0, to_.width(), to_.height()}});
    from_.bind(0);
    program_.use();
    full_screen_.draw();
}

namespace {

/// A finding that is ready to be timed.
class TimedFinding {
public:
    TimedFinding(RenderContext& render, const Finding& finding, const SceneTones& tones)
        : steps_(render, lines_of(finding), finding.quality, tones.diffuse.width, tones.diffuse.height) {
        steps_.confine(tones.rects);
        steps_.upload(tones.diffuse, &tones.specular);
    }

    double blur_ms() {
        return timed([&] { steps_.blur(); });
    }
    double lines_ms() {
        return timed([&] { steps_.search(LineOutput::layer); });
    }

private:
    static AbstractedLines lines_of(const Finding& finding) {
        AbstractedLines lines;
        lines.width = static_cast<float>(finding.width), lines.beta = finding.beta;
        return lines;
    }

    test::LineFinding steps_;
};

} // namespace

Cost cost_of(RenderContext& render, const Finding& finding, const SceneTones& tones, int rounds) {
    TimedFinding steps(render, finding, tones);
    const NineFetches floor(tones.diffuse.width, tones.diffuse.height);
    std::vector<double> blur, search, fetches;
    for (int i = -2; i < rounds; ++i) {
        const double a = timed([&] { floor.run(); });
        const double b = steps.blur_ms(), c = steps.lines_ms();
        if (i < 0) continue; // programs are compiled
        fetches.push_back(a), blur.push_back(b), search.push_back(c);
    }
    return {median(blur), median(search), median(fetches)};
}

std::vector<Cost> costs_of(RenderContext& render, const std::vector<Finding>& findings, const SceneTones& tones,
                           int rounds) {
    std::deque<TimedFinding> steps; // which does not move what it holds
    for (const Finding& finding : findings) steps.emplace_back(render, finding, tones);
    const NineFetches fetches(tones.diffuse.width, tones.diffuse.height);
    constexpr double never = std::numeric_limits<double>::max();
    std::vector<Cost> least(findings.size(), {never, never, never});
    double floor = never;
    for (int i = -1; i < rounds; ++i)
        for (std::size_t k = 0; k < findings.size(); ++k) {
            const double a = timed([&] { fetches.run(); });
            const double b = steps[k].blur_ms(), c = steps[k].lines_ms();
            if (i < 0) continue; // programs are compiled
            floor = std::min(floor, a);
            least[k].blur_ms = std::min(least[k].blur_ms, b), least[k].lines_ms = std::min(least[k].lines_ms, c);
        }
    for (Cost& cost : least) cost.floor_ms = floor;
    return least;
}

Accuracy accuracy_of(RenderContext& render, const Finding& finding, const std::vector<double>& widths, double contrast,
                     int angles) {
    Accuracy accuracy;
    double squares = 0.0;
    for (const double width : widths) {
        const test::LineSweep sweep{
            .width = width, .contrast = contrast, .beta = finding.beta, .quality = finding.quality, .angles = angles};
        const test::LineScore score = sweep.score(render, test::profile::Bar{0.5 * width});
        squares += score.rms() * score.rms();
        accuracy.recall = std::min(accuracy.recall, score.recall());
        accuracy.precision = std::min(accuracy.precision, score.precision());
        accuracy.band = std::max(accuracy.band, std::abs(score.band() - 1.0));
    }
    accuracy.rms = std::sqrt(squares / static_cast<double>(widths.size()));
    return accuracy;
}

} // namespace hachure::bench
