// Frame time of Gooch over its floor: the same triangles with a constant shader into the same targets, and one
// full-screen copy. Frames and floors alternate while the camera turns, so that no pass can be reused and the machine's
// noise meets both; each ratio is of neighbours, the verdict is on their median.

#include <hachure/components/edge_lines.h>
#include <hachure/components/transform.h>
#include <hachure/editor/load_model.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/gpu/state.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/styles/style.h>
#include <hachure/tests/benchmarks/bench_report.h>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

namespace {

using namespace hachure;
using bench::now_ms;

constexpr const char* bunny = "/usr/share/glmark2/models/bunny.obj";
constexpr double limit_over_floor = 1.6;
constexpr double limit_start_seconds = 1.5;

/// A world with one model, the camera on an orbit.
class Stage {
public:
    Stage(gpu::Context& context, const assets::Model& model, Canvas canvas, bool edge_lines) {
        register_capabilities(app_);
        renderer_ = std::make_unique<Renderer>(app_, context);
        load_model(app_, model, "benchmark", canvas);
        apply_style(app_.world(), app_.types(), find_style(app_.types(), "gooch"));
        if (!edge_lines)
            for (const Entity entity : app_.types().find("edge_lines")->entities(app_.world()))
                app_.world().remove<EdgeLines>(entity);
        camera_ = app_.types().find("camera")->entities(app_.world()).front();
    }

    void turn(float radians) {
        Transform& transform = app_.world().get_mutable<Transform>(camera_);
        const glm::quat turn = glm::angleAxis(radians, glm::vec3(0.0f, 1.0f, 0.0f));
        transform.translation = turn * transform.translation;
        transform.rotation = turn * transform.rotation;
    }

    double frame_ms() {
        const double start = now_ms();
        renderer_->render_frame();
        renderer_->finish();
        return now_ms() - start;
    }

    App& app() { return app_; }

private:
    App app_;
    std::unique_ptr<Renderer> renderer_;
    Entity camera_;
};

/// The triangles of a stage's DrawList with a constant shader, and a copy.
class Floor {
public:
    explicit Floor(Canvas canvas)
        : color_({canvas.width, canvas.height, gpu::Format::srgb8_alpha8}, "floor color"),
          copy_({canvas.width, canvas.height, gpu::Format::srgb8_alpha8}, "floor copy"),
          depth_({canvas.width, canvas.height, gpu::Format::depth32f}, "floor depth"),
          target_({&color_}, &depth_, "floor"), copy_target_({&copy_}, nullptr, "floor copy") {}

    double frame_ms(World& world) {
        const double start = now_ms();
        draw_triangles(world);
        copy();
        gpu::gl().Finish();
        return now_ms() - start;
    }

private:
    void draw_triangles(World& world) {
        RenderContext& render = world.resource_mutable<RenderContext>();
        const View& view = world.resource<View>();
        target_.bind();
        gpu::DrawState state{.viewport = {0, 0, view.width, view.height},
                             .depth_test = gpu::DepthTest::greater,
                             .depth_write = true,
                             .srgb_write = true};
        gpu::apply(state);
        target_.clear_color(0, std::array{1.0f, 1.0f, 1.0f, 1.0f});
        target_.clear_depth(0.0f);
        render.view_uniforms.bind(view, world.resource<LightList>());
        gpu::Program& program =
            render.shaders->program({.vertex = "surface/position.vert", .fragment = "surface/constant.frag"});
        program.use();
        const MeshStore& store = world.resource<MeshStore>();
        for (const DrawItem& item : world.resource<DrawList>().items) {
            program.set("world_from_entity", item.world_from_entity);
            render.meshes.vertex_array(store, item).bind();
            for (const Submesh& submesh : store.mesh(item.mesh).submeshes) {
                state.cull = submesh.material.double_sided ? gpu::Cull::none : gpu::Cull::back;
                gpu::apply(state);
                gpu::gl().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(submesh.index_count), GL_UNSIGNED_INT,
                                       reinterpret_cast<const void*>(std::size_t{submesh.first_index} * 4));
            }
        }
    }

    void copy() {
        copy_target_.bind();
        gpu::apply({.viewport = {0, 0, copy_.width(), copy_.height()}, .srgb_write = true});
        color_.bind(0);
        copier_->use();
        full_screen_.draw();
    }

    gpu::Texture color_, copy_, depth_;
    gpu::Framebuffer target_, copy_target_;
    gpu::FullScreen full_screen_;
    gpu::ShaderLibrary library_;
    gpu::Program* copier_ = &library_.program({.vertex = "common/full_screen.vert", .fragment = "common/copy.frag"});
};

struct Timings {
    std::vector<double> frame, floor, ratio;
};

Timings measure(Stage& stage, Floor& floor, int frames) {
    Timings timings;
    for (int i = -3; i < frames; ++i) { // three to warm up
        stage.turn(0.02f);
        const double frame = stage.frame_ms();
        const double base = floor.frame_ms(stage.app().world());
        if (i < 0) continue;
        timings.frame.push_back(frame);
        timings.floor.push_back(base);
        timings.ratio.push_back(frame / base);
    }
    return timings;
}

/// From starting the program to the PNG on disk, seconds.
double program_seconds(const std::filesystem::path& model, Canvas canvas) {
    const std::filesystem::path picture =
        std::filesystem::temp_directory_path() / ("hachure-bench-" + std::to_string(::getpid()) + ".png");
    const std::string command = fmt::format("'{}' render '{}' -o '{}' --style gooch --size {}x{}", HACHURE_PROGRAM,
                                            model.string(), picture.string(), canvas.width, canvas.height);
    const double start = now_ms();
    const int status = std::system(command.c_str());
    const double seconds = 1e-3 * (now_ms() - start);
    const bool drawn = status == 0 && std::filesystem::remove(picture);
    if (!drawn) throw Error(model.string(), "the program drew no picture");
    return seconds;
}

assets::Model benchmark_model(const bench::Arguments& arguments) {
    const std::filesystem::path path = arguments.model.empty() ? bunny : arguments.model;
    if (!arguments.quick) return assets::read_model(path);
    assets::Model model;
    const geometry::Shape shape = geometry::uv_sphere(1.0, 32, 16);
    assets::Primitive primitive;
    primitive.positions = shape.positions;
    primitive.normals = shape.normals;
    primitive.indices = shape.indices;
    model.meshes.push_back({"sphere", {std::move(primitive)}, {}});
    model.nodes.push_back({.name = "sphere", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    return model;
}

int run(int argc, char** argv) {
    const bench::Arguments arguments =
        bench::parse_arguments(argc, argv, "Steady-state frame time over the floor, for bunny at 1024x768.");
    const Canvas canvas = arguments.quick ? Canvas{64, 48} : Canvas{1024, 768};
    const int frames = arguments.quick ? 3 : 60;
    const assets::Model model = benchmark_model(arguments);
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    bench::Report report(arguments);
    Floor floor(canvas);

    Stage plain(*context, model, canvas, false);
    const Timings gooch = measure(plain, floor, frames);
    report.add("floor: constant shader and a copy", bench::median(gooch.floor), "ms");
    report.add("gooch frame", bench::median(gooch.frame), "ms");
    report.add_limited("gooch frame over floor", bench::median(gooch.ratio), "ratio", limit_over_floor);

    Stage lined(*context, model, canvas, true);
    const Timings lines = measure(lined, floor, frames);
    report.add("gooch frame with edge lines", bench::median(lines.frame), "ms");
    report.add("gooch frame with edge lines over floor", bench::median(lines.ratio), "ratio");

    std::vector<double> still;
    for (int i = 0; i < frames; ++i) still.push_back(lined.frame_ms());
    report.add("frame with nothing changed", bench::median(still), "ms");

    const std::filesystem::path file = arguments.model.empty() ? bunny : arguments.model;
    if (std::filesystem::exists(file)) {
        std::vector<double> seconds;
        for (int i = 0; i < (arguments.quick ? 1 : 7); ++i) seconds.push_back(program_seconds(file, canvas));
        report.add_limited("process start to PNG on disk", bench::median(seconds), "s", limit_start_seconds);
    }
    return report.finish();
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const hachure::Error& error) {
        std::fprintf(stderr, "bench_frame: error: %s\n", error.what());
        return 1;
    }
}
