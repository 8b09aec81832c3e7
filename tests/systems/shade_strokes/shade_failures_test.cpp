#include <gtest/gtest.h>

#include <limits>

#include "chain_checks.h"

namespace hachure::test {
namespace {

/// Shades a mesh in the dark, by a moving sun and in full light, and looks at everything.
void expect_shades(geometry::Shape shape, std::uint32_t cells, bool fully) {
    ShadeRig rig(std::move(shape), cells);
    rig.step({});
    expect_sound(rig.mesh(), rig.chains());
    if (fully) {
        EXPECT_GT(rig.chains().segments.live(), 0u);
        EXPECT_LE(rig.error().mean, 0.04);
        EXPECT_LE(rig.error().unmet, rig.mesh().cell_count() / 10);
    }
    for (int i = 0; i < 6; ++i) rig.step_sun(60.0 * i);
    expect_sound(rig.mesh(), rig.chains());
    EXPECT_TRUE(std::isfinite(rig.ink()));
}

TEST(ShadeFailuresTest, NoTriangles) { expect_shades({}, 100, false); }

TEST(ShadeFailuresTest, OneTriangle) {
    geometry::Shape shape;
    shape.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    shape.indices = {0, 1, 2};
    expect_shades(shape, 200, true);
}

TEST(ShadeFailuresTest, OnlyDegenerateTriangles) {
    geometry::Shape shape;
    shape.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    shape.indices = {0, 1, 2, 0, 0, 1, 1, 1, 1};
    expect_shades(shape, 100, false);
}

TEST(ShadeFailuresTest, DegenerateAndRepeatedTrianglesAmongOthers) {
    geometry::Shape shape = geometry::icosphere(1.0, 3);
    for (std::uint32_t i = 0; i < 60; ++i) shape.indices.push_back(shape.indices[i]);
    for (std::uint32_t i = 0; i < 20; ++i) shape.indices.insert(shape.indices.end(), {i, i, i + 1});
    expect_shades(shape, 500, true);
}

/// A row of triangles without an area across a plane: chains go through as if it were not there.
TEST(ShadeFailuresTest, SliversAreCrossed) {
    geometry::Shape shape;
    for (const float x : {-1.0f, 0.0f, 1.0f})
        for (int j = 0; j <= 4; ++j) shape.positions.emplace_back(x, 0.0f, 0.5f * static_cast<float>(j));
    // Vertices on the middle line once more, in between, so that one side has twice as many edges there.
    for (int j = 0; j < 4; ++j) shape.positions.emplace_back(0.0f, 0.0f, 0.5f * static_cast<float>(j) + 0.25f);
    for (std::uint32_t j = 0; j < 4; ++j) {
        const std::uint32_t a = j, b = j + 1, m = 5 + j, n = 6 + j, c = 10 + j, d = 11 + j, between = 15 + j;
        shape.indices.insert(shape.indices.end(), {a, b, n, a, n, m});                            // one side
        shape.indices.insert(shape.indices.end(), {m, n, between});                               // no area
        shape.indices.insert(shape.indices.end(), {m, between, c, between, n, d, between, d, c}); // the other
    }
    ShadeRig rig(shape, 300, {.trueness = 1.0f});
    rig.step({});
    expect_sound(rig.mesh(), rig.chains());
    std::size_t across = 0;
    for (const ShadeSegment& segment : rig.chains().segments.all())
        if (segment.cell != no_slot && rig.at(segment.from).x * rig.at(segment.to).x < -1e-8) ++across;
    // Strokes of a flat surface across the object's axis run along X: over the slivers.
    EXPECT_GT(across, 3u);
}

TEST(ShadeFailuresTest, OpenAndNonManifoldMeshes) {
    expect_shades(geometry::plane(1.0, 5), 300, true);
    geometry::Shape fins = geometry::plane(1.0, 4);
    const auto first = static_cast<std::uint32_t>(fins.positions.size());
    fins.normals.clear();
    for (int i = 0; i <= 4; ++i) fins.positions.emplace_back(-0.5f + 0.25f * static_cast<float>(i), 0.5f, 0.0f);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t a = 10 + i, b = 11 + i; // the middle row of the plane
        fins.indices.insert(fins.indices.end(), {a, b, first + i, b, first + i + 1, first + i});
    }
    expect_shades(fins, 300, true);
}

TEST(ShadeFailuresTest, ConeCubeAndBothSides) {
    expect_shades(geometry::cone(1.0, 2.0, 24), 500, true);
    expect_shades(geometry::cube(1.0), 500, true);
    geometry::Shape leaf = geometry::plane(1.0, 3); // modelled from both sides
    const std::size_t count = leaf.indices.size();
    for (std::size_t i = 0; i < count; i += 3)
        leaf.indices.insert(leaf.indices.end(), {leaf.indices[i], leaf.indices[i + 2], leaf.indices[i + 1]});
    leaf.normals.clear();
    expect_shades(leaf, 300, true);
}

/// Long thin triangles, as of cylinders without rings.
TEST(ShadeFailuresTest, LongTriangles) {
    expect_shades(geometry::cylinder(0.2, 2.0, 64), 800, true);
    expect_shades(geometry::cylinder(1.0, 0.01, 256), 800, false);
}

TEST(ShadeFailuresTest, TinyAndHugeModelsGetTheSameStrokes) {
    const auto segments = [](float scale) {
        geometry::Shape shape = geometry::irregular_torus(1.0, 0.4, 48, 24, 0.2, 5);
        for (glm::vec3& p : shape.positions) p *= scale;
        ShadeRig rig(std::move(shape), 800);
        rig.step_sun(0.0);
        return rig.chains().segments.live();
    };
    const std::size_t usual = segments(1.0f);
    EXPECT_EQ(segments(1024.0f), usual);
    EXPECT_EQ(segments(1.0f / 4096.0f), usual);
}

TEST(ShadeFailuresTest, TwoMillionTriangles) {
    ShadeRig rig(geometry::torus(1.0, 0.4, 1414, 708), 2000);
    ASSERT_GT(rig.shape().indices.size() / 3, 2000000u);
    for (int i = 0; i < 3; ++i) rig.step_sun(10.0 * i);
    EXPECT_LE(rig.error().mean, 0.04);
    EXPECT_LT(rig.error().unmet, rig.mesh().cell_count() / 50);
    EXPECT_GT(rig.chains().segments.live(), 1000u);
}

TEST(ShadeFailuresTest, PaintKeepsStrokesAway) {
    ShadeRig rig(geometry::icosphere(1.0, 4), 500);
    std::vector<float> paint(rig.mesh().cell_count(), 1.0f);
    for (std::size_t c = 0; c < paint.size(); c += 2) paint[c] = 0.0f;
    rig.light.paint = paint;
    rig.step({});
    for (const ShadeSegment& segment : rig.chains().segments.all())
        if (segment.cell != no_slot) {
            EXPECT_EQ(segment.cell % 2, 1u);
        }
    EXPECT_GT(rig.chains().segments.live(), 100u);
}

} // namespace
} // namespace hachure::test
