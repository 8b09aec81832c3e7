// A figure that walks while the sun goes round, in shade strokes; README.md beside this file says what it shows.

#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/samples/common/orbit.h>
#include <hachure/samples/common/sample_window.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/shade_strokes/shade_counts.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "checks.h"
#include "day.h"

namespace {

using namespace hachure;
using sun_walk::Day;

constexpr float orbit_distance = 9.0f; // metres, to the figure's path

void press(Day& day, int key) {
    switch (key) {
    case GLFW_KEY_L:
        return day.next_look();
    case GLFW_KEY_S:
        return day.set_sun_moving(!day.sun_moving());
    case GLFW_KEY_SPACE:
        return day.set_walking(!day.walking());
    default:
        return;
    }
}

std::string title(const Day& day, const World& world) {
    const ShadeCounts& counts = world.resource<ShadeCounts>();
    return "sun_walk: " + std::string(day.look()) + "; " + std::to_string(counts.triangles_swept) +
           " triangles looked at, " + std::to_string(counts.triangles_touched) + " touched, " +
           std::to_string(counts.segments) + " segments";
}

int run_window(const std::string& file) {
    constexpr Canvas size{1024, 768};
    samples::SampleWindow window("sun_walk", size);
    App app;
    register_capabilities(app);
    Renderer renderer(app, window.context());
    Day day(app, file, size);
    samples::Orbit orbit(app.world(), day.camera(), orbit_distance);
    while (window.next_frame(app.world())) {
        const samples::Hand& hand = window.hand();
        if (hand.drag != glm::vec2(0.0f)) orbit.turn(0.005f * hand.drag.x, 0.005f * hand.drag.y);
        if (hand.scroll != 0.0f) orbit.approach(std::pow(0.9f, hand.scroll));
        for (const int key : hand.keys) press(day, key);
        renderer.render_frame(window.seconds());
        renderer.present();
        window.set_title(title(day, app.world()));
    }
    return 0;
}

int run_headless(const std::string& file, int frames) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    App app;
    register_capabilities(app);
    Renderer renderer(app, *context);
    Day day(app, file, {400, 300});
    sun_walk::Checks checks(app.world(), renderer, day);
    checks.strokes_follow(frames);
    day.set_walking(false);
    day.set_sun_moving(false);
    checks.shade_is_delivered();
    checks.night_is_dark();
    samples::Orbit orbit(app.world(), day.camera(), orbit_distance);
    checks.turning_costs_nothing(orbit);
    checks.nothing_moves();
    return checks.all_hold() ? 0 : 1;
}

/// The picture after so many seconds, which are lived through: strokes depend on how the light came.
int draw_picture(const std::string& file, const std::string& picture, double seconds, int look) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    App app;
    register_capabilities(app);
    Renderer renderer(app, *context);
    Day day(app, file, {1024, 768});
    for (int i = 0; i < look; ++i) day.next_look();
    for (double at = 0.0; at < seconds; at += 1.0 / 30.0) renderer.skip_frame(1.0 / 30.0);
    renderer.render_frame();
    assets::write_png(picture, renderer.read_picture());
    return 0;
}

int refuse() {
    std::fputs("usage: sun_walk [FIGURE] [--headless FRAMES | -o PICTURE.png [--time SECONDS] [--look N]]\n", stderr);
    return 2;
}

} // namespace

int main(int argc, char** argv) {
    std::string file, picture;
    int frames = 0, look = 0;
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
        else if (word == "--look" && valued)
            look = std::clamp(std::atoi(argv[++i]), 0, 100);
        else if (word.starts_with("-") || !file.empty())
            return refuse();
        else
            file = word;
    }
    try {
        if (frames > 0) return run_headless(file, frames);
        return picture.empty() ? run_window(file) : draw_picture(file, picture, seconds, look);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "sun_walk: error: %s\n", error.what());
        return 1;
    }
}
