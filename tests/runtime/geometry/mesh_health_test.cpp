#include <hachure/runtime/geometry/mesh_health.h>

#include <gtest/gtest.h>

#include <numbers>

#include "reference.h"

namespace hachure::geometry {
namespace {

MeshHealth inspect(const Shape& s) { return geometry::inspect(s.positions, s.indices); }

void append(Shape& to, const Shape& from, const glm::vec3& offset) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    for (const glm::vec3& p : from.positions) to.positions.push_back(p + offset);
    for (const std::uint32_t i : from.indices) to.indices.push_back(first + i);
}

void turn_over(Shape& s, std::size_t face) { std::swap(s.indices[3 * face + 1], s.indices[3 * face + 2]); }

void remove(Shape& s, std::size_t face) {
    const auto at = s.indices.begin() + static_cast<std::ptrdiff_t>(3 * face);
    s.indices.erase(at, at + 3);
}

TEST(MeshHealth, NothingIsNotWatertight) {
    const MeshHealth health = inspect(Shape{});
    EXPECT_EQ(health.triangles, 0u);
    EXPECT_FALSE(health.watertight());
}

TEST(MeshHealth, CountsASphereWithSeams) {
    const MeshHealth health = inspect(uv_sphere(1.0, 16, 8));
    EXPECT_EQ(health.triangles, 16u * 7u * 2u);
    EXPECT_EQ(health.vertices, 16u * 7u + 2u);
    EXPECT_EQ(health.components, 1u);
    EXPECT_EQ(health.isolated_vertices, 0u);
    EXPECT_TRUE(health.watertight());
}

TEST(MeshHealth, CountsHolesNotOnlyTheirEdges) {
    Shape s = plane(1.0, 6);
    EXPECT_EQ(inspect(s).holes, 1u);
    EXPECT_EQ(inspect(s).boundary_edges, 24u);
    remove(s, 2 * (6 * 3 + 3)); // one triangle in the middle
    EXPECT_EQ(inspect(s).holes, 2u);
    EXPECT_EQ(inspect(s).boundary_edges, 27u);
}

TEST(MeshHealth, HolesThatTouchAtAVertexAreOne) {
    Shape s = plane(1.0, 6);
    // The triangles of two cells that meet at one corner, one of each: cell (2,2)'s and cell (3,3)'s.
    const std::uint32_t corner = 3 * 7 + 3;
    const auto uses = [&](std::size_t face) {
        return std::ranges::count(std::span(s.indices).subspan(3 * face, 3), corner) > 0;
    };
    const std::size_t below = 2 * (6 * 2 + 2), above = 2 * (6 * 3 + 3);
    ASSERT_TRUE(uses(below) && uses(above));
    remove(s, above);
    remove(s, below);
    const MeshHealth health = inspect(s);
    EXPECT_EQ(health.holes, 2u); // with the rim: the surface around the vertex is in two parts
    EXPECT_EQ(health.non_manifold_vertices, 1u);
}

TEST(MeshHealth, FindsAVertexBetweenTwoFans) {
    Shape s = icosphere(1.0, 0);
    append(s, icosphere(1.0, 0), 2.0f * s.positions[0]);
    // The second sphere's vertex opposite to 0 falls on vertex 0, up to rounding: make it exact.
    const auto touching =
        std::ranges::min_element(s.positions.begin() + 12, s.positions.end(), {},
                                 [&](const glm::vec3& p) { return glm::distance(p, s.positions[0]); });
    ASSERT_LT(glm::distance(*touching, s.positions[0]), 1e-5f);
    *touching = s.positions[0];
    const MeshHealth health = inspect(s);
    EXPECT_EQ(health.vertices, 23u);
    EXPECT_EQ(health.non_manifold_vertices, 1u);
    EXPECT_EQ(health.components, 1u);
    EXPECT_EQ(health.boundary_edges, 0u);
}

TEST(MeshHealth, CountsTrianglesThatAreOfNoUse) {
    Shape s = icosphere(1.0, 1);
    const auto i = s.indices;
    s.indices.insert(s.indices.end(), {i[0], i[1], i[0]});         // degenerate
    s.indices.insert(s.indices.end(), {i[1], i[2], i[0]});         // a copy
    s.indices.insert(s.indices.end(), {i[3], i[5], i[4]});         // a copy turned over
    s.positions.insert(s.positions.end(), {{3, 3, 3}, {3, 3, 3}}); // one place, unused
    const MeshHealth health = inspect(s);
    EXPECT_EQ(health.triangles, 83u);
    EXPECT_EQ(health.degenerate_triangles, 1u);
    EXPECT_EQ(health.duplicate_triangles, 1u);
    EXPECT_EQ(health.opposed_triangles, 1u);
    EXPECT_EQ(health.isolated_vertices, 1u);
    EXPECT_EQ(health.vertices, 43u);
    EXPECT_EQ(health.non_manifold_edges, 3u); // around the one turned over
}

TEST(MeshHealth, CountsSlivers) {
    const std::vector<glm::vec3> p{{0, 0, 0}, {2, 0, 0}, {1, 1e-7f, 0}, {1, 1e-3f, 0}};
    EXPECT_EQ(geometry::inspect(p, std::vector<std::uint32_t>{0, 1, 2}).sliver_triangles, 1u);
    EXPECT_EQ(geometry::inspect(p, std::vector<std::uint32_t>{0, 1, 3}).sliver_triangles, 0u);
}

TEST(MeshHealth, FindsTrianglesTurnedOver) {
    Shape s = torus(2.0, 0.5, 12, 8);
    turn_over(s, 5);
    turn_over(s, 90);
    const MeshHealth health = inspect(s);
    EXPECT_EQ(health.flipped_triangles, 2u);
    EXPECT_EQ(health.mismatched_edges, 6u);
    EXPECT_EQ(health.non_orientable_pieces, 0u);
    EXPECT_FALSE(health.watertight());
}

TEST(MeshHealth, FindsAPieceInsideOut) {
    Shape s = cube(1.0);
    Shape inverted = icosphere(0.5, 1);
    for (std::size_t f = 0; f < inverted.indices.size() / 3; ++f) turn_over(inverted, f);
    append(s, inverted, {5, 0, 0});
    const MeshHealth health = inspect(s);
    EXPECT_EQ(health.inside_out_pieces, 1u);
    EXPECT_EQ(health.components, 2u);
    EXPECT_EQ(health.flipped_triangles, 0u);
    EXPECT_FALSE(health.watertight());
}

TEST(MeshHealth, AMoebiusStripHasNoSides) {
    constexpr std::uint32_t sections = 40;
    for (const bool twisted : {false, true}) {
        Shape s;
        for (std::uint32_t i = 0; i < sections; ++i) {
            const double a = 2.0 * std::numbers::pi * i / sections, half = twisted ? a / 2.0 : 0.0;
            for (const double side : {-0.3, 0.3})
                s.positions.emplace_back(std::cos(a) * (1.0 + side * std::cos(half)), side * std::sin(half),
                                         std::sin(a) * (1.0 + side * std::cos(half)));
        }
        for (std::uint32_t i = 0; i < sections; ++i) {
            const bool closes = twisted && i + 1 == sections;
            const std::uint32_t a = 2 * i, b = a + 1, c = 2 * ((i + 1) % sections) + (closes ? 1 : 0), d = c ^ 1;
            s.indices.insert(s.indices.end(), {a, b, c, c, b, d});
        }
        const MeshHealth health = inspect(s);
        EXPECT_EQ(health.non_orientable_pieces, twisted ? 1u : 0u);
        EXPECT_EQ(health.mismatched_edges, twisted ? 1u : 0u);
        EXPECT_EQ(health.holes, twisted ? 1u : 2u); // the Moebius strip has one rim
    }
}

TEST(MeshHealth, ComponentsTouchOrDoNot) {
    Shape s = icosphere(1.0, 1);
    for (int i = 1; i < 7; ++i) append(s, icosphere(1.0, 1), {3.0f * static_cast<float>(i), 0, 0});
    EXPECT_EQ(inspect(s).components, 7u);
}

} // namespace
} // namespace hachure::geometry
