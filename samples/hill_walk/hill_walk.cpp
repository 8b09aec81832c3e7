// Figures that walk in hills, each in brushes of its own; README.md beside this file says what it shows.

#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/samples/common/orbit.h>
#include <hachure/samples/common/sample_window.h>
#include <hachure/systems/capabilities.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "checks.h"
#include "walk.h"

namespace {

using namespace hachure;
using hill_walk::HillWalk;

constexpr float orbit_distance = 13.0f; // metres, to between the figures

void toggle(World& world, BrushFeature feature) {
    for (auto [entity, brush] : world.query<ImplicitBrush>())
        if (brush.feature == feature) brush.visible = !brush.visible;
}

void press(HillWalk& scene, World& world, int key) {
    switch (key) {
    case GLFW_KEY_G:
        return scene.next_look(HillWalk::ground);
    case GLFW_KEY_1:
        return scene.next_look(HillWalk::first_figure);
    case GLFW_KEY_2:
        return scene.next_look(HillWalk::second_figure);
    case GLFW_KEY_C:
        return toggle(world, BrushFeature::contours);
    case GLFW_KEY_R:
        return toggle(world, BrushFeature::ridges);
    case GLFW_KEY_V:
        return toggle(world, BrushFeature::valleys);
    case GLFW_KEY_SPACE:
        return scene.set_walking(!scene.walking());
    default:
        return;
    }
}

int run_window(const std::vector<std::string>& files) {
    constexpr Canvas size{1024, 768};
    samples::SampleWindow window("hill_walk", size);
    App app;
    register_capabilities(app);
    Renderer renderer(app, window.context());
    HillWalk scene(app, files, size);
    samples::Orbit orbit(app.world(), scene.camera(), orbit_distance);
    while (window.next_frame(app.world())) {
        const samples::Hand& hand = window.hand();
        if (hand.drag != glm::vec2(0.0f)) orbit.turn(0.005f * hand.drag.x, 0.005f * hand.drag.y);
        if (hand.scroll != 0.0f) orbit.approach(std::pow(0.9f, hand.scroll));
        for (const int key : hand.keys) press(scene, app.world(), key);
        renderer.render_frame(window.seconds());
        renderer.present();
        window.set_title("hill_walk: " + scene.look_of(HillWalk::ground) + ", " +
                         scene.look_of(HillWalk::first_figure) + ", " + scene.look_of(HillWalk::second_figure) + "; " +
                         std::to_string(samples::passes_run(renderer)) + " passes ran");
    }
    return 0;
}

int run_headless(const std::vector<std::string>& files, int frames) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    App app;
    register_capabilities(app);
    Renderer renderer(app, *context);
    HillWalk scene(app, files, {400, 300});
    hill_walk::Checks checks(app.world(), renderer, scene);
    checks.figures_move(frames);
    scene.set_walking(false);
    checks.brushes_are_their_own();
    checks.features_share_a_frame();
    checks.nothing_moves();
    samples::Orbit orbit(app.world(), scene.camera(), orbit_distance);
    checks.noise_holds_to_the_ground(orbit);
    return checks.all_hold() ? 0 : 1;
}

int draw_picture(const std::vector<std::string>& files, const std::string& picture, double seconds) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    App app;
    register_capabilities(app);
    Renderer renderer(app, *context);
    HillWalk scene(app, files, {1024, 768});
    for (double at = 0.0; at < seconds; at += 1.0 / 30.0) renderer.skip_frame(1.0 / 30.0);
    renderer.render_frame();
    assets::write_png(picture, renderer.read_picture());
    return 0;
}

int refuse() {
    std::fputs("usage: hill_walk [FIGURE [FIGURE]] [--headless FRAMES | -o PICTURE.png [--time SECONDS]]\n", stderr);
    return 2;
}

} // namespace

int main(int argc, char** argv) {
    std::vector<std::string> files;
    std::string picture;
    int frames = 0;
    double seconds = 0.0;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const bool valued = i + 1 < argc;
        if (word == "--headless" && valued)
            frames = std::max(1, std::atoi(argv[++i]));
        else if (word == "-o" && valued)
            picture = argv[++i];
        else if (word == "--time" && valued)
            seconds = std::clamp(std::atof(argv[++i]), 0.0, 3600.0);
        else if (word.starts_with("-") || files.size() == 2)
            return refuse();
        else
            files.emplace_back(word);
    }
    try {
        if (frames > 0) return run_headless(files, frames);
        return picture.empty() ? run_window(files) : draw_picture(files, picture, seconds);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "hill_walk: error: %s\n", error.what());
        return 1;
    }
}
