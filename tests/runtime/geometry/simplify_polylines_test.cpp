#include <hachure/runtime/geometry/simplify_polylines.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hachure::geometry {
namespace {

void append(PolylineSet& set, const std::vector<LinePoint>& points, bool closed = false) {
    Polyline line{.first = static_cast<std::uint32_t>(set.points.size()),
                  .count = static_cast<std::uint32_t>(points.size())};
    line.closed = closed;
    line.owner = 7;
    line.start_joined = !closed;
    set.points.insert(set.points.end(), points.begin(), points.end());
    set.lines.push_back(line);
}

std::vector<LinePoint> circle(int count, float radius) {
    std::vector<LinePoint> points;
    for (int i = 0; i <= count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i % count) / count;
        points.push_back({{radius * std::cos(angle), radius * std::sin(angle)}, 4.0f, 1.0f});
    }
    return points;
}

PolylineSet simplified(const PolylineSet& set, float tolerance = 0.1f) {
    SimplifyPolylinesJob job{.lines = &set, .tolerance = tolerance};
    job.validate();
    job.run();
    return job.simplified;
}

float distance_to(const PolylineSet& set, const Polyline& line, glm::vec2 p) {
    float least = 1e9f;
    for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
        const glm::vec2 a = set.points[i - 1].place, step = set.points[i].place - a;
        const float t = glm::clamp(glm::dot(p - a, step) / glm::dot(step, step), 0.0f, 1.0f);
        least = std::min(least, glm::distance(p, a + t * step));
    }
    return least;
}

TEST(SimplifyPolylines, NoPointIsFartherThanTheToleranceAndMostGo) {
    for (const float tolerance : {0.02f, 0.1f, 0.5f}) {
        PolylineSet set;
        append(set, circle(400, 50.0f), true);
        const PolylineSet result = simplified(set, tolerance);
        ASSERT_EQ(result.lines.size(), 1u);
        EXPECT_TRUE(result.lines[0].closed);
        EXPECT_EQ(result.lines[0].owner, 7u);
        EXPECT_EQ(result.points.front().place, result.points.back().place);
        float most = 0.0f;
        for (const LinePoint& point : set.points)
            most = std::max(most, distance_to(result, result.lines[0], point.place));
        EXPECT_LE(most, tolerance * 1.0001f);
        EXPECT_LT(result.points.size(), 60.0f / std::sqrt(tolerance)); // a chord's height allows 22 / sqrt(tolerance)
        EXPECT_NEAR(result.lines[0].length, 100.0f * std::numbers::pi_v<float>, 2.0f);
    }
}

TEST(SimplifyPolylines, EndsStayAndStraightLinesAreTwoPoints) {
    PolylineSet set;
    std::vector<LinePoint> points;
    for (int i = 0; i <= 50; ++i)
        points.push_back({{0.9f * static_cast<float>(i), 0.4f * static_cast<float>(i)}, 3.0f, 0.5f});
    append(set, points);
    append(set, {{{1.0f, 2.0f}, 3.0f, 0.5f}, {{4.0f, 2.0f}, 3.0f, 0.5f}});
    const PolylineSet result = simplified(set);
    ASSERT_EQ(result.lines.size(), 2u);
    EXPECT_EQ(result.lines[0].count, 2u);
    EXPECT_EQ(result.points[0].place, points.front().place);
    EXPECT_EQ(result.points[1].place, points.back().place);
    EXPECT_TRUE(result.lines[0].start_joined);
    EXPECT_EQ(result.lines[1].first, 2u);
    EXPECT_FLOAT_EQ(result.lines[1].length, 3.0f);
}

TEST(SimplifyPolylines, WidthAndOpacityAreKept) {
    PolylineSet set;
    std::vector<LinePoint> points;
    const auto width = [](float x) { return 4.0f + 2.0f * std::sin(0.2f * x); };
    const auto opacity = [](float x) { return x < 30.0f ? 1.0f : std::max(0.0f, 1.0f - 0.1f * (x - 30.0f)); };
    for (int i = 0; i <= 60; ++i) {
        const auto x = static_cast<float>(i);
        points.push_back({{x, 0.0f}, width(x), opacity(x)});
    }
    append(set, points);
    const PolylineSet result = simplified(set);
    EXPECT_LT(result.points.size(), 40u);
    for (const LinePoint& point : points) {
        std::size_t i = 1;
        while (result.points[i].place.x < point.place.x) ++i;
        const LinePoint &a = result.points[i - 1], &b = result.points[i];
        const float t = (point.place.x - a.place.x) / (b.place.x - a.place.x);
        EXPECT_NEAR(glm::mix(a.width, b.width, t), point.width, 0.1001f);
        EXPECT_NEAR(glm::mix(a.opacity, b.opacity, t), point.opacity, 0.0201f);
    }
}

} // namespace
} // namespace hachure::geometry
