// The system that keeps the strokes of all surfaces, with lists made by hand: no context, no other system.

#include <hachure/systems/shade_strokes/select_shade.h>
#include <hachure/tests/runtime/ecs/thread_limit.h>
#include <hachure/tests/support/shade_rig.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <limits>

#include "chain_checks.h"

namespace hachure::test {
namespace {

class ShadeWorld {
public:
    ShadeWorld() {
        view.width = 640;
        view.height = 480;
        view.eye = {0, 0, 5, 1};
        lights.lights = {shade_sun({1, 1, 1})};
    }

    Entity add(const geometry::Shape& shape, const ShadeStrokes& style = {.cells = 300}) {
        SurfaceMesh mesh;
        mesh.name = "shape";
        mesh.positions = shape.positions;
        mesh.normals = shape.normals;
        mesh.indices = shape.indices;
        const std::uint32_t index = store.add(std::move(mesh));
        const Entity entity = world.create_with(ShadeStrokes(style));
        DrawItem item;
        item.entity = entity;
        item.mesh = index;
        item.object_id = index + 1;
        item.rect = {100, 100, 50, 50};
        list.items.push_back(item);
        return entity;
    }

    void step(const std::vector<Entity>& bare = {}) {
        select_(world.query<const ShadeStrokes, Optional<const Curvature>, Optional<const PrincipalCurvatures>>(),
                Removed<ShadeStrokes>(bare), world.query<const ShadeVolume, const WorldTransform>(), list, store,
                lights, strength, view, time, frame, needs, counts, layer);
    }

    void place_sun(double degrees) {
        const auto a = static_cast<float>(glm::radians(degrees));
        lights.lights = {shade_sun({std::sin(a), 0.4f, std::cos(a)})};
    }

    [[nodiscard]] std::vector<float> needed(std::size_t surface = 0) const {
        const std::span<const float> all = needs.surfaces.at(surface).needed;
        return {all.begin(), all.end()};
    }

    World world;
    DrawList list;
    MeshStore store;
    LightList lights;
    LightStrength strength;
    View view;
    Time time;
    ShadeFrame frame;
    ShadeNeeds needs;
    ShadeCounts counts;
    LineLayer layer;

private:
    SelectShade select_;
};

/// Whether two frames have the same strokes, bit for bit.
bool same_strokes(const ShadeFrame& a, const ShadeFrame& b) {
    if (a.surfaces.size() != b.surfaces.size()) return false;
    for (std::size_t i = 0; i < a.surfaces.size(); ++i)
        if (!same_chains(*a.surfaces[i].chains, *b.surfaces[i].chains)) return false;
    return true;
}

TEST(SelectShadeTest, FillsTheFrameInTheOrderOfTheList) {
    ShadeWorld world;
    const Entity ball = world.add(geometry::icosphere(1.0, 3)), torus = world.add(geometry::torus(1.0, 0.4, 24, 12));
    world.list.items.push_back({.entity = world.world.create()}); // one without strokes
    world.step();
    ASSERT_EQ(world.frame.surfaces.size(), 2u);
    EXPECT_EQ(world.frame.surfaces[0].entity, ball);
    EXPECT_EQ(world.frame.surfaces[1].entity, torus);
    EXPECT_EQ(world.frame.surfaces[1].item, 1u);
    EXPECT_EQ(world.frame.surfaces[1].style, (ShadeStrokes{.cells = 300}));
    for (const ShadeSurface& surface : world.frame.surfaces) {
        EXPECT_GT(surface.chains->segments.live(), 20u);
        EXPECT_EQ(surface.chains->cells.size(), surface.mesh->cell_count());
    }
    EXPECT_EQ(world.counts.triangles_swept, 1280u + 576u);
    EXPECT_GT(world.counts.triangles_touched, 500u);
    EXPECT_EQ(world.counts.segments,
              world.frame.surfaces[0].chains->segments.live() + world.frame.surfaces[1].chains->segments.live());
    EXPECT_TRUE(world.layer.rect().width >= 50 && world.layer.rect().width < 100);
}

TEST(SelectShadeTest, WithoutStrokesNothingIsKeptOrAllocated) {
    ShadeWorld world;
    world.list.items.push_back({.entity = world.world.create()});
    world.step();
    EXPECT_EQ(world.frame.surfaces.capacity(), 0u);
    EXPECT_EQ(world.needs.surfaces.capacity(), 0u);
    EXPECT_EQ(world.layer.rect().width, 0);
    EXPECT_EQ(world.counts.triangles_swept, 0u);
}

/// A light that stands in the world is the same from wherever it is looked at.
TEST(SelectShadeTest, NothingMovedOrTheCameraAloneVisitsNothing) {
    ShadeWorld world;
    world.add(geometry::icosphere(1.0, 4));
    world.step();
    const std::uint64_t key = world.frame.key, needs_key = world.needs.key;
    for (int i = 0; i < 3; ++i) {
        world.view.eye = {i, 0, 5, 1};
        world.step();
        EXPECT_EQ(world.counts.triangles_swept, 0u);
        EXPECT_EQ(world.counts.triangles_touched, 0u);
        EXPECT_EQ(world.frame.key, key);
        EXPECT_EQ(world.needs.key, needs_key);
        EXPECT_GT(world.counts.segments, 0u);
    }
}

TEST(SelectShadeTest, ALightThatMovesTouchesWhatItChanges) {
    ShadeWorld world;
    world.add(geometry::icosphere(1.0, 5), {.cells = 2000});
    world.place_sun(0);
    world.step();
    const std::uint64_t key = world.frame.key;
    world.place_sun(4);
    world.step();
    EXPECT_EQ(world.counts.triangles_swept, 20480u);
    EXPECT_GT(world.counts.triangles_touched, 100u);
    EXPECT_LT(world.counts.triangles_touched, 20480u / 2);
    EXPECT_NE(world.frame.key, key);
}

/// One surface's light changes with its transform, the other stays as it is.
TEST(SelectShadeTest, OnlyTheSurfaceThatMovesIsLookedAt) {
    ShadeWorld world;
    world.add(geometry::icosphere(1.0, 3));
    world.add(geometry::torus(1.0, 0.4, 24, 12));
    world.step();
    world.list.items[1].world_from_entity = glm::rotate(glm::mat4(1.0f), 0.3f, glm::vec3(1, 0, 0));
    world.step();
    EXPECT_EQ(world.counts.triangles_swept, 576u);
}

TEST(SelectShadeTest, OtherSettingsStartOver) {
    ShadeWorld world, fresh;
    const Entity entity = world.add(geometry::icosphere(1.0, 3));
    world.place_sun(0);
    world.step();
    world.place_sun(40);
    world.step();
    world.world.get_mutable<ShadeStrokes>(entity).seed = 7;
    world.step();
    fresh.add(geometry::icosphere(1.0, 3), {.cells = 300, .seed = 7});
    fresh.place_sun(40);
    fresh.step();
    EXPECT_TRUE(same_strokes(world.frame, fresh.frame));
    world.world.get_mutable<ShadeStrokes>(entity).cells = 600;
    world.step();
    EXPECT_GT(world.frame.surfaces[0].mesh->cell_count(), 1.5 * double(fresh.frame.surfaces[0].mesh->cell_count()));
    EXPECT_FALSE(same_strokes(world.frame, fresh.frame));
}

TEST(SelectShadeTest, WhatOnlyDrawsLeavesStrokesAlone) {
    ShadeWorld world;
    const Entity entity = world.add(geometry::icosphere(1.0, 3));
    world.step();
    const std::uint64_t key = world.frame.key;
    world.world.get_mutable<ShadeStrokes>(entity).color = {1, 0, 0};
    world.step();
    EXPECT_EQ(world.counts.triangles_swept, 0u);
    EXPECT_NE(world.frame.key, key) << "they are drawn anew";
}

TEST(SelectShadeTest, FlickerCountsTicksAlone) {
    ShadeWorld world;
    world.add(geometry::icosphere(1.0, 3), {.cells = 300, .flicker = 0.5f, .flicker_rate = 10.0f});
    world.step();
    const std::uint64_t key = world.frame.key;
    world.time.elapsed = 0.05;
    world.step();
    EXPECT_EQ(world.frame.key, key);
    world.time.elapsed = 0.15;
    world.step();
    EXPECT_NE(world.frame.key, key);
}

TEST(SelectShadeTest, MeshesOfEqualContentsAreLookedAtOnce) {
    ShadeWorld world;
    world.add(geometry::icosphere(1.0, 3));
    world.add(geometry::icosphere(1.0, 3));
    world.add(geometry::icosphere(1.0, 3), {.cells = 100});
    world.add(geometry::icosphere(1.1, 3));
    world.step();
    const auto mesh = [&](std::size_t i) { return world.frame.surfaces[i].mesh; };
    EXPECT_EQ(mesh(0), mesh(1));
    EXPECT_NE(mesh(0), mesh(2));
    EXPECT_NE(mesh(0), mesh(3));
    EXPECT_NE(world.frame.surfaces[0].chains, world.frame.surfaces[1].chains);
}

TEST(SelectShadeTest, OutOfViewStrokesWait) {
    ShadeWorld world;
    world.add(geometry::icosphere(1.0, 3));
    world.step();
    const std::vector<DrawItem> items = world.list.items;
    const std::size_t segments = world.frame.surfaces[0].chains->segments.live();
    world.list.items.clear();
    world.step();
    EXPECT_TRUE(world.frame.surfaces.empty());
    EXPECT_EQ(world.layer.rect().width, 0);
    world.list.items = items;
    world.step();
    EXPECT_EQ(world.counts.triangles_touched, 0u);
    EXPECT_EQ(world.frame.surfaces[0].chains->segments.live(), segments);
}

TEST(SelectShadeTest, StrokesGoWithTheComponent) {
    ShadeWorld world, fresh;
    const Entity entity = world.add(geometry::icosphere(1.0, 3));
    world.place_sun(0);
    world.step();
    world.world.remove<ShadeStrokes>(entity);
    world.place_sun(50);
    world.step({entity});
    EXPECT_TRUE(world.frame.surfaces.empty());
    world.world.add(entity, ShadeStrokes{.cells = 300});
    world.step();
    fresh.add(geometry::icosphere(1.0, 3));
    fresh.place_sun(50);
    fresh.step();
    EXPECT_TRUE(same_strokes(world.frame, fresh.frame));
}

/// A shape that is deformed by a turn needs the shade of one that stands turned.
TEST(SelectShadeTest, LightFollowsTheDeformedShape) {
    ShadeWorld deformed, turned;
    deformed.add(geometry::torus(1.0, 0.4, 32, 16));
    turned.add(geometry::torus(1.0, 0.4, 32, 16));
    deformed.step();
    turned.step();
    const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), 0.8f, glm::normalize(glm::vec3(1, 2, 0)));
    turned.list.items[0].world_from_entity = turn;
    const SurfaceMesh& mesh = deformed.store.mesh(0);
    std::vector<glm::vec3> positions, normals;
    for (const glm::vec3& p : mesh.positions) positions.emplace_back(turn * glm::vec4(p, 1.0f));
    for (const glm::vec3& n : mesh.normals) normals.emplace_back(turn * glm::vec4(n, 0.0f));
    deformed.list.items[0].shape = {.positions = positions, .normals = normals, .tangents = {}, .version = 1};
    deformed.step();
    turned.step();
    const std::vector<float> a = deformed.needed(), b = turned.needed();
    for (std::size_t c = 0; c < a.size(); ++c) EXPECT_NEAR(a[c], b[c], 1e-4f);
    EXPECT_GT(deformed.counts.triangles_touched, 0u);
    deformed.step();
    EXPECT_EQ(deformed.counts.triangles_swept, 0u);
    deformed.list.items[0].shape.version = 2;
    deformed.step();
    EXPECT_GT(deformed.counts.triangles_swept, 0u);
}

TEST(SelectShadeTest, AmplitudesFollowCurvatureWhereItIsAskedForAndThere) {
    ShadeWorld world;
    const geometry::Shape ball = geometry::icosphere(1.0, 3);
    const Entity entity = world.add(ball, {.amplitude_by_curvature = 1.0f, .min_amplitude = 0.001f, .cells = 300});
    DrawItem& item = world.list.items[0];
    item.shape = {.positions = ball.positions, .normals = ball.normals, .tangents = {}, .version = 5};
    const auto narrowing = [&] {
        world.step();
        return world.frame.surfaces[0].narrowing;
    };
    const std::vector<glm::vec2> curvatures(ball.positions.size(), glm::vec2(2.0f)); // of half the radius
    world.world.add(entity, PrincipalCurvatures{.curvatures = curvatures, .version = 5});
    EXPECT_TRUE(narrowing().empty()) << "nobody asks";
    world.world.add(entity, Curvature{});
    ASSERT_EQ(narrowing().size(), ball.positions.size());
    for (const float share : narrowing()) EXPECT_NEAR(share, 0.5f, 0.02f);
    const std::uint64_t version = world.frame.surfaces[0].narrowing_version, key = world.frame.key;
    narrowing();
    EXPECT_EQ(world.frame.surfaces[0].narrowing_version, version) << "nothing moved";
    EXPECT_EQ(world.frame.key, key);
    world.world.add(entity, Curvature{.method = geometry::CurvatureMethod::quartic});
    narrowing();
    EXPECT_NE(world.frame.surfaces[0].narrowing_version, version);
    EXPECT_NE(world.frame.key, key);
    item.shape.version = 6;
    EXPECT_TRUE(narrowing().empty()) << "they are of another shape";
    item.shape = {};
    EXPECT_TRUE(narrowing().empty()) << "it does not deform";
}

TEST(SelectShadeTest, TheSameWithAnyNumberOfThreads) {
    const auto run = [](int threads) {
        const ThreadLimit limit(threads);
        auto world = std::make_unique<ShadeWorld>();
        for (int i = 0; i < 5; ++i) world->add(geometry::torus(1.0, 0.2 + 0.1 * i, 32, 16));
        for (int i = 0; i < 12; ++i) {
            world->place_sun(9 * i);
            world->step();
        }
        return world;
    };
    EXPECT_TRUE(same_strokes(run(1)->frame, run(4)->frame));
}

TEST(SelectShadeTest, VolumesTakeShadeAway) {
    ShadeWorld world;
    world.add(geometry::icosphere(1.0, 4), {.cells = 600, .density_by = ShadeDensityBy::volumes});
    world.step();
    const std::vector<float> all = world.needed();
    const auto place = [](float x) { return WorldTransform{glm::translate(glm::mat4(1.0f), {x, 0, 0})}; };
    const Entity volume = world.world.create_with(
        ShadeVolume{.shape = ShadeVolumeShape::box, .inside = 0.0f, .falloff = 0.0f}, place(-1.0f));
    world.step();
    const ShadeMesh& mesh = *world.frame.surfaces[0].mesh;
    int inside = 0, outside = 0;
    for (std::size_t c = 0; c < all.size(); ++c) {
        if (mesh.normal[c].x < -0.1f) {
            EXPECT_EQ(world.needed()[c], 0.0f);
            EXPECT_EQ(world.frame.surfaces[0].chains->cells[c].first, no_slot);
            inside += all[c] > 0.5f ? 1 : 0;
        } else if (mesh.normal[c].x > 0.1f) {
            EXPECT_EQ(world.needed()[c], all[c]);
            outside += all[c] > 0.5f ? 1 : 0;
        }
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(outside, 20);
    world.step();
    EXPECT_EQ(world.counts.triangles_swept, 0u);
    world.world.get_mutable<WorldTransform>(volume) = place(-5.0f);
    world.step();
    EXPECT_EQ(world.needed(), all);
    world.world.get_mutable<WorldTransform>(volume).matrix = glm::mat4(0.0f); // flattened: nothing
    world.step();
    EXPECT_EQ(world.needed(), all);
}

TEST(SelectShadeTest, ALightThatIsNoNumberShedsNone) {
    ShadeWorld world, dark;
    world.add(geometry::icosphere(1.0, 3));
    dark.add(geometry::icosphere(1.0, 3));
    dark.lights.lights.clear();
    world.lights.lights[0].position.x = std::numeric_limits<float>::quiet_NaN();
    testing::internal::CaptureStderr();
    world.step();
    world.step();
    const std::string said = testing::internal::GetCapturedStderr();
    dark.step();
    EXPECT_EQ(world.needed(), dark.needed());
    EXPECT_NE(said.find("no number"), std::string::npos);
    EXPECT_EQ(said.find("no number"), said.rfind("no number")) << "it is said once";
}

TEST(SelectShadeTest, WhatIsWrongWithAMeshIsSaidOnce) {
    ShadeWorld world;
    geometry::Shape open = geometry::icosphere(1.0, 3);
    open.indices.resize(open.indices.size() - 3);
    world.add(open);
    world.add(open, {.cells = 100});
    testing::internal::CaptureStderr();
    world.step();
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("'shape'"), std::string::npos) << said;
    EXPECT_NE(said.find("3 border edges"), std::string::npos) << said;
    EXPECT_EQ(said.find("border"), said.rfind("border")) << said;
}

TEST(SelectShadeTest, MeshesWithoutTrianglesAndStylesWithoutInkHaveNoStrokes) {
    ShadeWorld world;
    world.add({});
    world.add(geometry::icosphere(1.0, 2), {.cells = 100, .opacity = 0.0f});
    world.add({{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {}, {}, {0, 1, 2}}); // a triangle that is a point
    world.step();
    for (const ShadeSurface& surface : world.frame.surfaces) EXPECT_EQ(surface.chains->segments.live(), 0u);
    EXPECT_LE(world.frame.surfaces.size(), 1u);
}

} // namespace
} // namespace hachure::test
