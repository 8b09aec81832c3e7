#include <hachure/runtime/geometry/triangulate.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <numbers>
#include <random>

#include "reference.h"

namespace hachure::geometry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::uint32_t> cut(std::span<const glm::vec3> polygon) {
    std::vector<std::uint32_t> triangles;
    EXPECT_TRUE(triangulate_polygon(polygon, triangles));
    return triangles;
}

/// A polygon of the plane z = 0 in any plane of space.
std::vector<glm::vec3> turned(std::vector<glm::vec3> polygon) {
    const glm::vec3 u = glm::normalize(glm::vec3(1, 2, -0.5f)),
                    v = glm::normalize(glm::cross(u, glm::vec3(0.3f, -1, 2)));
    for (glm::vec3& p : polygon) p = p.x * u + p.y * v + glm::vec3(4, 5, 6);
    return polygon;
}

/// The triangles must face like the polygon, and cover its area exactly once.
void expect_covers(const std::vector<glm::vec3>& polygon) {
    const std::vector<std::uint32_t> triangles = cut(polygon);
    ASSERT_EQ(triangles.size(), 3 * (polygon.size() - 2));
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < polygon.size(); ++i)
        normal += 0.5 * glm::cross(glm::dvec3(polygon[i]), glm::dvec3(polygon[(i + 1) % polygon.size()]));
    const double area = glm::length(normal);
    for (std::size_t f = 0; f < triangles.size() / 3; ++f)
        EXPECT_GE(glm::dot(reference::area_normal(polygon, triangles, f), normal), -1e-6 * area * area) << f;
    EXPECT_NEAR(reference::area(polygon, triangles), area, 1e-5 * area);
}

TEST(Triangulate, FewerThanThreeCornersGiveNothing) {
    EXPECT_THAT(cut(std::vector<glm::vec3>{}), IsEmpty());
    EXPECT_THAT(cut(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}}), IsEmpty());
}

TEST(Triangulate, AConvexPolygonIsAFan) {
    const std::vector<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}};
    EXPECT_THAT(cut(p), ElementsAre(0, 1, 2, 0, 2, 3, 0, 3, 4));
    expect_covers(turned(p));
}

TEST(Triangulate, AnArrowheadIsCutAtItsNotchFromEveryStart) {
    std::vector<glm::vec3> p{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5f, 1, 0}};
    for (int start = 0; start < 4; ++start) {
        expect_covers(p);
        expect_covers(turned(p));
        std::ranges::rotate(p, p.begin() + 1);
    }
    std::ranges::reverse(p);
    expect_covers(p);
}

TEST(Triangulate, CombsSpiralsAndStars) {
    std::vector<glm::vec3> comb{{0, 0, 0}};
    for (int i = 0; i < 40; ++i) {
        comb.emplace_back(40 - i, 0, 0);
        comb.emplace_back(39.5f - static_cast<float>(i), 10, 0);
    }
    std::ranges::reverse(comb);
    expect_covers(turned(comb));

    std::vector<glm::vec3> spiral;
    for (const double radius : {1.0, 1.3})
        for (int i = 0; i <= 100; ++i) {
            const int k = radius == 1.0 ? i : 100 - i;
            const double a = 0.12 * k, r = radius * (1.0 + 0.3 * a);
            spiral.emplace_back(r * std::cos(a), r * std::sin(a), 0.0);
        }
    expect_covers(turned(spiral));

    std::mt19937 random(3);
    std::uniform_real_distribution<float> radius(0.1f, 1.0f);
    for (const int corners : {5, 17, 100, 1000}) {
        std::vector<glm::vec3> star;
        for (int i = 0; i < corners; ++i) {
            const double a = 2.0 * std::numbers::pi * i / corners;
            const float r = radius(random);
            star.emplace_back(r * std::cos(a), r * std::sin(a), 0.0);
        }
        expect_covers(turned(star));
    }
}

TEST(Triangulate, AHoleJoinedByABridgeStaysOpen) {
    // A square with a square hole; the bridge runs along the same two corners both ways.
    const std::vector<glm::vec3> p{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                   {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    expect_covers(p);
}

TEST(Triangulate, CornersOnALineAreNoTrouble) {
    expect_covers({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}});
}

TEST(Triangulate, WhatIsNoPolygonStillGivesItsCount) {
    const std::vector<glm::vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    EXPECT_EQ(cut(line).size(), 9u);
    EXPECT_EQ(cut(std::vector<glm::vec3>(6, glm::vec3(1.0f))).size(), 12u);
    const std::vector<glm::vec3> bow{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0.5f, 0}};
    EXPECT_EQ(cut(bow).size(), 9u);
}

TEST(Triangulate, ALargeConcavePolygonIsBoundedInTime) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    std::vector<glm::vec3> tangle(max_concave_corners);
    for (glm::vec3& p : tangle) p = {any(random), any(random), 0.0f};
    std::vector<std::uint32_t> triangles;
    const auto start = std::chrono::steady_clock::now();
    triangulate_polygon(tangle, triangles); // crosses itself everywhere: no ears to be found
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
    EXPECT_EQ(triangles.size(), 3 * (tangle.size() - 2));

    tangle.emplace_back(0, 0, 0);
    triangles.clear();
    EXPECT_FALSE(triangulate_polygon(tangle, triangles));
    EXPECT_EQ(triangles.size(), 3 * (tangle.size() - 2));
}

} // namespace
} // namespace hachure::geometry
