#include <hachure/components/rig.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/systems/implicit_brush/noise_measures.h>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace hachure::test {
namespace {

constexpr Canvas motion_canvas{320, 240};

/// Frames of something that moves, and how far its noise moves with it.
struct BrushNoiseMotionTest : ::testing::Test {
    static constexpr std::size_t screen = 0, solid = 1, advected = 2;

    void SetUp() override {
        std::string reason;
        context = GlContexts::use(gpu::Backend::egl, reason);
        if (!context) GTEST_SKIP() << "no EGL context: " << reason;
        make();
    }

    void make() {
        scene = std::make_unique<NoiseScene>(*context, motion_canvas,
                                             std::vector<BrushNoiseKey>{{.grain = BrushGrain::screen},
                                                                        {.grain = BrushGrain::solid},
                                                                        {.grain = BrushGrain::advected}});
        for (const char* aov : {"velocity", "normal", "object_id"}) scene->renderer().request_aov(aov);
        camera = scene->add(Camera{.projection = Projection::orthographic, .ymag = 1.0f}, {.translation = {0, 0, 5}});
    }

    [[nodiscard]] World& world() { return scene->world(); }

    /// RMS over frames 1 to `frames` of what noise changes while it is followed along its surface, by key. `move` makes
    /// each frame.
    std::array<double, 3> moved_differences(int frames, const std::function<void(int)>& move) {
        std::array<double, 3> sums{};
        std::array<NoiseImage, 3> before;
        NoiseImage ids_before;
        for (int frame = 0; frame <= frames; ++frame) {
            move(frame);
            scene->renderer().render_frame(1.0 / 30.0);
            const NoiseImage velocity = scene->read("velocity"), normal = scene->read("normal");
            const NoiseImage ids = scene->read("object_id");
            const PixelMask seen_twice = [&](int x, int y) {
                if (ids.at(x, y).x == 0.0f || std::abs(normal.at(x, y).z) < 0.4f) return false;
                const glm::ivec2 from(glm::vec2(x, y) - glm::vec2(velocity.at(x, y)));
                if (from.x < 0 || from.y < 0 || from.x >= motion_canvas.width || from.y >= motion_canvas.height)
                    return false;
                return ids_before.at(from.x, from.y).x == ids.at(x, y).x;
            };
            for (std::size_t i = 0; i < 3; ++i) {
                NoiseImage now = scene->noise(i);
                if (frame > 0) sums[i] += std::pow(moved_difference(now, before[i], velocity, seen_twice), 2);
                before[i] = std::move(now);
            }
            ids_before = ids;
        }
        for (double& sum : sums) sum = std::sqrt(sum / frames);
        return sums;
    }

    void expect_held(const std::array<double, 3>& differences) {
        RecordProperty("screen", std::to_string(differences[screen]));
        RecordProperty("solid", std::to_string(differences[solid]));
        RecordProperty("advected", std::to_string(differences[advected]));
        EXPECT_GT(differences[screen], 0.05) << "nothing moved";
        EXPECT_LT(differences[solid], differences[screen] / 3.0);
        EXPECT_LT(differences[advected], differences[screen] / 3.0);
    }

    gpu::Context* context = nullptr;
    std::unique_ptr<NoiseScene> scene;
    Entity camera;
};

TEST_F(BrushNoiseMotionTest, HoldsToWhatTurns) {
    const Entity ball = scene->add(surface_mesh(geometry::icosphere(0.9, 5)));
    expect_held(moved_differences(10, [&](int frame) {
        world().get_mutable<Transform>(ball).rotation =
            glm::angleAxis(glm::radians(2.0f * static_cast<float>(frame)), glm::normalize(glm::vec3(1, 2, 0.5f)));
    }));
}

TEST_F(BrushNoiseMotionTest, HoldsToWhatTheCameraPassesAndComesNearTo) {
    scene->add(surface_mesh(geometry::torus(0.6, 0.25, 64, 32)));
    world().get_mutable<Camera>(camera) = {.yfov = 0.6f};
    expect_held(moved_differences(10, [&](int frame) {
        const auto t = static_cast<float>(frame);
        world().get_mutable<Transform>(camera).translation = {0.03f * t, 0.01f * t, 5.0f * std::exp2(-0.05f * t)};
    }));
}

TEST_F(BrushNoiseMotionTest, HoldsToASkinThatBends) {
    const SpawnedModel arm = spawn_model(world(), arm_model());
    world().get_mutable<Transform>(arm.root) = {.translation = {0.0f, -0.8f, 0.0f},
                                                .rotation = glm::angleAxis(0.4f, glm::vec3(0, 1, 0))};
    const Entity elbow = world().get<Rig>(arm.root).nodes[2];
    expect_held(moved_differences(10, [&](int frame) {
        world().get_mutable<Transform>(elbow).rotation =
            glm::angleAxis(0.06f * static_cast<float>(frame), glm::vec3(0, 0, 1));
    }));
}

/// Noise is made anew again and again, for as long as it turns; it neither pops nor fades.
TEST_F(BrushNoiseMotionTest, AdvectedNoiseIsRenewedWithoutASeam) {
    const Entity ball = scene->add(surface_mesh(geometry::icosphere(0.9, 5)));
    const auto turn = [&](float angle) {
        world().get_mutable<Transform>(ball).rotation = glm::angleAxis(angle, glm::vec3(0, 1, 0));
    };
    double most = 0.0, least = 1.0;
    for (int frame = 0; frame < 100; ++frame) {
        turn(0.05f * static_cast<float>(frame));
        if (frame % 7 != 0) {
            scene->renderer().skip_frame();
            continue;
        }
        scene->renderer().render_frame();
        const NoiseImage image = scene->noise(advected);
        const NoiseStatistics found = statistics(image, middle_disk(image, 90.0));
        EXPECT_NEAR(grain_size(image, middle_disk(image, 60.0)), 12.0, 3.6) << frame;
        double variance = 0.0;
        for (const double channel : found.variance) variance += channel / 4.0;
        most = std::max(most, variance);
        least = std::min(least, variance);
    }
    EXPECT_GT(least, 0.29);
    EXPECT_LT(most, 0.38);
}

TEST_F(BrushNoiseMotionTest, AdvectedGrainsKeepTheirSizeOverAZoomOf16) {
    scene->add(surface_mesh(geometry::icosphere(8.0, 6)), {.translation = {0.0f, 0.0f, -8.0f}});
    double least = 1e9, most = 0.0;
    for (int frame = 0; frame <= 96; ++frame) {
        world().get_mutable<Camera>(camera).ymag = std::exp2(-static_cast<float>(frame) / 24.0f);
        if (frame % 6 != 0) {
            scene->renderer().skip_frame();
            continue;
        }
        scene->renderer().render_frame();
        const NoiseImage image = scene->noise(advected);
        const double size = grain_size(image);
        least = std::min(least, size);
        most = std::max(most, size);
    }
    RecordProperty("least", std::to_string(least));
    RecordProperty("most", std::to_string(most));
    EXPECT_GT(least, 12.0 * 0.85);
    EXPECT_LT(most, 12.0 * 1.15);
}

/// What moves along the screen is not stretched: its noise goes along and stays the same.
TEST_F(BrushNoiseMotionTest, AdvectedNoiseIsNotRenewedByMotionAlongTheScreen) {
    const Entity ball = scene->add(surface_mesh(geometry::icosphere(0.4, 5)));
    world().get_mutable<Transform>(ball).translation.x = -0.5f;
    scene->renderer().render_frame();
    const NoiseImage before = scene->noise(advected);
    for (int frame = 1; frame <= 60; ++frame) {
        world().get_mutable<Transform>(ball).translation.x = -0.5f + static_cast<float>(frame) / 60.0f;
        scene->renderer().skip_frame();
    }
    scene->renderer().render_frame();
    const NoiseImage now = scene->noise(advected);
    NoiseImage moved = now;
    for (int y = 0; y < now.height; ++y)
        for (int x = 0; x + 120 < now.width; ++x)
            moved.values[static_cast<std::size_t>(y * now.width + x)] = now.at(x + 120, y);
    const PixelMask inside = [](int x, int y) { return std::hypot(x - 99.5, y - 119.5) < 44.0; };
    EXPECT_LT(difference(before, moved, inside), 0.01);
}

/// Frame k is frame k, whichever frames were drawn before it.
TEST_F(BrushNoiseMotionTest, IsTheSameWhenFramesBeforeAreSkipped) {
    const auto play = [&](bool draw_all) {
        make();
        const SpawnedModel arm = spawn_model(world(), arm_model());
        const Entity ball = scene->add(surface_mesh(geometry::icosphere(0.5, 4)));
        const Entity elbow = world().get<Rig>(arm.root).nodes[2];
        for (int frame = 0; frame <= 40; ++frame) {
            const glm::quat turn = glm::angleAxis(0.05f * static_cast<float>(frame), glm::vec3(0, 1, 0));
            world().get_mutable<Transform>(elbow).rotation = turn;
            world().get_mutable<Transform>(ball).rotation = turn;
            if (draw_all || frame == 40)
                scene->renderer().render_frame(1.0 / 30.0);
            else
                scene->renderer().skip_frame(1.0 / 30.0);
        }
        return std::array{scene->noise(solid), scene->noise(advected)};
    };
    const auto drawn = play(true), skipped = play(false);
    EXPECT_EQ(largest_difference(drawn[0], skipped[0]), 0.0);
    EXPECT_EQ(largest_difference(drawn[1], skipped[1]), 0.0);
}

TEST_F(BrushNoiseMotionTest, ACutStartsAnew) {
    scene->add(surface_mesh(geometry::icosphere(0.9, 5)));
    world().get_mutable<Camera>(camera) = {.yfov = 0.6f};
    scene->renderer().render_frame();
    world().get_mutable<Transform>(camera) = {.translation = {1.0f, 0.0f, -2.0f},
                                              .rotation = glm::angleAxis(glm::radians(180.0f), glm::vec3(0, 1, 0))};
    scene->renderer().render_frame();
    const NoiseImage image = scene->noise(advected);
    EXPECT_TRUE(statistics(image).in_range);
    EXPECT_NEAR(grain_size(image), 12.0, 1.8);
}

TEST(PointMotionTest, TellsMotionAlongTheScreenFromMotionApart) {
    const std::vector<glm::vec3> before{{0, 0, 1}, {2, 0, 1}, {5, 5, -1}, {500, 5, 1}},
        now{{10, 1, 1}, {14, 1, 1}, {0, 0, 1}, {0, 0, 1}};
    const PointMotion motion = point_motion(before, now, {100, 100});
    EXPECT_EQ(motion.points, 2u) << "one was behind the eye, one far beside the view";
    EXPECT_FLOAT_EQ(motion.mean.x, 11.0f);
    EXPECT_FLOAT_EQ(motion.mean.y, 1.0f);
    EXPECT_NEAR(motion.apart, 1.0f, 1e-3f);
    EXPECT_EQ(point_motion({}, {}, {100, 100}).apart, 0.0f);
}

} // namespace
} // namespace hachure::test
