#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/gpu/gl.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/benchmarks/implicit_brush_convolution.h>
#include <hachure/tests/support/convolution_reference.h>
#include <hachure/tests/support/convolution_run.h>
#include <hachure/tests/support/drawn_scene.h>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

namespace hachure::bench {
namespace {

constexpr std::array method_names = {"automatic", "splat", "gather", "tiles", "sums"};
const char* name_of(BrushMethod method) { return method_names[static_cast<std::size_t>(method)]; }

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

/// What a brush weighs each pixel with, in a frame that its model fills half of.
struct BrushedFrame {
    int width = 0, height = 0;
    std::vector<float> weights; ///< the bottom row first
    double covered = 0.0;       ///< part of the pixels that show the model
};

BrushedFrame brushed_frame(gpu::Context& context, const std::filesystem::path& path, const ImplicitBrush& brush,
                           bool quick) {
    BrushedFrame frame{quick ? 64 : 1024, quick ? 48 : 768, {}};
    test::DrawnScene scene(context, Canvas{frame.width, frame.height});
    const SpawnedModel model = spawn_model(scene.world(), benchmark_model(path, quick));
    for (const Entity camera : model.cameras) scene.world().remove<Camera>(camera);
    for (const Entity surface : model.surfaces) scene.world().add(surface, brush);
    geometry::Bounds bounds;
    for (const glm::vec3& p : model.points) bounds.include(p);
    const float distance = 0.6f * bounds.radius() / std::sin(0.3f);
    const glm::quat turn = glm::angleAxis(0.4f, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.3f, glm::vec3(1, 0, 0));
    scene.add(Camera{.yfov = 0.6f, .znear = 0.05f * distance},
              Transform{.translation = bounds.center() + turn * glm::vec3(0.0f, 0.0f, distance), .rotation = turn});
    scene.renderer().request_aov("brush_weight");
    scene.renderer().request_aov("normal");
    scene.renderer().render_frame();
    const assets::Image weights = scene.renderer().read_aov("brush_weight");
    const assets::Image normals = scene.renderer().read_aov("normal");
    for (int y = frame.height - 1; y >= 0; --y)
        for (int x = 0; x < frame.width; ++x) {
            const auto i = static_cast<std::size_t>(y * frame.width + x);
            frame.weights.push_back(weights.f32()[i * static_cast<std::size_t>(weights.channels)]);
            const float* n = normals.f32() + i * static_cast<std::size_t>(normals.channels);
            if (n[0] * n[0] + n[1] * n[1] + n[2] * n[2] > 0.25f) frame.covered += 1.0;
        }
    frame.covered /= static_cast<double>(frame.weights.size());
    return frame;
}

/// One stamp per weight, all of one radius, grey by place.
test::StampImage stamps_of(const BrushedFrame& frame, const gpu::Rect& part, double radius, double cutoff) {
    test::StampImage image(part.width, part.height);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) {
            const float weight = frame.weights[static_cast<std::size_t>((part.y + y) * frame.width + part.x + x)];
            image.at(x, y).radius = static_cast<float>(radius); // a quad for every pixel is as large for all
            if (!(weight > 0.0f) || double(weight) < cutoff) continue;
            const float grey = weight * (0.5f + 0.5f * std::sin(0.1f * static_cast<float>(x + y)));
            image.at(x, y) = {
                .radius = static_cast<float>(radius), .red = grey, .green = grey, .blue = grey, .weight = weight};
        }
    return image;
}

/// The paper's way: a quad of 2 `radius` px a side for every pixel, added up in RGBA16F, then tone mapping. Footprints
/// are drawn with a rim of a pixel; so radius - 1 gives quads of that size.
class EveryPixel {
public:
    EveryPixel(RenderContext& render, const ConvolveJob& job, int width, int height)
        : render_(render), job_(job), width_(width), height_(height), vertex_array_("every pixel"),
          sums_(render.backend->create_texture({width, height, gpu::Format::rgba16f}, "sums")) {}
    ~EveryPixel() { render_.backend->destroy_texture(sums_); }
    EveryPixel(const EveryPixel&) = delete;
    EveryPixel& operator=(const EveryPixel&) = delete;

    void run() {
        gpu::Program& splats = program("implicit_brush/splat.vert", "implicit_brush/splat.frag");
        const float radius = std::max(job_.radius - 1.0f, 1.0f);
        splats.set("nominal_radius", radius);
        splats.set("largest_radius", radius);
        splats.set("picture", glm::vec2(width_, height_));
        render_.backend->texture(job_.places).bind(0);
        render_.backend->texture(job_.inks).bind(1);
        draw_into(sums_, gpu::Blend::add, true);
        splats.use();
        vertex_array_.bind();
        gpu::gl().DrawArrays(GL_TRIANGLES, 0, 6 * width_ * height_);

        gpu::Program& resolve = program("common/full_screen.vert", "implicit_brush/resolve.frag");
        resolve.set("white", static_cast<float>(job_.footprint.mass(double(job_.radius))));
        resolve.set("contrast", job_.contrast);
        resolve.set("opacity", job_.opacity);
        render_.backend->texture(sums_).bind(2);
        draw_into(job_.target, gpu::Blend::premultiplied, false);
        resolve.use();
        render_.full_screen.draw();
    }

private:
    gpu::Program& program(const char* vertex, const char* fragment) {
        gpu::ProgramSource source{.vertex = vertex, .fragment = fragment, .defines = job_.footprint.defines()};
        source.defines.push_back({"EVERY_PIXEL", ""});
        gpu::Program& made = render_.shaders->program(source);
        made.set("aspect", job_.footprint.aspect);
        return made;
    }
    void draw_into(std::uint32_t id, gpu::Blend blend, bool clear) {
        const gpu::Framebuffer& framebuffer = render_.backend->framebuffer({id});
        framebuffer.bind();
        gpu::apply({.viewport = {0, 0, width_, height_}, .blend = blend});
        if (clear) framebuffer.clear_color(0, std::array{0.0f, 0.0f, 0.0f, 0.0f});
    }

    RenderContext& render_;
    const ConvolveJob& job_;
    int width_, height_;
    gpu::VertexArray vertex_array_;
    std::uint32_t sums_;
};

double timed(const auto& work) {
    gpu::gl().Finish();
    const double start = now_ms();
    work();
    gpu::gl().Finish();
    return now_ms() - start;
}

void use_radius(ConvolveJob& job, double radius) { job.radius = job.largest_radius = static_cast<float>(radius); }

/// The methods that are measured on llvmpipe within seconds: gather looks at every pixel in reach.
constexpr std::array measured = {BrushMethod::splat, BrushMethod::tiles, BrushMethod::sums, BrushMethod::automatic};

/// A quad for every pixel costs the same whatever it weighs: it is measured once, in turn with the first methods.
double report_methods(Report& report, RenderContext& render, const BrushedFrame& frame, const std::string& name,
                      bool one_color, bool quick, double paper_ms = 0.0) {
    test::ConvolutionRun run(render, frame.width, frame.height);
    use_radius(run.job, quick ? 3.0 : 10.0);
    const gpu::Rect whole{0, 0, frame.width, frame.height};
    const test::StampImage stamps = stamps_of(frame, whole, double(run.job.radius), 0.0);
    run.upload(stamps);
    if (one_color) {
        run.job.same_color = glm::vec3(0.0f);
        run.job.same_place = glm::vec4(0.0f, 0.0f, run.job.radius, 0.0f);
    }
    EveryPixel every_pixel(render, run.job, frame.width, frame.height);
    std::vector<double> paper;
    std::array<std::vector<double>, measured.size()> times;
    for (int round = -1; round < (quick ? 1 : 3); ++round) { // the first one compiles shaders
        if (round >= 0 && paper_ms == 0.0) paper.push_back(timed([&] { every_pixel.run(); }));
        for (std::size_t i = 0; i < measured.size(); ++i) {
            run.job.method = measured[i];
            const double ms = timed([&] { run.paint(); });
            if (round >= 0) times[i].push_back(ms);
        }
    }
    report.add(name + ": pixels that stamp",
               100.0 * static_cast<double>(stamps.active()) / static_cast<double>(stamps.stamps.size()), "%");
    if (!paper.empty()) report.add("a quad for every pixel", paper_ms = median(paper), "ms");
    for (std::size_t i = 0; i < measured.size(); ++i)
        report.add(fmt::format("{}: {}", name, name_of(measured[i])), median(times[i]), "ms");
    report.add_limited(name + ": automatic / a quad for every pixel", median(times.back()) / paper_ms, "ratio", 0.1);
    return paper_ms;
}

/// What tiles that no stamp reaches cost: a frame without stamps against one pass that reads their weights.
void report_empty(Report& report, RenderContext& render, int width, int height) {
    test::ConvolutionRun run(render, width, height);
    use_radius(run.job, 10.0);
    run.upload(test::StampImage(width, height));
    run.paint();
    std::vector<double> empty;
    for (int round = 0; round < 5; ++round) empty.push_back(timed([&] { run.paint(); }));
    report.add("no stamps at all: automatic", median(empty), "ms");
    report.add_limited("no stamps at all: tiles drawn", run.convolver.counts().tiles, "", 0.0);
}

double most_error(const std::vector<float>& made, const std::vector<double>& expected) {
    double most = 0.0;
    for (std::size_t i = 0; i < made.size(); ++i) most = std::max(most, std::abs(double(made[i]) - expected[i]));
    return 255.0 * most;
}

/// Rows of one part of a frame.
class Rows {
public:
    Rows(std::ostream& file, RenderContext& render, const BrushedFrame& frame, bool quick)
        : file_(file), frame_(frame), quick_(quick), side_(std::min(quick ? 32 : 256, frame.height)),
          run_(render, side_, side_) {}

    /// One point: a method with stamps of that radius, and weights from `cutoff` on, against all stamps.
    void add(const char* panel, const char* series, const std::string& label, double radius, double cutoff,
             BrushMethod method, gpu::Format sums = gpu::Format::rgba32f) {
        const gpu::Rect part{(frame_.width - side_) / 2, (frame_.height - side_) / 2, side_, side_};
        use_radius(run_.job, radius);
        const test::StampImage all = run_.upload(stamps_of(frame_, part, radius, 0.0));
        const std::vector<double> expected = convolution_reference(all, run_.job);
        run_.upload(stamps_of(frame_, part, radius, cutoff));
        run_.job.method = method;
        run_.job.sums = sums;
        run_.run();
        const double error = most_error(run_.read(), expected);
        std::vector<double> times;
        for (int round = 0; round < (quick_ ? 1 : 5); ++round) times.push_back(timed([&] { run_.paint(); }));
        const double megapixels = 1e-6 * side_ * side_;
        file_ << fmt::format("{},{},{},{},{}\n", panel, series, label, median(times) / megapixels,
                             std::max(error, 1e-4))
              << std::flush;
    }

private:
    std::ostream& file_;
    const BrushedFrame& frame_;
    bool quick_;
    int side_;
    test::ConvolutionRun run_;
};

const ImplicitBrush measured_brush{.feature = BrushFeature::ridges, .size = 10.0f, .cutoff = 0.0f};

} // namespace

void report_convolution(Report& report, gpu::Context& context, const std::filesystem::path& model, bool quick) {
    ImplicitBrush brush = measured_brush;
    brush.cutoff = ImplicitBrush().cutoff;
    const BrushedFrame frame = brushed_frame(context, model, brush, quick);
    report.add("pixels of the model", 100.0 * frame.covered, "%");
    RenderContext render(context);
    const double paper_ms = report_methods(report, render, frame, "one colour", true, quick);
    report_methods(report, render, frame, "colours of the surface", false, quick, paper_ms);
    brush.spread = 3.0f;
    report_methods(report, render, brushed_frame(context, model, brush, quick), "wide weights", true, quick, paper_ms);
    report_empty(report, render, frame.width, frame.height);
}

void write_convolution_rows(std::ostream& file, gpu::Context& context, const std::filesystem::path& model, bool quick) {
    const BrushedFrame frame = brushed_frame(context, model, measured_brush, quick);
    RenderContext render(context);
    Rows rows(file, render, frame, quick);
    const std::vector<double> radii = quick ? std::vector{3.0} : std::vector{1.0, 3.0, 5.0, 10.0, 20.0, 32.0};
    for (const BrushMethod method : {BrushMethod::splat, BrushMethod::gather, BrushMethod::tiles, BrushMethod::sums})
        for (const double radius : radii) {
            if (method == BrushMethod::gather && radius > 10.0) continue; // minutes
            rows.add("radius", name_of(method), fmt::format("{}", radius), radius, 0.0, method);
        }
    for (const auto& [name, format] : {std::pair{"rgba16f", gpu::Format::rgba16f}, {"rgba32f", gpu::Format::rgba32f}})
        for (const double radius : radii)
            rows.add("sums", name, fmt::format("{}", radius), radius, 0.0, BrushMethod::splat, format);
    for (const double cutoff : {0.0, 0.001, 0.004, 0.01, 0.02, 0.05, 0.1})
        rows.add("cutoff", "radius 10", fmt::format("{}", cutoff), 10.0, cutoff, BrushMethod::splat);
}

} // namespace hachure::bench
