#include <hachure/runtime/geometry/edge_lengths.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/geometry/weld.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hachure::geometry {
namespace {

std::vector<float> relative_lengths(const Shape& shape, std::uint32_t rings, double share = 0.95) {
    const std::vector<std::uint32_t> weld = weld_positions(shape.positions);
    std::vector<float> result(shape.positions.size());
    EdgeLengthsJob job{.positions = shape.positions,
                       .indices = shape.indices,
                       .weld = weld,
                       .share = share,
                       .rings = rings,
                       .relative = result};
    job.validate();
    job.run();
    return result;
}

/// A strip of quads along X between y = 0 and 1, columns at `x`, each cut from its lower left to its upper right.
Shape strip(const std::vector<float>& x) {
    Shape shape;
    for (const float at : x) {
        shape.positions.push_back({at, 0.0f, 0.0f});
        shape.positions.push_back({at, 1.0f, 0.0f});
    }
    for (std::uint32_t i = 0; i + 1 < x.size(); ++i) {
        const std::uint32_t a = 2 * i, b = a + 2, c = a + 3, d = a + 1;
        shape.indices.insert(shape.indices.end(), {a, b, c, a, c, d});
    }
    return shape;
}

TEST(EdgeLengths, AreTheMeanOfWhatMeetsAtAVertex) {
    // Columns at 0, 1, 3: the lower middle vertex has edges of 1 and 2 along, 1 up, and the diagonal of the second
    // quad; the upper right one 1 down, 2 along, and that diagonal.
    const Shape shape = strip({0, 1, 3});
    const double diagonal = std::sqrt(5.0), lower_middle = (1 + 2 + 1 + diagonal) / 4, upper_right = (3 + diagonal) / 3;
    const std::vector<float> found = relative_lengths(shape, 0, 1.0);
    EXPECT_FLOAT_EQ(found[5], 1.0f); // the longest mean
    EXPECT_NEAR(found[2], lower_middle / upper_right, 1e-6);
}

TEST(EdgeLengths, OfAGridAreAllAlikeInside) {
    const std::uint32_t cells = 12;
    const Shape grid = plane(3.0, cells);
    const std::vector<float> found = relative_lengths(grid, 0);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const glm::vec3 p = grid.positions[i];
        const bool inside = std::abs(p.x) < 1.4f && std::abs(p.z) < 1.4f;
        EXPECT_NEAR(found[i], 1.0f, inside ? 1e-6 : 0.2) << i;
    }
}

/// Columns whose distances grow by one factor each: so do mean lengths, where the strip's height counts for little.
TEST(EdgeLengths, OfAGradedGridFollowIt) {
    const double factor = 1.1;
    std::vector<float> x{0.0f};
    for (int i = 0; i < 60; ++i) x.push_back(x.back() + static_cast<float>(100.0 * std::pow(factor, i)));
    const std::vector<float> found = relative_lengths(strip(x), 0, 1.0);
    for (std::size_t column = 5; column + 5 < x.size(); ++column)
        EXPECT_NEAR(found[2 * column + 2] / found[2 * column], factor, 2e-3) << column;
    // Smoothing takes no more than the curvature of the growth: (1 + (f - 1)^2 / (4 f))^rings.
    const std::vector<float> smooth = relative_lengths(strip(x), 2, 1.0);
    for (std::size_t column = 5; column + 6 < x.size(); ++column)
        EXPECT_NEAR(smooth[2 * column + 2] / smooth[2 * column], factor, 2e-3) << column;
}

/// Two halves of a surface, one four times as fine: nearly all vertices are in the fine one, yet the coarse is at 1.
TEST(EdgeLengths, AreRelativeToWhatIsLongOnMostOfTheSurface) {
    const auto halves = [](std::uint32_t fine_cells) {
        Shape coarse = plane(1.0, 10);
        const Shape fine = plane(1.0, fine_cells);
        const auto base = static_cast<std::uint32_t>(coarse.positions.size());
        for (const glm::vec3& p : fine.positions) coarse.positions.push_back(p + glm::vec3(5, 0, 0));
        for (const std::uint32_t i : fine.indices) coarse.indices.push_back(base + i);
        return coarse;
    };
    for (const std::uint32_t finer : {4u, 16u}) {
        const Shape shape = halves(10 * finer);
        const std::vector<float> found = relative_lengths(shape, 2, 0.8);
        EXPECT_NEAR(found[60], 1.0f, 1e-4) << finer; // the middle of the coarse half
        const std::size_t middle = 121 + (10 * finer + 1) * (10 * finer) / 2 + 5 * finer;
        EXPECT_NEAR(found[middle], 1.0f / static_cast<float>(finer), 1e-3) << finer;
    }
}

TEST(EdgeLengths, SmoothingKeepsAStepFromJumping) {
    std::vector<float> x{0.0f};
    for (int i = 0; i < 40; ++i) x.push_back(x.back() + 10.0f);
    for (int i = 0; i < 40; ++i) x.push_back(x.back() + 100.0f);
    const auto largest_step = [&](std::uint32_t rings) {
        const std::vector<float> found = relative_lengths(strip(x), rings, 1.0);
        float step = 0.0f;
        for (std::size_t i = 2; i < found.size(); i += 2) step = std::max(step, std::abs(found[i] - found[i - 2]));
        return step;
    };
    EXPECT_GT(largest_step(0), 0.4f);
    EXPECT_LT(largest_step(2), 0.75f * largest_step(0));
    EXPECT_LT(largest_step(8), largest_step(2));
}

TEST(EdgeLengths, SeamsAreNoBorders) {
    const Shape ball = icosphere(1.0, 4);
    Shape soup; // a vertex per corner
    for (const std::uint32_t i : ball.indices) {
        soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
        soup.positions.push_back(ball.positions[i]);
    }
    const std::vector<float> whole = relative_lengths(ball, 2), torn = relative_lengths(soup, 2);
    for (std::size_t i = 0; i < torn.size(); ++i) EXPECT_NEAR(torn[i], whole[ball.indices[i]], 1e-6) << i;
}

TEST(EdgeLengths, WhatHasNoEdgeOrAreaIsAtFullLength) {
    Shape shape;
    shape.positions = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {7, 7, 7}};
    shape.indices = {0, 1, 2}; // no area
    EXPECT_EQ(relative_lengths(shape, 2), std::vector<float>(4, 1.0f));
    EXPECT_TRUE(relative_lengths(Shape{}, 2).empty());
}

} // namespace
} // namespace hachure::geometry
