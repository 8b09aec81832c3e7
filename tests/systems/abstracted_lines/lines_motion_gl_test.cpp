// Lines over time: an object that stands still has the same lines bit for bit, one that turns by half the step changes
// by half as much, and what a frame shows does not depend on the frames before it.

#include <hachure/components/abstracted_lines.h>
#include <hachure/components/tone_image.h>
#include <hachure/components/toon.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/picture/popping.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/styles/style.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace hachure::test {
namespace {

constexpr Canvas canvas{320, 240};

/// Something in style `lines` that can be turned.
class TurnedScene {
public:
    explicit TurnedScene(gpu::Context& context) : scene_(context, canvas) {
        const std::filesystem::path bunny = "/usr/share/glmark2/models/bunny.obj";
        std::vector<glm::vec3> points;
        if (std::filesystem::exists(bunny)) {
            const SpawnedModel spawned = spawn_model(scene_.world(), assets::read_model(bunny));
            root_ = spawned.root;
            points = spawned.points;
        } else {
            const geometry::Shape shape = geometry::torus(1.0, 0.4, 96, 48);
            points = shape.positions;
            root_ = scene_.add(surface_mesh(shape));
        }
        spawn_framing_camera(scene_.world(), points, canvas);
        spawn_default_light(scene_.world());
        apply_style(scene_.world(), scene_.app().types(), find_style(scene_.app().types(), "lines"));
        scene_.renderer().request_aov("line_opacity");
    }

    /// Opacity of dark and of highlight lines, and nothing, as colours.
    assets::Image lines(double degrees) {
        Transform transform = scene_.world().get<Transform>(root_);
        transform.rotation = glm::angleAxis(static_cast<float>(glm::radians(degrees)), glm::vec3(0.0f, 1.0f, 0.0f));
        scene_.world().get_mutable<Transform>(root_) = transform;
        scene_.renderer().render_frame();
        const assets::Image opacity = scene_.renderer().read_aov("line_opacity");
        assets::Image picture = assets::make_image(opacity.width, opacity.height, 3, assets::PixelType::f32);
        const auto pixels = static_cast<std::size_t>(opacity.width) * static_cast<std::size_t>(opacity.height);
        for (std::size_t i = 0; i < pixels; ++i) std::copy_n(opacity.f32() + 2 * i, 2, picture.f32() + 3 * i);
        return picture;
    }

private:
    DrawnScene scene_;
    Entity root_;
};

using AbstractedLinesMotionTest = GlTest;

/// The change that motion does not explain, of all but a thousandth of the pixels, at its worst on the way.
double largest_change(TurnedScene& scene, double step, double degrees, int reach) {
    picture::PoppingMeter meter(reach);
    double largest = 0.0;
    for (double at = 0.0; at <= degrees + 1e-9; at += step)
        if (const auto change = meter.add(scene.lines(at))) largest = std::max(largest, change->p999);
    return largest;
}

TEST_P(AbstractedLinesMotionTest, HalfTheTurnIsHalfTheChange) {
    TurnedScene scene(context());
    constexpr int reach = 1; // a point of the outline moves by up to 2 pixels a degree here
    const double whole = largest_change(scene, 1.0, 8.0, reach), half = largest_change(scene, 0.5, 8.0, reach),
                 quarter = largest_change(scene, 0.25, 8.0, reach), eighth = largest_change(scene, 0.125, 8.0, reach);
    RecordProperty("whole", std::to_string(whole));
    RecordProperty("half", std::to_string(half));
    RecordProperty("quarter", std::to_string(quarter));
    EXPECT_GT(whole, 1.0) << "nothing moves: the test measures nothing";
    EXPECT_LE(half, 0.75 * whole) << whole << " " << half << " " << quarter;
    EXPECT_LE(quarter, 0.75 * half);
    EXPECT_LE(eighth, 0.75 * quarter);
    EXPECT_LE(eighth, 10.0) << "of 255";
}

TEST_P(AbstractedLinesMotionTest, WhatStandsStillHasTheSameLines) {
    TurnedScene scene(context());
    const assets::Image first = scene.lines(20.0);
    EXPECT_EQ(scene.lines(20.0).pixels, first.pixels);
    static_cast<void>(scene.lines(21.0));
    EXPECT_EQ(scene.lines(20.0).pixels, first.pixels) << "after another frame";
    TurnedScene other(context());
    EXPECT_EQ(other.lines(20.0).pixels, first.pixels) << "in another world";
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(AbstractedLinesMotionTest);

} // namespace
} // namespace hachure::test
