// Brushes over time: half a step of camera, light or pose changes half as much, what stands still is painted the same
// bit for bit, and no frame depends on those before it.

#include <hachure/components/animation.h>
#include <hachure/components/implicit_brush.h>
#include <hachure/components/toon.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/picture/popping.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/styles/style.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "../../support/arm_model.h"
#include "../../support/drawn_scene.h"
#include "../../support/gl_fixture.h"

namespace hachure::test {
namespace {

constexpr Canvas brush_canvas{320, 240};

/// A model in style `brush`, with a turntable of camera and light.
class BrushedScene {
public:
    BrushedScene(gpu::Context& context, const assets::Model& model) : scene_(context, brush_canvas) {
        World& world = scene_.world();
        const SpawnedModel spawned = spawn_model(world, model);
        root_ = spawned.root;
        spawn_framing_camera(world, spawned.points, brush_canvas);
        light_ = world.create_with(Transform{}, Light{});
        apply_style(world, scene_.app().types(), find_style(scene_.app().types(), "brush"));
        scene_.renderer().request_aov("line_layer");
    }

    World& world() { return scene_.world(); }

    /// Turning the model is going around it with the camera; the light stays.
    void turn(double degrees) { rotate(root_, degrees); }
    void turn_light(double degrees) { rotate(light_, degrees); }

    /// How much paint there is, and of what colour.
    assets::Image paint() {
        scene_.renderer().render_frame(std::exchange(seconds_, 0.0));
        const assets::Image layer = scene_.renderer().read_aov("line_layer");
        assets::Image picture = assets::make_image(layer.width, layer.height, 3, assets::PixelType::f32);
        const auto pixels = static_cast<std::size_t>(layer.width) * static_cast<std::size_t>(layer.height);
        for (std::size_t i = 0; i < pixels; ++i)
            for (std::size_t c = 0; c < 3; ++c) picture.f32()[3 * i + c] = layer.f32()[4 * i + (c == 2 ? 3 : c)];
        return picture;
    }

    /// The clip plays on so far until the next picture.
    void play(const std::string& clip) { world().add(root_, Animation{.clip = clip}); }
    void play_on(double seconds) { seconds_ = seconds; }

private:
    void rotate(Entity entity, double degrees) {
        Transform transform = world().get<Transform>(entity);
        transform.rotation = glm::angleAxis(static_cast<float>(glm::radians(degrees)), glm::vec3(0.0f, 1.0f, 0.0f));
        world().get_mutable<Transform>(entity) = transform;
    }

    DrawnScene scene_;
    Entity root_, light_;
    double seconds_ = 0.0;
};

assets::Model still_model() {
    const std::filesystem::path bunny = "/usr/share/glmark2/models/bunny.obj";
    if (std::filesystem::exists(bunny)) return assets::read_model(bunny);
    return arm_model();
}

using BrushesMotionTest = GlTest;

/// The change that motion does not explain, of all but a thousandth of the pixels, at its worst on the way from 0 to
/// `whole` in steps of `step`.
double largest_change(BrushedScene& scene, const std::function<void(double)>& move, double step, double whole,
                      int reach) {
    picture::PoppingMeter meter(reach);
    double largest = 0.0;
    for (double at = 0.0; at <= whole + 1e-9; at += step) {
        move(at);
        if (const auto change = meter.add(scene.paint())) largest = std::max(largest, change->p999);
    }
    return largest;
}

/// Pops keep their size however small the steps are: of those that are left in the smallest steps there may be few.
void expect_smaller_with_the_step(BrushedScene& scene, const std::function<void(double)>& move, double step,
                                  double whole, int reach) {
    std::vector<double> changes;
    for (int halvings = 0; halvings < 4; ++halvings)
        changes.push_back(largest_change(scene, move, step / double(1 << halvings), whole, reach));
    const std::string all = ::testing::PrintToString(changes);
    ::testing::Test::RecordProperty("changes", all);
    EXPECT_GT(changes[0], 1.0) << "nothing moves: the test measures nothing";
    EXPECT_LE(changes[3], 0.4 * changes[0]) << all;
    EXPECT_LE(changes[3], 14.0) << "of 255: " << all;
}

TEST_P(BrushesMotionTest, HalfTheTurnIsHalfTheChange) {
    BrushedScene scene(context(), still_model());
    expect_smaller_with_the_step(
        scene, [&](double at) { scene.turn(at); }, 1.0, 5.0, 1);
}

TEST_P(BrushesMotionTest, SoIsHalfTheTurnOfALight) {
    BrushedScene scene(context(), still_model());
    World& world = scene.world();
    for (auto [entity, toon] : world.query<Toon>()) toon = {.bands = 3, .softness = 0.2f};
    for (auto [entity, brush] : world.query<ImplicitBrush>())
        brush = {.feature = BrushFeature::luminance_edges, .peak_low = 0.1f, .peak_high = 0.4f};
    expect_smaller_with_the_step(
        scene, [&](double at) { scene.turn_light(at); }, 8.0, 32.0, 1);
}

TEST_P(BrushesMotionTest, SoIsHalfTheStepOfAPose) {
    BrushedScene scene(context(), arm_model());
    scene.play("bend");
    double before = 0.0;
    expect_smaller_with_the_step(
        scene,
        [&](double at) {
            scene.play_on(at > before ? at - before : 0.0);
            before = at;
            if (at == 0.0) scene.play("bend");
        },
        0.04, 0.2, 1);
}

TEST_P(BrushesMotionTest, WhatStandsStillIsPaintedTheSame) {
    BrushedScene scene(context(), still_model());
    scene.turn(20.0);
    const assets::Image first = scene.paint();
    EXPECT_EQ(scene.paint().pixels, first.pixels);
    scene.turn(21.0);
    static_cast<void>(scene.paint());
    scene.turn(20.0);
    EXPECT_EQ(scene.paint().pixels, first.pixels) << "after another frame";
    BrushedScene other(context(), still_model());
    other.turn(20.0);
    EXPECT_EQ(other.paint().pixels, first.pixels) << "in another world";
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(BrushesMotionTest);

} // namespace
} // namespace hachure::test
