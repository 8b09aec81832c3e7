// Frame time of metal over that of the Gooch tone on the same triangles. Frames of both alternate while the camera
// turns, so that no pass can be reused and the machine's noise meets both; the median of the ratios counts.

#include <hachure/components/metal.h>
#include <hachure/components/transform.h>
#include <hachure/editor/load_model.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/styles/style.h>
#include <hachure/tests/benchmarks/bench_report.h>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace {

using namespace hachure;
using bench::now_ms;

constexpr const char* bunny = "/usr/share/glmark2/models/bunny.obj";

/// A world with one model, the camera on an orbit, without lines.
class Stage {
public:
    Stage(gpu::Context& context, const assets::Model& model, Canvas canvas, const char* look) {
        register_capabilities(app_);
        renderer_ = std::make_unique<Renderer>(app_, context);
        load_model(app_, model, "benchmark", canvas);
        const std::string style = fmt::format(R"({{"hachure_style": 1, "name": "bench", "surface": {}}})", look);
        apply_style(app_.world(), app_.types(), parse_style(app_.types(), "bench", style));
        camera_ = app_.types().find("camera")->entities(app_.world()).front();
    }

    double frame_ms() {
        Transform& transform = app_.world().get_mutable<Transform>(camera_);
        const glm::quat turn = glm::angleAxis(0.02f, glm::vec3(0.0f, 1.0f, 0.0f));
        transform.translation = turn * transform.translation;
        transform.rotation = turn * transform.rotation;
        const double start = now_ms();
        renderer_->render_frame();
        renderer_->finish();
        return now_ms() - start;
    }

private:
    App app_;
    std::unique_ptr<Renderer> renderer_;
    Entity camera_;
};

assets::Model torus_model(bool quick) {
    const geometry::Shape shape = geometry::torus(1.0, 0.4, quick ? 32 : 256, quick ? 16 : 128);
    assets::Primitive primitive;
    primitive.positions = shape.positions;
    primitive.normals = shape.normals;
    primitive.texcoords[0] = shape.texcoords;
    primitive.indices = shape.indices;
    assets::Model model;
    model.meshes.push_back({"torus", {std::move(primitive)}, {}});
    model.nodes.push_back({.name = "torus", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    return model;
}

void compare(bench::Report& report, gpu::Context& context, const assets::Model& model, const std::string& name,
             Canvas canvas, int frames, const char* look) {
    Stage metal(context, model, canvas, look), gooch(context, model, canvas, R"({"gooch": {"highlight": 0}})");
    std::vector<double> metal_ms, gooch_ms, ratio;
    for (int i = -3; i < frames; ++i) { // three to warm up
        const double own = metal.frame_ms(), base = gooch.frame_ms();
        if (i < 0) continue;
        metal_ms.push_back(own);
        gooch_ms.push_back(base);
        ratio.push_back(own / base);
    }
    report.add(name + ": gooch frame", bench::median(gooch_ms), "ms");
    report.add(name + ": metal frame", bench::median(metal_ms), "ms");
    report.add(name + ": metal frame over gooch", bench::median(ratio), "ratio");
}

int run(int argc, char** argv) {
    const bench::Arguments arguments =
        bench::parse_arguments(argc, argv, "Frame time of metal over the Gooch tone, at 1024x768.");
    const Canvas canvas = arguments.quick ? Canvas{64, 48} : Canvas{1024, 768};
    const int frames = arguments.quick ? 3 : 40;
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    bench::Report report(arguments);
    const assets::Model torus = torus_model(arguments.quick);
    compare(report, *context, torus, "torus, by curvature", canvas, frames, R"({"metal": {}})");
    compare(report, *context, torus, "torus, by angle", canvas, frames, R"({"metal": {"source": "around_axis"}})");
    compare(report, *context, torus, "torus, cool to warm", canvas, frames, R"({"metal": {"cool_to_warm": 1}})");
    const std::filesystem::path file = arguments.model.empty() ? bunny : arguments.model;
    if (!arguments.quick && std::filesystem::exists(file))
        compare(report, *context, assets::read_model(file), "bunny, by curvature", canvas, frames, R"({"metal": {}})");
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_metal: error: %s\n", error.what());
        return 1;
    }
}
