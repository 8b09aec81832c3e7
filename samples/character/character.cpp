// A character that plays its clips; README.md beside this file says what it shows.

#include <hachure/components/animation.h>
#include <hachure/components/deform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/runtime/scene/renderer.h>
#include <hachure/samples/common/sample_window.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/camera/camera.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/styles/style.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "tentacle.h"

namespace {

using namespace hachure;

/// The model, and what the keys change about it.
class Stage {
public:
    Stage(App& app, const std::string& file, Canvas canvas) : app_(app) {
        app.world().set_resource(canvas);
        model_ = spawn_model(app.world(), file.empty() ? make_tentacle() : assets::read_model(file));
        if (model_.points.empty()) throw Error(file, "has nothing to draw");
        if (model_.clips.empty()) throw Error(file, "has no clip to play");
        app.world().add(model_.root, Animation{.clip = model_.clips.front()});
        if (model_.cameras.empty()) spawn_framing_camera(app.world(), model_.points, canvas);
        if (model_.lights.empty()) spawn_default_light(app.world());
        choose_style(0);
    }

    Animation& animation() { return app_.world().get_mutable<Animation>(model_.root); }

    void choose_clip(int step) {
        const int count = static_cast<int>(model_.clips.size());
        clip_ = (clip_ + step + count) % count;
        animation().clip = model_.clips[static_cast<std::size_t>(clip_)];
    }
    void choose_style(int step) {
        const auto styles = built_in_styles();
        style_ = (style_ + static_cast<std::size_t>(step)) % styles.size();
        apply_style(app_.world(), app_.types(), find_style(app_.types(), styles[style_].name));
    }
    void next_method() {
        using geometry::SkinMethod;
        for (auto [entity, deform] : app_.world().query<Deform>())
            deform.method = deform.method == SkinMethod::linear ? SkinMethod::dual_quaternion : SkinMethod::linear;
    }
    void next_normals() {
        for (auto [entity, deform] : app_.world().query<Deform>())
            deform.normals =
                deform.normals == DeformedNormals::blended ? DeformedNormals::recomputed : DeformedNormals::blended;
    }

private:
    App& app_;
    SpawnedModel model_;
    int clip_ = 0;
    std::size_t style_ = 0;
};

/// What a frame did.
struct Work {
    std::uint64_t clips = 0, surfaces = 0;
    int passes = 0;

    bool none() const { return clips == 0 && surfaces == 0 && passes == 0; }
    bool all() const { return clips > 0 && surfaces > 0 && passes > 0; }
    std::string text() const {
        return std::to_string(clips) + " clips sampled, " + std::to_string(surfaces) + " surfaces deformed, " +
               std::to_string(passes) + " passes ran";
    }
};

Work work_of(const App& app, Renderer& renderer) {
    return {app.world().resource<AnimationCounts>().clips, app.world().resource<DeformCounts>().surfaces,
            samples::passes_run(renderer)};
}

int run_headless(const std::string& file, int frames) {
    const std::unique_ptr<gpu::Context> context = gpu::make_context();
    App app;
    register_capabilities(app);
    Renderer renderer(app, *context);
    Stage stage(app, file, {320, 240});
    bool as_expected = true;
    for (int i = 0; i < frames; ++i) {
        if (i == frames / 3) stage.choose_clip(1);
        if (i == 2 * frames / 3) stage.next_method();
        renderer.render_frame(1.0 / 30.0);
        const Work work = work_of(app, renderer);
        std::printf("frame %d: %s\n", i, work.text().c_str());
        as_expected = as_expected && work.all();
    }
    stage.animation().playing = false;
    renderer.render_frame(1.0 / 30.0); // takes the change in
    renderer.render_frame(1.0 / 30.0);
    const Work still = work_of(app, renderer);
    std::printf("paused: %s\n", still.text().c_str());
    return as_expected && still.none() ? 0 : 1;
}

void press(Stage& stage, int key) {
    switch (key) {
    case GLFW_KEY_LEFT:
        return stage.choose_clip(-1);
    case GLFW_KEY_RIGHT:
        return stage.choose_clip(1);
    case GLFW_KEY_UP:
        stage.animation().speed = std::min(8.0f, stage.animation().speed * 1.25f);
        return;
    case GLFW_KEY_DOWN:
        stage.animation().speed *= 0.8f;
        return;
    case GLFW_KEY_SPACE:
        stage.animation().playing = !stage.animation().playing;
        return;
    case GLFW_KEY_S:
        return stage.choose_style(1);
    case GLFW_KEY_D:
        return stage.next_method();
    case GLFW_KEY_N:
        return stage.next_normals();
    default:
        return;
    }
}

int run_window(const std::string& file) {
    constexpr Canvas size{1024, 768};
    samples::SampleWindow window("character", size);
    App app;
    register_capabilities(app);
    Renderer renderer(app, window.context());
    Stage stage(app, file, size);
    while (window.next_frame(app.world())) {
        for (const int key : window.hand().keys) press(stage, key);
        renderer.render_frame(window.seconds());
        renderer.present();
        window.set_title(stage.animation().clip + ": " + work_of(app, renderer).text());
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
            return std::fputs("usage: character [MODEL] [--headless FRAMES]\n", stderr), 2;
    }
    try {
        return headless_frames > 0 ? run_headless(file, headless_frames) : run_window(file);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "character: error: %s\n", error.what());
        return 1;
    }
}
