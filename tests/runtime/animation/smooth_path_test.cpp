#include <hachure/runtime/animation/smooth_path.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hachure::animation {
namespace {

using Points = std::vector<PathPoint>;

glm::dvec3 at(const SmoothPath& path, double time) {
    std::uint32_t cursor = 0;
    return place_on(path, time, cursor);
}

glm::dvec3 velocity(const SmoothPath& path, double time, double side) {
    const double h = 1e-6;
    return (at(path, time + side * h) - at(path, time)) / (side * h);
}

const Points crooked{{0, {0, 0, 0}}, {1, {1, 0, 0}}, {1.5, {1.1, 0.2, 0}}, {4, {8, 3, 1}}, {5, {8, 3, -2}}};

TEST(SmoothPath, GoesThroughItsPointsAtTheirTimes) {
    const SmoothPath path = make_path(crooked);
    for (const PathPoint& point : crooked)
        EXPECT_LT(glm::length(at(path, point.time) - point.place), 1e-12) << point.time;
    EXPECT_EQ(at(path, -1.0), crooked.front().place);
    EXPECT_EQ(at(path, 9.0), crooked.back().place);
}

TEST(SmoothPath, SpeedDoesNotJump) {
    const SmoothPath path = make_path(crooked);
    for (std::size_t i = 1; i + 1 < crooked.size(); ++i) {
        const double time = crooked[i].time;
        EXPECT_LT(glm::length(velocity(path, time, 1.0) - velocity(path, time, -1.0)), 1e-4) << time;
        EXPECT_GT(glm::length(velocity(path, time, 1.0)), 0.01) << "it does not stop";
    }
}

TEST(SmoothPath, StraightEvenPointsAreWalkedEvenly) {
    Points points;
    for (int i = 0; i < 6; ++i) points.push_back({2.0 * i, glm::dvec3(3.0 * i, -1.0 * i, 0.5)});
    const SmoothPath path = make_path(points);
    for (double t = 0.0; t <= 10.0; t += 0.1)
        EXPECT_LT(glm::length(at(path, t) - glm::dvec3(1.5 * t, -0.5 * t, 0.5)), 1e-12) << t;
}

/// The curve itself, by Barry and Goldman's pyramid: another way to the same centripetal spline.
glm::dvec3 barry_goldman(const Points& p, std::size_t k, double u) {
    double t[4] = {0.0};
    glm::dvec3 q[4];
    for (std::size_t i = 0; i < 4; ++i) {
        q[i] = p[k - 1 + i].place;
        if (i > 0) t[i] = t[i - 1] + std::sqrt(glm::length(q[i] - q[i - 1]));
    }
    const double x = t[1] + u * (t[2] - t[1]);
    const auto mix = [&](const glm::dvec3& a, const glm::dvec3& b, double from, double to) {
        return a * ((to - x) / (to - from)) + b * ((x - from) / (to - from));
    };
    const glm::dvec3 a1 = mix(q[0], q[1], t[0], t[1]), a2 = mix(q[1], q[2], t[1], t[2]),
                     a3 = mix(q[2], q[3], t[2], t[3]);
    return mix(mix(a1, a2, t[0], t[2]), mix(a2, a3, t[1], t[3]), t[1], t[2]);
}

TEST(SmoothPath, IsTheCentripetalSpline) {
    const SmoothPath path = make_path(crooked);
    for (std::size_t k = 1; k + 2 < crooked.size(); ++k)
        for (double u = 0.0; u <= 1.0; u += 0.05) {
            const glm::dvec3 wanted = barry_goldman(crooked, k, u);
            double nearest = 1e9; // whenever it gets there
            for (double s = 0.0; s <= 1.0; s += 0.0005) {
                const double time = crooked[k].time + s * (crooked[k + 1].time - crooked[k].time);
                nearest = std::min(nearest, glm::length(at(path, time) - wanted));
            }
            EXPECT_LT(nearest, 0.01) << k << " " << u;
        }
}

TEST(SmoothPath, NeverTurnsBackHoweverUnevenTheTimes) {
    Points points{{0, {0, 0, 0}}, {0.01, {1, 0, 0}}, {5, {2, 0, 0}}, {5.02, {12, 0, 0}}, {9, {13, 0, 0}}};
    const SmoothPath path = make_path(points);
    double x = 0.0;
    for (double t = 0.0; t <= 9.0; t += 0.005) {
        EXPECT_GE(at(path, t).x, x - 1e-9) << t;
        x = at(path, t).x;
    }
}

TEST(SmoothPath, StandsStillBetweenEqualPoints) {
    const SmoothPath path = make_path(Points{{0, {0, 0, 0}}, {1, {2, 1, 0}}, {3, {2, 1, 0}}, {4, {5, 0, 0}}});
    for (const double t : {1.0, 1.5, 2.9}) EXPECT_EQ(at(path, t), glm::dvec3(2, 1, 0)) << t;
    EXPECT_LT(glm::length(velocity(path, 1.0, -1.0)), 1e-3) << "it slows down first";
    EXPECT_TRUE(std::isfinite(at(path, 3.5).x));
}

TEST(SmoothPath, OnePointAndTwo) {
    EXPECT_EQ(at(make_path(Points{{3, {1, 2, 3}}}), 7.0), glm::dvec3(1, 2, 3));
    const SmoothPath two = make_path(Points{{0, {0, 0, 0}}, {2, {4, 0, 0}}});
    EXPECT_NEAR(at(two, 0.5).x, 1.0, 1e-12);
}

TEST(SmoothPath, TheCursorIsOnlyAHint) {
    const SmoothPath path = make_path(crooked);
    std::uint32_t cursor = 0;
    for (double t = 0.0; t < 6.0; t += 1.0 / 60.0) EXPECT_EQ(place_on(path, t, cursor), at(path, t)) << t;
}

} // namespace
} // namespace hachure::animation
