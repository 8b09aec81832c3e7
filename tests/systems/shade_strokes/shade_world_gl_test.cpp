// Shade strokes in a world with everything else: what their AOVs show, what a frame costs, what they follow.

#include <hachure/components/animation.h>
#include <hachure/components/curvature.h>
#include <hachure/components/deform.h>
#include <hachure/components/light.h>
#include <hachure/components/shade_strokes.h>
#include <hachure/components/shade_volume.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/shade_strokes/shade_counts.h>
#include <hachure/systems/shade_strokes/shade_frame.h>
#include <hachure/tests/runtime/ecs/thread_limit.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace hachure::test {
namespace {

constexpr Canvas shade_canvas{160, 120};
const glm::vec3 sun_from = glm::normalize(glm::vec3(-1, 1, 1));

Transform shining_from(const glm::vec3& towards) {
    return {.rotation = glm::quatLookAt(-glm::normalize(towards), glm::vec3(0.1f, 1.0f, 0.05f))};
}

/// One surface with strokes, a sun, and a camera that looks along -Z.
class ShadedScene {
public:
    ShadedScene(gpu::Context& context, const geometry::Shape& shape, const ShadeStrokes& style = {.cells = 3000})
        : scene(context, shade_canvas) {
        surface = scene.add(surface_mesh(shape));
        world().add(surface, style);
        camera = scene.add(Camera{.yfov = 0.5f}, {.translation = {0, 0, 5}});
        sun = world().create_with(shining_from(sun_from), Light{});
    }

    [[nodiscard]] World& world() { return scene.world(); }
    [[nodiscard]] const ShadeCounts& counts() { return world().resource<ShadeCounts>(); }

    void ask_for(std::initializer_list<const char*> aovs) {
        for (const char* aov : aovs) scene.renderer().request_aov(aov);
    }
    [[nodiscard]] assets::Image aov(const char* name) { return scene.renderer().read_aov(name); }

    DrawnScene scene;
    Entity surface, camera, sun;
};

double mean_of(const assets::Image& image) {
    double sum = 0.0;
    for (int i = 0; i < image.width * image.height; ++i) sum += double(image.f32()[i * image.channels]);
    return sum / (image.width * image.height);
}

using ShadeWorldTest = GlTest;

/// On a sphere, whose normals are known; a pixel shows the need of its cell, which spans some of them.
TEST_P(ShadeWorldTest, NeededShadeIsWhatTheLightLeaves) {
    ShadedScene shaded(context(), geometry::icosphere(1.0, 5));
    shaded.ask_for({"shade_needed", "shade_delivered", "normal", "object_id"});
    shaded.scene.renderer().render_frame();
    const assets::Image needed = shaded.aov("shade_needed"), delivered = shaded.aov("shade_delivered"),
                        normal = shaded.aov("normal"), id = shaded.aov("object_id");
    const ShadeStrokes style;
    double off = 0.0, undelivered = 0.0;
    int count = 0;
    for (int i = 0; i < shade_canvas.width * shade_canvas.height; ++i) {
        if (id.f32()[i] == 0.0f) {
            EXPECT_EQ(needed.f32()[i], 0.0f);
            EXPECT_EQ(delivered.f32()[i], 0.0f);
            continue;
        }
        const glm::dvec3 n(normal.f32()[3 * i], normal.f32()[3 * i + 1], normal.f32()[3 * i + 2]);
        const double light = std::max(0.0, glm::dot(n, glm::dvec3(sun_from)));
        const double expected = std::clamp(1.0 - light / double(style.no_shade), 0.0, 1.0);
        EXPECT_NEAR(needed.f32()[i], expected, 0.12);
        off += std::abs(double(needed.f32()[i]) - expected);
        undelivered += std::abs(double(delivered.f32()[i]) - double(needed.f32()[i]));
        ++count;
    }
    EXPECT_GT(count, 2000);
    EXPECT_LT(off / count, 0.025);
    EXPECT_LT(undelivered / count, double(style.dead_band));
}

/// Two triangles that a lamp stands close to: what they need differs within each, and pixels know where they are.
TEST_P(ShadeWorldTest, CellsDivideLargeTriangles) {
    geometry::Shape square;
    for (const glm::vec2 p : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        square.positions.emplace_back(p, 0.0f);
        square.normals.emplace_back(0, 0, 1);
    }
    square.indices = {0, 1, 2, 0, 2, 3};
    ShadedScene shaded(context(), square, {.no_shade = 1.0f, .cells = 1500});
    shaded.world().get_mutable<Light>(shaded.sun).kind = LightKind::point;
    const glm::vec3 lamp(0.3f, -0.2f, 0.7f);
    shaded.world().get_mutable<Transform>(shaded.sun) = {.translation = lamp};
    shaded.ask_for({"shade_needed", "object_id"});
    shaded.scene.renderer().render_frame();
    const assets::Image needed = shaded.aov("shade_needed"), id = shaded.aov("object_id");
    double off = 0.0;
    int count = 0;
    const double metre = 0.5 * shade_canvas.height / (5.0 * std::tan(0.25)); // pixels
    for (int y = 0; y < shade_canvas.height; ++y)
        for (int x = 0; x < shade_canvas.width; ++x) {
            if (id.f32()[y * shade_canvas.width + x] == 0.0f) continue;
            const glm::dvec3 place((x + 0.5 - 0.5 * shade_canvas.width) / metre,
                                   (0.5 * shade_canvas.height - y - 0.5) / metre, 0.0);
            const glm::dvec3 to_lamp = glm::dvec3(lamp) - place;
            const double expected = 1.0 - glm::normalize(to_lamp).z;
            off += std::abs(double(needed.f32()[y * shade_canvas.width + x]) - expected);
            ++count;
        }
    EXPECT_GT(count, 1000);
    EXPECT_LT(off / count, 0.015);
}

/// Each surface is drawn with the values of its own cells: two beside each other look as each does alone.
TEST_P(ShadeWorldTest, EachSurfaceShowsItsOwnCells) {
    const auto draw = [&](bool left, bool right) {
        ShadedScene shaded(context(), geometry::torus(0.5, 0.2, 48, 24), {.cells = 900});
        shaded.world().get_mutable<Transform>(shaded.surface).translation = {-0.9f, 0, 0};
        const Entity other = shaded.scene.add(surface_mesh(geometry::icosphere(0.7, 4)), {.translation = {0.9f, 0, 0}});
        shaded.world().add(other, ShadeStrokes{.cells = 1700});
        shaded.world().get_mutable<Surface>(shaded.surface).visible = left;
        shaded.world().get_mutable<Surface>(other).visible = right;
        shaded.ask_for({"shade_needed", "shade_delivered"});
        shaded.scene.renderer().render_frame();
        return std::pair{shaded.aov("shade_needed"), shaded.aov("shade_delivered")};
    };
    const auto both = draw(true, true), left = draw(true, false), right = draw(false, true);
    EXPECT_GT(std::min(mean_of(left.first), mean_of(right.first)), 0.01);
    for (int i = 0; i < shade_canvas.width * shade_canvas.height; ++i) {
        EXPECT_EQ(both.first.f32()[i], left.first.f32()[i] + right.first.f32()[i]);
        EXPECT_EQ(both.second.f32()[i], left.second.f32()[i] + right.second.f32()[i]);
    }
}

TEST_P(ShadeWorldTest, AovsAreEmptyWhereNothingIsShaded) {
    ShadedScene shaded(context(), geometry::icosphere(1.0, 3));
    shaded.ask_for({"shade_needed", "shade_delivered", "stroke_coverage"});
    shaded.scene.renderer().render_frame();
    EXPECT_GT(mean_of(shaded.aov("shade_needed")), 0.02);
    shaded.world().remove<ShadeStrokes>(shaded.surface);
    shaded.scene.renderer().render_frame();
    for (const char* name : {"shade_needed", "shade_delivered", "stroke_coverage"})
        EXPECT_EQ(mean_of(shaded.aov(name)), 0.0) << name;
    EXPECT_TRUE(shaded.world().resource<ShadeFrame>().surfaces.empty());
}

/// Strokes cover the side that the sun does not see.
TEST_P(ShadeWorldTest, StrokesCoverWhatIsDark) {
    ShadedScene shaded(context(), geometry::icosphere(1.0, 5));
    shaded.ask_for({"shade_needed", "stroke_coverage"});
    shaded.scene.renderer().render_frame();
    const assets::Image needed = shaded.aov("shade_needed"), coverage = shaded.aov("stroke_coverage");
    double dark = 0.0, bright = 0.0;
    int dark_count = 0, bright_count = 0;
    for (int i = 0; i < shade_canvas.width * shade_canvas.height; ++i) {
        const float need = needed.f32()[i];
        if (need > 0.8f) {
            dark += double(coverage.f32()[i]);
            ++dark_count;
        } else if (need > 0.0f && need < 0.15f) {
            bright += double(coverage.f32()[i]);
            ++bright_count;
        }
        EXPECT_GE(coverage.f32()[i], 0.0f);
        EXPECT_LE(coverage.f32()[i], 1.0f);
    }
    ASSERT_GT(std::min(dark_count, bright_count), 100);
    EXPECT_GT(dark / dark_count, 0.3);
    EXPECT_LT(bright / bright_count, 0.25 * dark / dark_count);
}

std::set<std::string> passes_run(DrawnScene& scene) {
    std::set<std::string> names;
    for (const auto& [name, state] : scene.draw_passes())
        if (state == gpu::PassState::run) names.insert(name);
    return names;
}

TEST_P(ShadeWorldTest, NothingMovedVisitsNothingAndRunsNoPass) {
    ShadedScene shaded(context(), geometry::icosphere(1.0, 4));
    shaded.ask_for({"shade_needed", "shade_delivered", "stroke_coverage"});
    static_cast<void>(shaded.scene.draw());
    EXPECT_GT(shaded.counts().triangles_swept, 0u);
    EXPECT_GT(shaded.counts().vertices, shaded.counts().segments);
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(passes_run(shaded.scene).empty());
        EXPECT_EQ(shaded.counts().triangles_swept, 0u);
        EXPECT_EQ(shaded.counts().triangles_touched, 0u);
        EXPECT_GT(shaded.counts().segments, 0u);
    }
}

TEST_P(ShadeWorldTest, ACameraThatMovesDrawsAndLooksAtNoTriangle) {
    ShadedScene shaded(context(), geometry::icosphere(1.0, 4));
    static_cast<void>(shaded.scene.draw());
    shaded.world().get_mutable<Transform>(shaded.camera).translation = {0.2f, 0, 5};
    EXPECT_FALSE(passes_run(shaded.scene).empty());
    EXPECT_EQ(shaded.counts().triangles_swept, 0u);
}

TEST_P(ShadeWorldTest, ALightThatMovesOrDimsIsFollowed) {
    ShadedScene shaded(context(), geometry::icosphere(1.0, 4));
    shaded.ask_for({"shade_delivered"});
    static_cast<void>(shaded.scene.draw());
    const assets::Image before = shaded.aov("shade_delivered");
    shaded.world().get_mutable<Transform>(shaded.sun) = shining_from({1, 1, 1});
    static_cast<void>(shaded.scene.draw());
    EXPECT_EQ(shaded.counts().triangles_swept, 5120u);
    EXPECT_GT(shaded.counts().triangles_touched, 500u);
    EXPECT_NE(shaded.aov("shade_delivered").pixels, before.pixels);
    // A second lamp is the brighter one: the sun counts for less.
    const double alone = mean_of(shaded.aov("shade_delivered"));
    shaded.world().create_with(shining_from({0, 0, -1}), Light{.intensity = 10.0f});
    static_cast<void>(shaded.scene.draw());
    EXPECT_GT(mean_of(shaded.aov("shade_delivered")), 1.3 * alone);
}

/// The only light of a scene fades in steps that are each smaller than the dead band, and comes back.
TEST_P(ShadeWorldTest, ALightThatFadesEndsFullyShadedAndComesBack) {
    ShadedScene shaded(context(), geometry::icosphere(1.0, 3), {.full_light = 3.0f, .cells = 300});
    shaded.ask_for({"shade_needed", "shade_delivered", "object_id"});
    const auto shine = [&](int of_60) {
        shaded.world().get_mutable<Light>(shaded.sun).intensity = 3.0f * static_cast<float>(of_60) / 60.0f;
        shaded.scene.renderer().skip_frame();
    };
    shaded.world().get_mutable<Light>(shaded.sun).intensity = 3.0f;
    shaded.scene.renderer().render_frame();
    const double lit = mean_of(shaded.aov("shade_delivered"));
    for (int i = 59; i >= 0; --i) shine(i);
    shaded.scene.renderer().render_frame();
    const assets::Image id = shaded.aov("object_id"), needed = shaded.aov("shade_needed"),
                        delivered = shaded.aov("shade_delivered");
    for (int i = 0; i < shade_canvas.width * shade_canvas.height; ++i) {
        if (id.f32()[i] == 0.0f) continue;
        EXPECT_NEAR(needed.f32()[i], 1.0f, 1e-5f);
        EXPECT_GT(delivered.f32()[i], 1.0f - 2.0f * ShadeStrokes{}.dead_band);
    }
    for (int i = 1; i <= 60; ++i) shine(i);
    shaded.scene.renderer().render_frame();
    EXPECT_NEAR(mean_of(shaded.aov("shade_delivered")), lit, double(ShadeStrokes{}.dead_band) * 0.5);
}

TEST_P(ShadeWorldTest, AVolumeIsAnEntity) {
    ShadedScene shaded(context(), geometry::icosphere(1.0, 4), {.cells = 2000, .density_by = ShadeDensityBy::volumes});
    shaded.ask_for({"shade_needed"});
    shaded.scene.renderer().render_frame();
    const double all = mean_of(shaded.aov("shade_needed"));
    shaded.world().create_with(Transform{.translation = {0.5f, -0.5f, 0.5f}, .scale = {0.8f, 0.8f, 0.8f}},
                               ShadeVolume{});
    shaded.scene.renderer().render_frame();
    EXPECT_LT(mean_of(shaded.aov("shade_needed")), 0.8 * all);
    EXPECT_GT(mean_of(shaded.aov("shade_needed")), 0.1 * all);
}

/// An arm that bends while the sun goes round.
class BendingArm {
public:
    explicit BendingArm(gpu::Context& context, bool follow_curvature = false) : scene(context, shade_canvas) {
        const SpawnedModel arm = spawn_model(scene.world(), arm_model());
        scene.world().add(arm.root, Animation{.clip = "bend"});
        surface = arm.surfaces[0];
        scene.world().add(surface, ShadeStrokes{.cells = 600});
        scene.world().add(surface, Deform{.device = DeformDevice::gpu});
        if (follow_curvature) scene.world().add(surface, Curvature{});
        spawn_framing_camera(scene.world(), arm.points, shade_canvas);
        sun_ = scene.world().create_with(shining_from(sun_from), Light{});
        scene.renderer().request_aov("shade_delivered");
    }

    /// The next frame, drawn or only lived through.
    void step(bool draw) {
        const float angle = 0.15f * static_cast<float>(frame_++);
        scene.world().get_mutable<Transform>(sun_) = shining_from({std::sin(angle), 0.6f, std::cos(angle)});
        if (draw)
            scene.renderer().render_frame(1.0 / 12.0);
        else
            scene.renderer().skip_frame(1.0 / 12.0);
    }

    struct Frame {
        std::vector<std::byte> picture, delivered;
        friend bool operator==(const Frame&, const Frame&) = default;
    };
    [[nodiscard]] Frame frame() {
        return {scene.renderer().read_picture().pixels, scene.renderer().read_aov("shade_delivered").pixels};
    }

    DrawnScene scene;
    Entity surface;

private:
    Entity sun_;
    int frame_ = 0;
};

TEST_P(ShadeWorldTest, StrokesFollowASurfaceThatDeforms) {
    BendingArm arm(context());
    arm.step(true);
    EXPECT_EQ(arm.scene.world().resource<DeformCounts>().on_gpu, 0u) << "strokes look at its shape on the CPU";
    std::uint64_t touched = 0;
    for (int i = 0; i < 4; ++i) {
        arm.step(true);
        EXPECT_EQ(arm.scene.world().resource<ShadeCounts>().triangles_swept, 160u);
        touched += arm.scene.world().resource<ShadeCounts>().triangles_touched;
    }
    EXPECT_GT(touched, 0u);
}

/// Strokes get narrow where it bends, are as many more as that takes, and get wide again as it straightens.
TEST_P(ShadeWorldTest, AmplitudesFollowTheCurvatureOfWhatDeforms) {
    BendingArm arm(context(), true), plain(context());
    for (BendingArm* of : {&arm, &plain}) {
        of->scene.world().get_mutable<ShadeStrokes>(of->surface).amplitude = 0.06f;
        of->scene.world().get_mutable<ShadeStrokes>(of->surface).amplitude_by_curvature = 1.0f;
    }
    const auto shares = [](BendingArm& of) { return of.scene.world().resource<ShadeFrame>().surfaces[0].narrowing; };
    const auto segments = [](BendingArm& of) { return of.scene.world().resource<ShadeCounts>().segments; };
    int frame = 0;
    const auto step_to = [&](int end) {
        for (; frame < end; ++frame)
            for (BendingArm* of : {&arm, &plain}) of->step(true);
    };
    step_to(1);
    EXPECT_GT(std::ranges::min(shares(arm)), 0.99f) << "it does not bend yet";
    step_to(11); // to 75 degrees
    EXPECT_LT(std::ranges::min(shares(arm)), 0.85f);
    EXPECT_GT(std::ranges::max(shares(arm)), 0.99f);
    EXPECT_TRUE(shares(plain).empty()) << "nobody asked";
    EXPECT_GT(segments(arm), segments(plain));
    step_to(12); // the clip begins again
    EXPECT_GT(std::ranges::min(shares(arm)), 0.99f);
    step_to(20);
    EXPECT_LT(std::ranges::min(shares(arm)), 0.95f);
    arm.scene.world().add(arm.surface, Curvature{.source = CurvatureSource::carried});
    step_to(21);
    EXPECT_TRUE(shares(arm).empty()) << "that knows of no bend";
}

/// Frames that are lived through without being drawn leave the strokes that drawn ones do.
TEST_P(ShadeWorldTest, StartedInTheMiddleFramesAreTheSame) {
    BendingArm whole(context(), true), late(context(), true);
    for (int i = 0; i < 7; ++i) whole.step(true);
    for (int i = 0; i < 6; ++i) late.step(false);
    late.step(true);
    EXPECT_TRUE(whole.frame() == late.frame());
    // Not so when they are left out: strokes depend on how the light came.
    BendingArm jumped(context(), true);
    jumped.step(true);
    EXPECT_FALSE(jumped.frame() == whole.frame());
}

TEST_P(ShadeWorldTest, ThreadsGiveTheSameFrames) {
    const auto frames = [&](int threads) {
        const ThreadLimit limit(threads);
        BendingArm arm(context(), true);
        std::vector<BendingArm::Frame> result;
        for (int i = 0; i < 5; ++i) {
            arm.step(true);
            result.push_back(arm.frame());
        }
        return result;
    };
    const auto one = frames(1);
    EXPECT_TRUE(one == frames(2));
    EXPECT_FALSE(one.front().picture == one.back().picture) << "frames that show nothing compare nothing";
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(ShadeWorldTest);

} // namespace
} // namespace hachure::test
