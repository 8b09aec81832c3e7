#include <hachure/runtime/geometry/creases.h>
#include <hachure/runtime/geometry/shapes.h>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace hachure::geometry {
namespace {

std::size_t creases_of(const Shape& shape, float degrees, float noise = 1.0f) {
    const EdgeTable table = build_edge_table(shape.positions, shape.indices);
    std::vector<glm::vec4> planes(shape.indices.size() / 3);
    face_planes(shape.positions, shape.indices, planes);
    const std::vector<std::uint8_t> creases =
        find_creases(shape.positions, table.edges, planes, glm::radians(degrees), noise);
    return static_cast<std::size_t>(std::ranges::count(creases, 1));
}

/// A square of `n` x `n` cells, flat but for one vertex that is pushed up.
Shape bumped_square(std::uint32_t n, float height) {
    Shape shape;
    for (std::uint32_t y = 0; y <= n; ++y)
        for (std::uint32_t x = 0; x <= n; ++x) {
            const bool peak = x == n / 2 && y == n / 2;
            shape.positions.emplace_back(static_cast<float>(x), peak ? height : 0.0f, static_cast<float>(y));
        }
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
            shape.indices.insert(shape.indices.end(), {a, c, b, b, c, d});
        }
    return shape;
}

/// Two rectangles that meet at a right angle along an edge of length `width`.
Shape folded_sheet(float width, float depth) {
    Shape shape;
    shape.positions = {{0, 0, 0}, {width, 0, 0}, {width, 0, depth}, {0, 0, depth}, {width, depth, 0}, {0, depth, 0}};
    shape.indices = {0, 3, 2, 0, 2, 1, 0, 1, 4, 0, 4, 5};
    return shape;
}

TEST(FindCreases, ACubeHasTwelve) {
    EXPECT_EQ(creases_of(cube(1.0), 80.0f), 12u);
    EXPECT_EQ(creases_of(cube(1.0), 100.0f), 0u);
}

TEST(FindCreases, TheRimsOfACylinderAreKept) { EXPECT_EQ(creases_of(cylinder(1.0, 2.0, 32), 60.0f), 64u); }

TEST(FindCreases, AFineSphereHasNone) { EXPECT_EQ(creases_of(icosphere(1.0, 4), 30.0f), 0u); }

TEST(FindCreases, ASingleSharpEdgeCountsWhenItIsLongForTheMesh) {
    EXPECT_EQ(creases_of(folded_sheet(2.0f, 1.0f), 60.0f), 1u);
    EXPECT_EQ(creases_of(folded_sheet(0.05f, 1.0f), 60.0f), 0u) << "shorter than 6 % of the diagonal";
}

TEST(FindCreases, ABumpOfOneVertexOnADenseSurfaceIsNoise) {
    // The fan around a peak: the 6 edges to it and the 6 around it, all sharper than 40 degrees, hang together.
    EXPECT_GE(creases_of(bumped_square(40, 3.0f), 40.0f), min_crease_edges);
    // Lower, only a few of them are that sharp.
    EXPECT_EQ(creases_of(bumped_square(40, 0.6f), 40.0f), 0u);
}

TEST(FindCreases, WithoutTheNoiseFilterTheAngleAloneDecides) {
    EXPECT_EQ(creases_of(folded_sheet(0.05f, 1.0f), 60.0f, 0.0f), 1u);
    EXPECT_EQ(creases_of(folded_sheet(0.05f, 1.0f), 95.0f, 0.0f), 0u);
    EXPECT_EQ(creases_of(folded_sheet(0.05f, 1.0f), 60.0f, 0.5f), 1u) << "half as strict";
    EXPECT_GT(creases_of(bumped_square(40, 3.0f), 60.0f, 0.0f), 4u);
}

} // namespace
} // namespace hachure::geometry
