#include <hachure/components/transform.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/implicit_brush/optical_flow.h>
#include <hachure/tests/benchmarks/implicit_brush_noise.h>
#include <hachure/tests/systems/implicit_brush/noise_scene.h>

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace hachure::bench {
namespace {

constexpr Canvas canvas{1024, 768}, quick_canvas{64, 48};

/// Milliseconds of a frame in which the ball has turned.
class TurningBall {
public:
    TurningBall(gpu::Context& context, const std::vector<BrushNoiseKey>& keys, bool quick)
        : scene_(context, quick ? quick_canvas : canvas, keys) {
        scene_.add(Camera{.projection = Projection::orthographic, .ymag = 1.0f}, {.translation = {0, 0, 5}});
        ball_ = scene_.add(test::surface_mesh(geometry::icosphere(0.92, quick ? 3u : 6u))); // half of a 4:3 view
    }

    double frame_ms() {
        angle_ += 0.02f;
        scene_.world().get_mutable<Transform>(ball_).rotation = glm::angleAxis(angle_, glm::vec3(0, 1, 0));
        const double start = now_ms();
        scene_.renderer().render_frame(1.0 / 30.0);
        scene_.renderer().finish();
        return now_ms() - start;
    }

private:
    test::NoiseScene scene_;
    Entity ball_;
    float angle_ = 0.0f;
};

void add_grain(Report& report, gpu::Context& context, const char* name, BrushGrain grain, double pass_ms, bool quick) {
    TurningBall without(context, {}, quick), with(context, {{.grain = grain}}, quick);
    std::vector<double> added;
    for (int frame = 0; frame < (quick ? 2 : 12); ++frame) {
        const double floor = without.frame_ms();
        const double noise = with.frame_ms() - floor;
        if (frame > 0) added.push_back(noise); // the first one compiles shaders
    }
    report.add(std::string("noise.") + name, median(added) / pass_ms, "passes");
}

void add_flow(Report& report, gpu::Context& context, double pass_ms, bool quick) {
    const Canvas size = quick ? quick_canvas : canvas;
    App app;
    Renderer renderer(app, context);
    RenderContext& render = app.world().resource_mutable<RenderContext>();
    const auto make = [&](const gpu::TextureDesc& desc) { return render.backend->create_texture(desc, "flow"); };
    std::vector<float> tones;
    for (int i = 0; i < size.width * size.height; ++i)
        tones.push_back(0.5f + 0.5f * std::sin(0.05f * static_cast<float>(i % size.width + i / size.width)));
    const OpticalFlowJob job{make({size.width, size.height, gpu::Format::r32f}),
                             make({size.width, size.height, gpu::Format::r32f}),
                             make(OpticalFlowJob::flow_desc(size.width, size.height))};
    for (const std::uint32_t id : {job.before, job.now})
        render.backend->texture(id).upload(std::span<const float>(tones));
    std::vector<std::uint32_t> scratch;
    for (const gpu::TextureDesc& desc : OpticalFlowJob::scratch(size.width, size.height)) scratch.push_back(make(desc));
    std::vector<double> times;
    for (int run = 0; run < (quick ? 2 : 6); ++run) {
        const double start = now_ms();
        job.run(render, scratch);
        renderer.finish();
        if (run > 0) times.push_back(now_ms() - start);
    }
    report.add("noise.optical_flow", median(times) / pass_ms, "passes");
}

} // namespace

void add_noise_rows(Report& report, gpu::Context& context, double pass_ms, bool quick) {
    add_grain(report, context, "screen", BrushGrain::screen, pass_ms, quick);
    add_grain(report, context, "solid", BrushGrain::solid, pass_ms, quick);
    add_grain(report, context, "advected", BrushGrain::advected, pass_ms, quick);
    add_flow(report, context, pass_ms, quick);
}

} // namespace hachure::bench
