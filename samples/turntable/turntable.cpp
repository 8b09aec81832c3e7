// A model on a turntable; README.md beside this file says what it shows.

#include <hachure/components/camera.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/samples/common/orbit.h>
#include <hachure/samples/common/sample_window.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/styles/style.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

namespace {

using namespace hachure;

assets::Model torus_model() {
    const geometry::Shape shape = geometry::torus(1.0, 0.4, 96, 48);
    assets::Primitive primitive;
    primitive.positions = shape.positions;
    primitive.normals = shape.normals;
    primitive.indices = shape.indices;
    primitive.material = 0;
    assets::Model model;
    model.materials.push_back({.name = "orange", .base_color = {0.7f, 0.25f, 0.08f, 1.0f}});
    model.meshes.push_back({"torus", {std::move(primitive)}, {}});
    model.nodes.push_back({.name = "torus", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    return model;
}

void prepare(App& app, const std::string& file, Canvas canvas) {
    app.world().set_resource(canvas);
    const SpawnedModel spawned = spawn_model(app.world(), file.empty() ? torus_model() : assets::read_model(file));
    if (spawned.points.empty()) throw Error(file, "has nothing to draw");
    spawn_framing_camera(app.world(), spawned.points, canvas);
    apply_style(app.world(), app.types(), find_style(app.types(), "gooch"));
}

/// About the point that the camera looks at: its near plane is half way to the nearest point.
samples::Orbit orbit_of(World& world) {
    const Entity camera = world.query<const Camera>().first();
    return {world, camera, 3.0f * world.get<Camera>(camera).znear};
}

int run_headless(const std::string& file, int frames) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    App app;
    register_capabilities(app);
    Renderer renderer(app, *context);
    prepare(app, file, {320, 240});
    samples::Orbit orbit = orbit_of(app.world());
    for (int i = 0; i < frames; ++i) {
        orbit.turn(0.1f, 0.0f);
        renderer.render_frame();
        std::printf("frame %d: %d passes ran\n", i, samples::passes_run(renderer));
    }
    renderer.render_frame();
    const int still = samples::passes_run(renderer);
    std::printf("nothing moved: %d passes ran\n", still);
    return still == 0 ? 0 : 1;
}

void press(World& world, int key) {
    if (key == GLFW_KEY_L)
        for (auto [entity, lines] : world.query<EdgeLines>()) lines.width = lines.width > 0.0f ? 0.0f : 2.0f;
    if (key == GLFW_KEY_P)
        for (auto [entity, gooch] : world.query<Gooch>()) gooch.printed_equation = !gooch.printed_equation;
}

int run_window(const std::string& file) {
    constexpr Canvas size{1024, 768};
    samples::SampleWindow window("turntable", size);
    App app;
    register_capabilities(app);
    Renderer renderer(app, window.context());
    prepare(app, file, size);
    samples::Orbit orbit = orbit_of(app.world());
    while (window.next_frame(app.world())) {
        const samples::Hand& hand = window.hand();
        if (hand.drag != glm::vec2(0.0f)) orbit.turn(0.008f * hand.drag.x, 0.008f * hand.drag.y);
        if (hand.scroll != 0.0f) orbit.approach(std::pow(0.9f, hand.scroll));
        for (const int key : hand.keys) press(app.world(), key);
        renderer.render_frame();
        renderer.present();
        window.set_title("turntable: " + std::to_string(samples::passes_run(renderer)) + " passes ran");
    }
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    std::string file;
    int headless_frames = 0;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "--headless" && i + 1 < argc)
            headless_frames = std::max(1, std::atoi(argv[++i]));
        else if (argv[i][0] != '-' && file.empty())
            file = argv[i];
        else
            return std::fputs("usage: turntable [MODEL] [--headless FRAMES]\n", stderr), 2;
    }
    try {
        return headless_frames > 0 ? run_headless(file, headless_frames) : run_window(file);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "turntable: error: %s\n", error.what());
        return 1;
    }
}
