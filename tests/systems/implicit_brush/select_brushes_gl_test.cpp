// Which brushes paint on what, in what order, and what they share.

#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/systems/implicit_brush/brush_frame.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hachure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two balls, the second of them below a group.
class Balls {
public:
    explicit Balls(gpu::Context& context) : scene(context, {200, 100}) {
        const SurfaceMesh ball = test::surface_mesh(geometry::uv_sphere(1.0, 24, 12));
        left = scene.add(ball, {.translation = {-2, 0, 0}});
        group = world().create_with(Transform{});
        right = scene.add(ball, {.translation = {2, 0, 0}});
        world().set_parent(right, group);
        camera = scene.add(Camera{}, {.translation = {0, 0, 10}});
    }

    World& world() { return scene.world(); }

    Entity brush(Entity parent, const ImplicitBrush& values) {
        const Entity entity = world().create_with(values);
        if (parent) world().set_parent(entity, parent);
        return entity;
    }

    /// The sizes of the brushes that paint, in their order.
    std::vector<float> painted() {
        scene.renderer().render_frame();
        std::vector<float> sizes;
        for (const BrushDraw& draw : frame().draws) sizes.push_back(draw.brush.size);
        return sizes;
    }

    const BrushFrame& frame() { return world().resource<BrushFrame>(); }

    std::uint32_t id_of(Entity entity) {
        for (const DrawItem& item : world().resource<DrawList>().items)
            if (item.entity == entity) return item.object_id;
        ADD_FAILURE() << "not in view";
        return 0;
    }

    /// Whether the brush painted `at` has both balls, the left or the right one.
    std::string owner(std::size_t at) {
        const bool a = frame().owns(at, id_of(left)), b = frame().owns(at, id_of(right));
        return a && b ? "both" : a ? "left" : b ? "right" : "none";
    }

    test::DrawnScene scene;
    Entity left, group, right, camera;
};

using SelectBrushesTest = test::GlTest;

TEST_P(SelectBrushesTest, WithoutABrushNothingRuns) {
    Balls balls(context());
    EXPECT_THAT(balls.painted(), IsEmpty());
    for (const auto& [name, state] : balls.scene.draw_passes())
        EXPECT_EQ(name.find("brush"), std::string::npos) << name;
}

TEST_P(SelectBrushesTest, ABrushPaintsOnItsOwnEntity) {
    Balls balls(context());
    balls.world().add(balls.left, ImplicitBrush{.size = 3.0f});
    EXPECT_THAT(balls.painted(), ElementsAre(3.0f));
    EXPECT_EQ(balls.owner(0), "left");
    EXPECT_FALSE(balls.frame().draws[0].everywhere);
    EXPECT_LT(balls.frame().rect.width, 150) << "only where it can leave ink";
}

TEST_P(SelectBrushesTest, WithoutASurfaceItPaintsBelowItsParentOrOnAllThatIsSeen) {
    Balls balls(context());
    balls.brush(balls.group, {.size = 1.0f});
    balls.brush(balls.camera, {.size = 2.0f});
    balls.brush(Entity::null, {.size = 3.0f});
    balls.brush(balls.left, {.size = 4.0f});
    balls.world().add(balls.camera, ImplicitBrush{.size = 5.0f});
    EXPECT_THAT(balls.painted(), ElementsAre(5.0f, 1.0f, 2.0f, 3.0f, 4.0f));
    for (const auto& [at, owner] : std::vector<std::pair<std::size_t, std::string>>{
             {0, "both"}, {1, "right"}, {2, "both"}, {3, "both"}, {4, "left"}})
        EXPECT_EQ(balls.owner(at), owner) << at;
    EXPECT_TRUE(balls.frame().draws[2].everywhere);
}

TEST_P(SelectBrushesTest, TheBrushesOfACameraThatDoesNotLookRest) {
    Balls balls(context());
    const Entity other = balls.scene.add(Camera{.active = false}, {});
    balls.brush(other, {.size = 2.0f});
    balls.world().add(other, ImplicitBrush{.size = 3.0f});
    EXPECT_THAT(balls.painted(), IsEmpty());
}

TEST_P(SelectBrushesTest, TheOrderIsThatOfTheFieldAndThenOfEntities) {
    Balls balls(context());
    balls.brush(balls.camera, {.order = 2, .size = 1.0f});
    balls.brush(balls.camera, {.order = 1, .size = 2.0f});
    balls.brush(balls.camera, {.order = -1, .size = 3.0f});
    balls.brush(balls.camera, {.order = 1, .size = 4.0f});
    EXPECT_THAT(balls.painted(), ElementsAre(3.0f, 2.0f, 4.0f, 1.0f));
}

TEST_P(SelectBrushesTest, BrushesThatAreAlikeAreOne) {
    Balls balls(context());
    balls.world().add(balls.left, ImplicitBrush{.size = 1.0f});
    balls.world().add(balls.right, ImplicitBrush{.size = 1.0f});
    balls.brush(balls.left, {.size = 2.0f});
    balls.brush(balls.right, {.size = 2.0f});
    EXPECT_THAT(balls.painted(), ElementsAre(1.0f, 2.0f));
    EXPECT_TRUE(balls.frame().draws[0].everywhere);
}

TEST_P(SelectBrushesTest, BrushesOfOneFeatureShareItsExtraction) {
    Balls balls(context());
    balls.brush(balls.camera, {.feature = BrushFeature::valleys, .size = 1.0f});
    const auto one = balls.scene.draw_passes();
    balls.brush(balls.camera, {.feature = BrushFeature::valleys, .size = 2.0f});
    const auto two = balls.scene.draw_passes();
    EXPECT_EQ(balls.frame().features.size(), 1u);
    std::vector<std::string> added;
    for (const auto& [name, state] : two)
        if (!one.contains(name)) added.push_back(name);
    EXPECT_THAT(added, ElementsAre("brush_1", "brush_stamps_1"));
    EXPECT_NE(two.at("feature_profile_0"), gpu::PassState::run) << "a second brush pays no second extraction";
}

TEST_P(SelectBrushesTest, WhatLeavesNoInkIsNotPainted) {
    Balls balls(context());
    balls.brush(balls.camera, {.visible = false});
    balls.brush(balls.camera, {.peak = 0.0f});
    balls.brush(balls.camera, {.size = 0.0f});
    balls.brush(balls.camera, {.opacity = 0.0f});
    EXPECT_THAT(balls.painted(), IsEmpty());
    balls.brush(balls.camera, {.size = 0.0f, .size_by = BrushDriver::height}); // weak ones have weak_size
    EXPECT_EQ(balls.painted().size(), 1u);
}

TEST_P(SelectBrushesTest, AStillFrameRunsNothing) {
    Balls balls(context());
    balls.brush(balls.camera, {.feature = BrushFeature::ridges, .interruption = 0.3f});
    balls.scene.draw_passes();
    for (const auto& [name, state] : balls.scene.draw_passes()) EXPECT_NE(state, gpu::PassState::run) << name;
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(SelectBrushesTest);

} // namespace
} // namespace hachure
