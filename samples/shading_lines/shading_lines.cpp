// Lines that follow the light; README.md beside this file says what it shows.

#include <hachure/components/abstracted_lines.h>
#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/components/paper.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/samples/common/sample_window.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/styles/style.h>

#include <GLFW/glfw3.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "knot.h"

namespace {

using namespace hachure;

/// The model, and what one can do to it.
class Study {
public:
    Study(App& app, const std::string& file, Canvas canvas) : world_(app.world()) {
        world_.set_resource(canvas);
        const SpawnedModel spawned =
            spawn_model(world_, file.empty() ? shading_lines::knot_model() : assets::read_model(file));
        if (spawned.points.empty()) throw Error(file, "has nothing to draw");
        spawn_framing_camera(world_, spawned.points, canvas);
        apply_style(world_, app.types(), find_style(app.types(), "lines"));
        light_ = world_.create_with(Transform{}, Light{.rig = LightRig::camera});
        turn_light(0.0f, 0.0f);
    }

    /// In the camera's axes: at zero it shines along the gaze.
    void turn_light(float right, float down) {
        yaw_ += right;
        pitch_ = std::clamp(pitch_ + down, -1.5f, 1.5f);
        world_.get_mutable<Transform>(light_).rotation =
            glm::angleAxis(yaw_, glm::vec3(0, 1, 0)) * glm::angleAxis(pitch_, glm::vec3(1, 0, 0));
    }
    void widen(float factor) {
        for (auto [entity, lines] : world_.query<AbstractedLines>())
            lines.width = std::clamp(lines.width * factor, 1.0f, 40.0f);
    }
    void change_beta(float by) {
        for (auto [entity, lines] : world_.query<AbstractedLines>())
            lines.beta = std::clamp(lines.beta + by, 0.0f, 1.0f);
    }
    void toggle_paper() {
        const Entity camera = world_.query<const Camera>().first();
        if (world_.has<Paper>(camera))
            world_.remove<Paper>(camera);
        else
            world_.add(camera, Paper{.kind = PaperKind::cold_press, .pressure = 0.85f});
    }
    [[nodiscard]] const AbstractedLines& lines() {
        return world_.get<AbstractedLines>(world_.query<const AbstractedLines>().first());
    }

private:
    World& world_;
    Entity light_ = Entity::null;
    float yaw_ = 0.7f, pitch_ = -0.6f; ///< radians
};

/// A frame's lines: how opaque they are at each pixel, dark and bright ones.
std::vector<float> draw_lines(Renderer& renderer) {
    renderer.render_frame();
    const assets::Image image = renderer.read_aov("line_opacity");
    return {image.f32(), image.f32() + image.width * image.height * image.channels};
}

double ink(const std::vector<float>& lines) {
    double sum = 0.0;
    for (const float opacity : lines) sum += double(opacity);
    return sum;
}

double change(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += double(std::abs(a[i] - b[i]));
    return sum;
}

bool check(bool holds, const char* what) {
    if (!holds) std::fprintf(stderr, "shading_lines: %s\n", what);
    return holds;
}

int run_headless(const std::string& file, int frames) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    App app;
    register_capabilities(app);
    Renderer renderer(app, *context);
    Study study(app, file, {640, 480});
    renderer.request_aov("line_opacity");
    std::vector<float> before = draw_lines(renderer);
    bool good = check(ink(before) > 100.0, "there are no lines");
    for (int i = 0; i < frames; ++i) {
        study.turn_light(-0.3f, 0.05f);
        const std::vector<float> now = draw_lines(renderer);
        std::printf("light %d: %.0f px of lines, %.0f px other than before\n", i, ink(now), change(before, now));
        good = check(change(before, now) > 0.05 * ink(before), "lines do not follow the light") && good;
        before = now;
    }
    study.widen(2.0f);
    const std::vector<float> wide = draw_lines(renderer);
    std::printf("twice as wide: %.0f px of lines\n", ink(wide));
    good = check(ink(wide) > 1.2 * ink(before), "lines do not follow their width") && good;
    study.change_beta(1.0f);
    const std::vector<float> ridges = draw_lines(renderer);
    std::printf("without edges of tones: %.0f px of lines\n", ink(ridges));
    good = check(ink(ridges) < 0.9 * ink(wide), "edges of tones are drawn at beta 1") && good;
    renderer.render_frame();
    std::printf("nothing moved: %d passes ran\n", samples::passes_run(renderer));
    good = check(samples::passes_run(renderer) == 0, "passes run while nothing moves") && good;
    return good ? 0 : 1;
}

void press(Study& study, int key) {
    constexpr float turn = 0.05f, wider = 1.1f, step = 0.05f;
    switch (key) {
    case GLFW_KEY_LEFT:
        return study.turn_light(-turn, 0.0f);
    case GLFW_KEY_RIGHT:
        return study.turn_light(turn, 0.0f);
    case GLFW_KEY_UP:
        return study.turn_light(0.0f, -turn);
    case GLFW_KEY_DOWN:
        return study.turn_light(0.0f, turn);
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
        return study.widen(wider);
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
        return study.widen(1.0f / wider);
    case GLFW_KEY_COMMA:
        return study.change_beta(-step);
    case GLFW_KEY_PERIOD:
        return study.change_beta(step);
    case GLFW_KEY_P:
        return study.toggle_paper();
    default:
        return;
    }
}

void apply_hand(const samples::Hand& hand, Study& study) {
    if (hand.drag != glm::vec2(0.0f)) study.turn_light(0.008f * hand.drag.x, 0.008f * hand.drag.y);
    if (hand.scroll != 0.0f) study.widen(std::pow(1.1f, hand.scroll));
    for (const int key : hand.keys) press(study, key);
    for (const int key : hand.repeats) press(study, key);
}

int run_window(const std::string& file) {
    constexpr Canvas size{1024, 768};
    samples::SampleWindow window("shading_lines", size);
    App app;
    register_capabilities(app);
    Renderer renderer(app, window.context());
    Study study(app, file, size);
    while (window.next_frame(app.world())) {
        apply_hand(window.hand(), study);
        renderer.render_frame();
        renderer.present();
        char title[80];
        std::snprintf(title, sizeof title, "shading_lines: width %.1f px, beta %.2f", double(study.lines().width),
                      double(study.lines().beta));
        window.set_title(title);
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
            return std::fputs("usage: shading_lines [MODEL] [--headless FRAMES]\n", stderr), 2;
    }
    try {
        return headless_frames > 0 ? run_headless(file, headless_frames) : run_window(file);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "shading_lines: error: %s\n", error.what());
        return 1;
    }
}
