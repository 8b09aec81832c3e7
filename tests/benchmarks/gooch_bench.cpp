// The modes of Gooch: what lighting vertices errs by the angle between them, against the formula of docs/gooch.md, and
// what each mode costs, as a multiple of a frame of the tones themselves. Frames of all modes alternate while the
// camera turns, so that no pass is reused and the machine's noise meets all; each ratio is of neighbours.

#include <hachure/components/camera.h>
#include <hachure/components/gooch.h>
#include <hachure/components/light.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/capabilities.h>
#include <hachure/tests/benchmarks/bench_report.h>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace hachure;

/// One shape in Gooch's tones, and a camera.
class Scene {
public:
    Scene(gpu::Context& context, const geometry::Shape& shape, const Camera& camera, Canvas canvas) {
        register_capabilities(app_);
        renderer_ = std::make_unique<Renderer>(app_, context);
        app_.world().set_resource(canvas);
        SurfaceMesh mesh;
        mesh.positions = shape.positions;
        mesh.normals = shape.normals;
        mesh.indices = shape.indices;
        mesh.submeshes = {{0, static_cast<std::uint32_t>(shape.indices.size()), {}}};
        const std::uint32_t index = app_.world().resource_mutable<MeshStore>().add(std::move(mesh));
        surface_ = app_.world().create_with(Transform{}, Surface{index}, Gooch{});
        camera_ = app_.world().create_with(Transform{}, camera);
    }

    /// Around the Y axis, looking at it.
    void look_from(float angle, float distance) {
        const glm::quat turn = glm::angleAxis(angle, glm::vec3(0, 1, 0));
        app_.world().get_mutable<Transform>(camera_) = {.translation = turn * glm::vec3(0, 0, distance),
                                                        .rotation = turn};
    }

    void add_light_from(float angle) {
        app_.world().create_with(Transform{.rotation = glm::angleAxis(angle, glm::vec3(0, 1, 0))}, Light{});
    }

    Gooch& gooch() { return app_.world().get_mutable<Gooch>(surface_); }
    Renderer& renderer() { return *renderer_; }

    double frame_ms() {
        const double start = bench::now_ms();
        renderer_->render_frame();
        renderer_->finish();
        return bench::now_ms() - start;
    }

    assets::Image colors() {
        renderer_->request_aov("color");
        renderer_->render_frame();
        return renderer_->read_aov("color");
    }

private:
    App app_;
    std::unique_ptr<Renderer> renderer_;
    Entity surface_, camera_;
};

constexpr double apart = 0.8; ///< k_warm - k_cool of white, figure 7, in red and green

/// The greatest error of light per vertex on a prism, as a share of k_warm - k_cool.
double vertex_error(gpu::Context& context, std::uint32_t sides, int pixels) {
    const float half_facet = glm::pi<float>() / static_cast<float>(sides);
    // So that a facet fills half of the picture, whatever its size.
    const Camera camera{.projection = Projection::orthographic, .ymag = 2.0f * half_facet, .zfar = 10.0f};
    Scene scene(context, geometry::cylinder(1.0, 4.0, sides), camera, {pixels, pixels});
    const glm::vec3 first = geometry::cylinder(1.0, 4.0, sides).normals[0];
    const float middle = std::atan2(first.x, first.z) + half_facet;
    scene.look_from(middle, 4.0f);
    scene.add_light_from(middle);
    scene.gooch().highlight = 0.0f;
    const assets::Image exact = scene.colors();
    scene.gooch().shading = GoochShading::two_lights_per_vertex;
    const assets::Image vertices = scene.colors();
    double worst = 0.0;
    for (int i = 0; i < 3 * pixels * pixels; ++i)
        worst = std::max(worst, std::abs(double(exact.f32()[i]) - double(vertices.f32()[i])));
    return worst / apart;
}

constexpr std::pair<GoochShading, const char*> modes[] = {
    {GoochShading::tone, "tone"},
    {GoochShading::two_lights, "two lights"},
    {GoochShading::two_lights_per_vertex, "two lights per vertex"},
    {GoochShading::phong, "phong"},
    {GoochShading::phong_per_vertex, "phong per vertex"}};

/// Frame times over that of `tone` with one light, by mode: the median of neighbours.
std::vector<double> mode_costs(gpu::Context& context, bool quick) {
    const Canvas canvas = quick ? Canvas{160, 120} : Canvas{1024, 768};
    Scene scene(context, geometry::icosphere(1.0, quick ? 3 : 5), Camera{.yfov = 0.6f}, canvas);
    std::vector<std::vector<double>> ratios(std::size(modes));
    float angle = 0.0f;
    for (int round = 0; round < (quick ? 2 : 25); ++round) {
        std::vector<double> times;
        for (const auto& [mode, name] : modes) {
            scene.look_from(angle += 0.01f, 3.6f);
            scene.gooch().shading = mode;
            times.push_back(scene.frame_ms());
        }
        for (std::size_t i = 0; i < times.size(); ++i)
            if (round > 0) ratios[i].push_back(times[i] / times[0]);
    }
    std::vector<double> result;
    for (std::vector<double>& mode : ratios) result.push_back(bench::median(mode));
    return result;
}

constexpr std::uint32_t prisms[] = {72, 48, 36, 24, 18, 12, 8, 6};

double predicted(std::uint32_t sides) { return 0.5 * (1.0 - std::cos(glm::pi<double>() / sides)); }

/// CSV for gooch_chart.gp: panel,name,x,y,formula.
void write_chart(gpu::Context& context, const char* file, bool quick) {
    std::string csv = "panel,name,x,y,formula\n";
    for (const std::uint32_t sides : prisms)
        csv += fmt::format("error,,{:.4g},{:.5g},{:.5g}\n", 360.0 / sides,
                           vertex_error(context, sides, quick ? 64 : 400), predicted(sides));
    const std::vector<double> costs = mode_costs(context, quick);
    for (std::size_t i = 0; i < costs.size(); ++i)
        csv += fmt::format("cost,{},{},{:.4g},\n", modes[i].second, i, costs[i]);
    assets::write_file_atomically(file, std::as_bytes(std::span(csv.data(), csv.size())));
}

int measure(gpu::Context& context, const bench::Arguments& arguments) {
    bench::Report report(arguments);
    for (const std::uint32_t sides : {36u, 18u, 8u}) {
        const double measured = vertex_error(context, sides, arguments.quick ? 64 : 400);
        report.add(fmt::format("light per vertex, {:.0f} degrees", 360.0 / sides), measured, "of warm - cool");
        report.add_limited(fmt::format("off the formula, {:.0f} degrees", 360.0 / sides),
                           std::abs(measured / predicted(sides) - 1.0), "", 0.1);
    }
    const std::vector<double> costs = mode_costs(context, arguments.quick);
    for (std::size_t i = 1; i < costs.size(); ++i)
        report.add_limited(fmt::format("frame, {} / tone", modes[i].second), costs[i], "x", 1.2);
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        // `--chart FILE [--quick]` writes what gooch_chart.gp draws, and measures nothing else.
        if (argc >= 3 && std::string_view(argv[1]) == "--chart") {
            write_chart(*gpu::make_context(), argv[2], argc == 4 && std::string_view(argv[3]) == "--quick");
            return 0;
        }
        const bench::Arguments arguments = bench::parse_arguments(argc, argv, "The modes of Gooch's tones.");
        const std::unique_ptr<gpu::Context> context = gpu::make_context();
        return measure(*context, arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_gooch: error: %s\n", error.what());
        return 1;
    }
}
