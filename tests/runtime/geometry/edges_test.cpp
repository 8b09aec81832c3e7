#include <hachure/runtime/geometry/edges.h>

#include <gtest/gtest.h>

#include <cstring>

#include "reference.h"

namespace hachure::geometry {
namespace {

std::size_t count(const EdgeTable& table, std::uint32_t flags) {
    return static_cast<std::size_t>(
        std::ranges::count_if(table.edges, [&](const Edge& e) { return (e.flags & flags) == flags; }));
}

/// Every edge must be where the reference has it, with its faces, direction and flags.
void expect_like_reference(const EdgeTable& table, std::span<const glm::vec3> p, std::span<const std::uint32_t> i) {
    const reference::Edges expected = reference::edges(p, i);
    ASSERT_EQ(table.edges.size(), expected.size());
    for (const Edge& edge : table.edges) {
        const auto at = expected.find(std::minmax(edge.v0, edge.v1));
        ASSERT_NE(at, expected.end());
        const auto& uses = at->second;
        EXPECT_EQ(edge.face0, uses[0].first);
        EXPECT_EQ(edge.v0 < edge.v1, uses[0].second) << "face0 must run from v0 to v1";
        EXPECT_EQ(edge.face1, uses.size() > 1 ? uses[1].first : no_face);
        EXPECT_EQ(edge.flags & edge_border, uses.size() == 1 ? edge_border : 0u);
        const bool mismatch = uses.size() == 2 && uses[0].second == uses[1].second;
        EXPECT_EQ(edge.flags & edge_orientation_mismatch, mismatch ? edge_orientation_mismatch : 0u);
    }
}

TEST(EdgeTable, NothingGivesNothing) { EXPECT_TRUE(build_edge_table({}, {}).edges.empty()); }

TEST(EdgeTable, IsLikeTheReferenceOnShapes) {
    for (const Shape& s : {cube(1.0), torus(2.0, 0.5, 20, 10), uv_sphere(1.0, 12, 8), cone(1.0, 2.0, 9), plane(1.0, 6)})
        expect_like_reference(build_edge_table(s.positions, s.indices), s.positions, s.indices);
}

TEST(EdgeTable, AHubWithManyEdgesIsLikeTheReference) { // beyond the size that insertion sort takes
    const Shape s = cylinder(1.0, 2.0, 500);
    expect_like_reference(build_edge_table(s.positions, s.indices), s.positions, s.indices);
}

TEST(EdgeTable, SeamsAndHardEdgesAreNoBorders) {
    const Shape s = cube(1.0);
    const EdgeTable table = build_edge_table(s.positions, s.indices);
    EXPECT_EQ(table.edges.size(), 18u);
    EXPECT_EQ(count(table, edge_border), 0u);
}

TEST(EdgeTable, TheRimOfAPlaneIsItsBorder) {
    const Shape s = plane(1.0, 5);
    EXPECT_EQ(count(build_edge_table(s.positions, s.indices), edge_border), 20u);
}

TEST(EdgeTable, ThreeTrianglesOnAnEdgeGiveTwoFlaggedEntries) {
    const std::vector<glm::vec3> p{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    const std::vector<std::uint32_t> i{0, 1, 2, 1, 0, 3, 0, 1, 4};
    const EdgeTable table = build_edge_table(p, i);
    ASSERT_EQ(count(table, edge_non_manifold), 2u);
    EXPECT_EQ(count(table, edge_border), 6u);
    for (const Edge& e : table.edges) {
        if (!(e.flags & edge_non_manifold)) continue;
        EXPECT_EQ(e.v0, 0u);
        EXPECT_EQ(e.v1, 1u);
        EXPECT_EQ(e.face0, 0u);
        EXPECT_EQ(e.flags & edge_orientation_mismatch, e.face1 == 2 ? edge_orientation_mismatch : 0u);
    }
}

TEST(EdgeTable, FacesThatDisagreeAreFlagged) {
    const std::vector<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const EdgeTable table = build_edge_table(p, std::vector<std::uint32_t>{0, 1, 2, 0, 3, 2});
    ASSERT_EQ(count(table, edge_orientation_mismatch), 1u);
    EXPECT_EQ(count(build_edge_table(p, std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}), edge_orientation_mismatch), 0u);
}

TEST(EdgeTable, DegenerateAndRepeatedTrianglesChangeNothing) {
    Shape s = icosphere(1.0, 1);
    const EdgeTable clean = build_edge_table(s.positions, s.indices);
    const auto i = s.indices;
    s.indices.insert(s.indices.end(), {i[0], i[1], i[1], i[0], i[0], i[0]}); // degenerate
    s.indices.insert(s.indices.end(), {i[4], i[5], i[3], i[6], i[7], i[8]}); // copies, one rotated
    s.positions.push_back(s.positions[i[0]]);                                // another vertex at the place of i[0]
    s.indices.insert(s.indices.end(), {static_cast<std::uint32_t>(s.positions.size() - 1), i[0], i[2]});
    const EdgeTable table = build_edge_table(s.positions, s.indices);
    EXPECT_EQ(table.dropped_degenerate, 3u);
    EXPECT_EQ(table.dropped_duplicate, 2u);
    ASSERT_EQ(table.edges.size(), clean.edges.size());
    EXPECT_EQ(std::memcmp(table.edges.data(), clean.edges.data(), clean.edges.size() * sizeof(Edge)), 0);
}

TEST(EdgeTable, ALeafModelledFromBothSidesHasABorderAndOneSheet) {
    const Shape s = plane(1.0, 3);
    std::vector<std::uint32_t> both = s.indices;
    for (std::size_t f = 0; f < s.indices.size() / 3; ++f)
        both.insert(both.end(), {s.indices[3 * f], s.indices[3 * f + 2], s.indices[3 * f + 1]});
    const EdgeTable table = build_edge_table(s.positions, both);
    expect_like_reference(table, s.positions, s.indices);
    EXPECT_EQ(table.dropped_duplicate, s.indices.size() / 3);
}

TEST(EdgeTable, AFinLeavesTheSurfaceBelowItWhole) {
    // Two triangles that share the edge 0-1, and a fin of two back to back above that edge.
    const std::vector<glm::vec3> p{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0.5f}};
    const std::vector<std::uint32_t> i{0, 1, 2, 1, 0, 3, 0, 1, 4, 1, 0, 4};
    const EdgeTable table = build_edge_table(p, i);
    ASSERT_EQ(count(table, edge_non_manifold), 1u);
    const auto base = std::ranges::find_if(table.edges, [](const Edge& e) { return e.v0 == 0 && e.v1 == 1; });
    ASSERT_NE(base, table.edges.end());
    EXPECT_EQ(base->face0, 0u);
    EXPECT_EQ(base->face1, 1u);
    EXPECT_EQ(count(table, edge_border), 6u); // four of the surface and two of the fin
}

/// A square of two triangles whose diagonal is split by a vertex on one side only, the gap closed by a sliver.
struct SplitSquare {
    std::vector<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5f, 0.5f, 0}};
    // 0: right below the diagonal 0-2; 1 and 2: above it, meeting at 4; 3: the sliver between.
    std::vector<std::uint32_t> i{0, 1, 2, 0, 4, 3, 4, 2, 3, 0, 2, 4};
};

TEST(EdgeTable, LooksThroughASliver) {
    const SplitSquare s;
    const EdgeTable table = build_edge_table(s.p, s.i);
    EXPECT_EQ(table.bridged_slivers, 1u);
    EXPECT_EQ(count(table, edge_border), 4u);
    EXPECT_EQ(count(table, edge_orientation_mismatch), 0u);
    EXPECT_EQ(table.edges.size(), 7u); // border 4, the two halves of the diagonal, and 3-4
    for (const Edge& e : table.edges) {
        EXPECT_NE(e.face0, 3u);
        EXPECT_NE(e.face1, 3u);
        EXPECT_LT(e.face0, e.face1);
        const auto [low, high] = std::minmax(e.v0, e.v1);
        if (high != 4 || low == 3) continue;
        EXPECT_EQ(e.face0, 0u); // the lower triangle, behind both halves
        EXPECT_EQ(e.face1, low == 0 ? 1u : 2u);
        EXPECT_TRUE(e.v0 == 2 || e.v1 == 0); // and runs from 2 to 0 along the diagonal
    }
}

TEST(EdgeTable, ASliverOnABorderLeavesItsShortEdgesThere) {
    SplitSquare s;
    s.i.erase(s.i.begin(), s.i.begin() + 3); // without the lower triangle
    const EdgeTable table = build_edge_table(s.p, s.i);
    EXPECT_EQ(table.bridged_slivers, 1u);
    EXPECT_EQ(table.edges.size(), 5u);
    EXPECT_EQ(count(table, edge_border), 4u);
}

TEST(EdgeTable, BridgingKeepsADisagreementInSight) {
    SplitSquare s;
    std::swap(s.i[1], s.i[2]); // the lower triangle turned over
    const EdgeTable table = build_edge_table(s.p, s.i);
    EXPECT_EQ(table.bridged_slivers, 1u);
    EXPECT_EQ(count(table, edge_orientation_mismatch), 2u);
}

TEST(FacePlanes, HoldTheirTrianglesAndFaceTheirFront) {
    const Shape s = irregular_torus(2.0, 0.5, 20, 10, 0.4, 3);
    std::vector<glm::vec4> planes(s.indices.size() / 3);
    face_planes(s.positions, s.indices, planes);
    for (std::size_t c = 0; c < s.indices.size(); ++c) {
        const glm::dvec4 plane(planes[c / 3]);
        const glm::dvec3 normal(plane), front = reference::area_normal(s.positions, s.indices, c / 3);
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-6);
        EXPECT_GT(glm::dot(normal, front), 0.0);
        EXPECT_NEAR(glm::dot(normal, glm::dvec3(s.positions[s.indices[c]])) + plane.w, 0.0, 1e-6);
    }
}

TEST(FacePlanes, AreZeroWithoutAnAreaAndExactWhenTiny) {
    const std::vector<glm::vec3> p{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {1e-20f, 0, 0}, {0, 1e-20f, 0}};
    std::vector<glm::vec4> planes(2);
    face_planes(p, std::vector<std::uint32_t>{0, 1, 2, 0, 3, 4}, planes);
    EXPECT_EQ(planes[0], glm::vec4(0.0f));
    EXPECT_EQ(planes[1], glm::vec4(0, 0, 1, 0));
}

} // namespace
} // namespace hachure::geometry
