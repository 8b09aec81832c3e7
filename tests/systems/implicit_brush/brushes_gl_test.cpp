// Whole frames with brushes: whose lines are drawn where, and which lie over which.

#include <hachure/components/compose.h>
#include <hachure/components/implicit_brush.h>
#include <hachure/components/toon.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

constexpr int balls_size = 160;

/// White balls before a white background: what is not white is ink.
class WhiteBalls {
public:
    explicit WhiteBalls(gpu::Context& context) : scene(context, {balls_size, balls_size}) {
        camera = scene.add(Camera{.projection = Projection::orthographic, .ymag = 2.0f}, {.translation = {0, 0, 10}});
    }

    Entity ball(const glm::vec3& place, double radius, bool brushed, const ImplicitBrush& brush = {}) {
        const Entity entity =
            scene.add(test::surface_mesh(geometry::uv_sphere(radius, 96, 48)), {.translation = place});
        scene.world().add(entity, Toon{.light = glm::vec3(1), .shade = glm::vec3(1), .ramp_use = RampUse::replace});
        if (brushed) scene.world().add(entity, brush);
        return entity;
    }

    /// How dark the picture is around a place of the world's plane z = 0: the greatest of a few pixels.
    double ink_at(const assets::Image& image, double x, double y, int channel = 1, int reach = 2) {
        const auto column = static_cast<int>((x / 2.0 * 0.5 + 0.5) * balls_size),
                   row = static_cast<int>((0.5 - y / 4.0) * balls_size);
        double ink = 0.0;
        for (int j = row - reach; j <= row + reach; ++j)
            for (int i = column - reach; i <= column + reach; ++i)
                ink = std::max(ink, 1.0 - image.u8()[3 * (j * balls_size + i) + channel] / 255.0);
        return ink;
    }

    test::DrawnScene scene;
    Entity camera;
};

using BrushesTest = test::GlTest;

TEST_P(BrushesTest, AnOutlineIsInkOnBothSidesOfIt) {
    WhiteBalls balls(context());
    balls.ball({0, 0, 0}, 1.0, true, {.size = 3.0f});
    const assets::Image image = balls.scene.draw();
    for (double angle = 0.0; angle < 6.28; angle += 0.2) {
        const double x = std::cos(angle), y = std::sin(angle), pixel = 4.0 / balls_size;
        EXPECT_GT(balls.ink_at(image, x, y, 1, 0), 0.7) << angle;
        EXPECT_GT(balls.ink_at(image, x * (1 + 2 * pixel), y * (1 + 2 * pixel), 1, 0), 0.3) << angle;
        EXPECT_GT(balls.ink_at(image, x * (1 - 2 * pixel), y * (1 - 2 * pixel), 1, 0), 0.3) << angle;
        EXPECT_EQ(balls.ink_at(image, 0.5 * x, 0.5 * y), 0.0) << angle;
    }
}

TEST_P(BrushesTest, AContourBelongsToWhatIsBefore) {
    WhiteBalls balls(context());
    balls.ball({-0.5, 0, 3}, 0.6, true); // before
    balls.ball({0.3, 0, 0}, 1.0, false); // behind it, without a brush
    assets::Image image = balls.scene.draw();
    EXPECT_GT(balls.ink_at(image, 0.1, 0), 0.7) << "its outline on the other ball";
    EXPECT_GT(balls.ink_at(image, -1.1, 0), 0.7) << "and on the background";
    EXPECT_EQ(balls.ink_at(image, 1.3, 0), 0.0) << "the other ball has none";
    WhiteBalls turned(context());
    turned.ball({-0.5, 0, 3}, 0.6, false);
    turned.ball({0.3, 0, 0}, 1.0, true);
    image = turned.scene.draw();
    EXPECT_EQ(turned.ink_at(image, 0.1, 0), 0.0) << "where the other is before, that one has none";
    EXPECT_GT(turned.ink_at(image, 1.3, 0), 0.7);
}

TEST_P(BrushesTest, LaterBrushesLieOverEarlierOnes) {
    WhiteBalls balls(context());
    balls.ball({0, 0, 0}, 1.0, false);
    World& world = balls.scene.world();
    const Entity red = world.create_with(ImplicitBrush{.size = 4.0f, .color = {1, 0, 0}});
    world.create_with(ImplicitBrush{.size = 2.0f, .color = {0, 0, 1}});
    assets::Image image = balls.scene.draw();
    EXPECT_GT(balls.ink_at(image, 1, 0, 0, 0), 0.7) << "blue takes red away";
    EXPECT_LT(balls.ink_at(image, 1, 0, 2, 0), 0.3);
    world.get_mutable<ImplicitBrush>(red).order = 1;
    image = balls.scene.draw();
    EXPECT_LT(balls.ink_at(image, 1, 0, 0, 0), 0.3) << "red lies over blue now";
    EXPECT_GT(balls.ink_at(image, 1, 0, 2, 0), 0.6);
}

TEST_P(BrushesTest, LinesAloneStandOnTheBackgroundInTheColoursOfWhatIsNotShown) {
    WhiteBalls balls(context());
    const Entity ball = balls.ball({0, 0, 0}, 1.0, true, {.size = 3.0f, .coloring = BrushColor::surface});
    auto& toon = balls.scene.world().get_mutable<Toon>(ball);
    toon.light = toon.shade = {0, 0, 1};
    balls.scene.world().add(balls.camera, Compose{.surfaces = false});
    const assets::Image image = balls.scene.draw();
    EXPECT_EQ(balls.ink_at(image, 0, 0), 0.0) << "the ball is not shown";
    EXPECT_GT(balls.ink_at(image, 1, 0, 0, 0), 0.7) << "its outline is, in blue";
    EXPECT_LT(balls.ink_at(image, 1, 0, 2, 0), 0.3);
}

TEST_P(BrushesTest, WeightsAreThoseOfTheBrushAPixelCountsMostIn) {
    WhiteBalls balls(context());
    balls.ball({0, 0, 0}, 1.0, false);
    balls.scene.world().create_with(ImplicitBrush{.peak = 0.5f, .spread = 2.0f});
    balls.scene.world().create_with(ImplicitBrush{.peak = 0.9f, .spread = 1.0f, .size = 2.0f});
    balls.scene.renderer().request_aov("brush_weight");
    balls.scene.renderer().render_frame();
    const assets::Image weights = balls.scene.renderer().read_aov("brush_weight");
    float most = 0.0f;
    for (int i = 0; i < balls_size * balls_size; ++i) {
        ASSERT_TRUE(weights.f32()[i] >= 0.0f && weights.f32()[i] <= 0.9f + 1e-3f);
        most = std::max(most, weights.f32()[i]);
    }
    EXPECT_GT(most, 0.85f);
    EXPECT_EQ(weights.f32()[0], 0.0f);
}

HACHURE_INSTANTIATE_GL_TESTS(BrushesTest);

} // namespace
} // namespace hachure
