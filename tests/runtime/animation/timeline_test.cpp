// Tracks against formulas written out anew in double precision, and jumps against steps.

#include <hachure/runtime/animation/timeline.h>
#include <hachure/tests/runtime/animation/allocation_count.h>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

namespace hachure::animation {
namespace {

using Keys = std::vector<TrackKey>;

struct Sampler {
    TrackSet set;
    std::vector<std::uint32_t> cursors;
    std::vector<glm::dvec4> values;

    void add(TrackKind kind, const Keys& keys) {
        add_track(set, kind, keys);
        cursors.push_back(0);
        values.emplace_back();
    }
    const std::vector<glm::dvec4>& at(double time) {
        SampleTracksJob job{&set, time, cursors, values};
        job.validate();
        job.run();
        return values;
    }
};

double number_at(const Keys& keys, double time) {
    Sampler sampler;
    sampler.add(TrackKind::numbers, keys);
    return sampler.at(time)[0].x;
}

Keys numbers(std::initializer_list<std::pair<double, double>> list, KeyCurve curve) {
    Keys keys;
    for (const auto& [time, value] : list) keys.push_back({time, {value, -value, 2.0 * value, 0.0}, curve});
    return keys;
}

TEST(TimelineTracks, StepsHoldUntilTheNextKey) {
    const Keys keys = numbers({{1, 10}, {2, 20}, {3, 30}}, KeyCurve::step);
    EXPECT_EQ(number_at(keys, 0.0), 10.0) << "before the first key";
    EXPECT_EQ(number_at(keys, 1.999), 10.0);
    EXPECT_EQ(number_at(keys, 2.0), 20.0);
    EXPECT_EQ(number_at(keys, 99.0), 30.0) << "after the last key";
}

TEST(TimelineTracks, LinesAreStraightAndExactAtKeys) {
    const Keys keys = numbers({{0, 0.1}, {2, 0.7}, {5, -3}}, KeyCurve::linear);
    EXPECT_EQ(number_at(keys, 2.0), 0.7);
    EXPECT_EQ(number_at(keys, 5.0), -3.0);
    EXPECT_NEAR(number_at(keys, 0.5), 0.1 + 0.6 * 0.25, 1e-15);
    EXPECT_NEAR(number_at(keys, 4.0), 0.7 - 3.7 * 2.0 / 3.0, 1e-15);
}

TEST(TimelineTracks, EasingStartsAndEndsAtRest) {
    const auto at = [](KeyCurve curve, double time) { return number_at(numbers({{1, 10}, {3, 30}}, curve), time); };
    for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const double time = 1.0 + 2.0 * u;
        EXPECT_NEAR(at(KeyCurve::ease_in, time), 10.0 + 20.0 * u * u, 1e-12) << u;
        EXPECT_NEAR(at(KeyCurve::ease_out, time), 30.0 - 20.0 * (1.0 - u) * (1.0 - u), 1e-12) << u;
        EXPECT_NEAR(at(KeyCurve::ease_in_out, time), 10.0 + 20.0 * (3.0 * u * u - 2.0 * u * u * u), 1e-12) << u;
    }
    const double slope = (at(KeyCurve::ease_in, 1.0 + 1e-6) - 10.0) / 1e-6;
    EXPECT_NEAR(slope, 0.0, 1e-4);
}

TEST(TimelineTracks, EachKeySaysHowItGoesOn) {
    Keys keys = numbers({{0, 0}, {1, 1}, {2, 2}}, KeyCurve::linear);
    keys[0].curve = KeyCurve::step;
    EXPECT_EQ(number_at(keys, 0.5), 0.0);
    EXPECT_EQ(number_at(keys, 1.5), 1.5);
}

TEST(TimelineTracks, SplinesFollowTheirTangents) {
    // x(t) = t^3 - 2 t is a cubic, which a Hermite spline with its slopes gives exactly.
    const auto x = [](double t) { return t * t * t - 2.0 * t; };
    const auto slope = [](double t) { return 3.0 * t * t - 2.0; };
    Keys keys;
    for (const double t : {-1.0, 0.5, 0.75, 3.0})
        keys.push_back({t, glm::dvec4(x(t)), KeyCurve::cubic, glm::dvec4(slope(t)), glm::dvec4(slope(t))});
    for (double t = -1.0; t <= 3.0; t += 0.0625) EXPECT_NEAR(number_at(keys, t), x(t), 1e-12) << t;
}

TEST(TimelineTracks, TangentsNotGivenAreThoseOfCatmullAndRom) {
    const Keys keys = numbers({{0, 0}, {1, 1}, {2, 4}, {3, 9}}, KeyCurve::cubic);
    const auto slope = [&](double t) { return (number_at(keys, t + 1e-6) - number_at(keys, t - 1e-6)) / 2e-6; };
    EXPECT_NEAR(slope(1.0), 2.0, 1e-5) << "(4 - 0) / 2";
    EXPECT_NEAR(slope(2.0), 4.0, 1e-5) << "(9 - 1) / 2";
    EXPECT_NEAR(number_at(keys, 1.5), 2.25, 1e-12) << "a parabola is met exactly inside";
    Keys half = keys;
    half[1].out = glm::dvec4(0.0);
    EXPECT_NEAR((number_at(half, 1.0) - number_at(half, 1.0 - 1e-6)) / 1e-6, 2.0, 1e-5) << "the other side stays";
    EXPECT_NEAR((number_at(half, 1.0 + 1e-6) - number_at(half, 1.0)) / 1e-6, 0.0, 1e-5);
}

glm::dvec4 xyzw(const glm::dquat& q) { return {q.x, q.y, q.z, q.w}; }

TEST(TimelineTracks, RotationsTakeTheShortWayAtAnEvenSpeed) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -1));
    const auto turn = [&](double angle) { return xyzw(glm::angleAxis(angle, axis)); };
    Sampler sampler;
    // The second key is the negated quaternion, the third is 0.5 further on.
    sampler.add(TrackKind::rotation, {{0.0, turn(0.3)}, {2.0, -turn(1.7)}, {3.0, turn(2.2)}});
    for (double t = 0.0; t <= 3.0; t += 0.125) {
        const double angle = t < 2.0 ? 0.3 + 0.7 * t : 1.7 + 0.5 * (t - 2.0);
        EXPECT_NEAR(std::abs(glm::dot(sampler.at(t)[0], turn(angle))), 1.0, 1e-14) << t;
        EXPECT_NEAR(glm::length(sampler.values[0]), 1.0, 1e-14) << t;
    }
}

TEST(TimelineTracks, TinyAndCubicRotationsStayUnit) {
    const auto turn = [](double angle) { return xyzw(glm::angleAxis(angle, glm::dvec3(0, 1, 0))); };
    Sampler sampler;
    sampler.add(TrackKind::rotation, {{0.0, turn(1.0)}, {1.0, turn(1.0 + 1e-12)}});
    sampler.add(
        TrackKind::rotation,
        {{0.0, turn(0.0), KeyCurve::cubic}, {1.0, turn(0.4), KeyCurve::cubic}, {2.0, -turn(0.8), KeyCurve::cubic}});
    for (double t = 0.0; t <= 2.0; t += 0.1) {
        sampler.at(t);
        EXPECT_NEAR(glm::length(sampler.values[0]), 1.0, 1e-14);
        EXPECT_NEAR(glm::length(sampler.values[1]), 1.0, 1e-14);
        EXPECT_NEAR(std::abs(glm::dot(sampler.values[1], turn(0.4 * t))), 1.0, 1e-3) << t;
    }
}

/// Many tracks with keys at odd times.
Sampler random_tracks(std::size_t keys_each) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> step(0.01, 0.3), value(-5.0, 5.0);
    Sampler sampler;
    for (int track = 0; track < 40; ++track) {
        const auto curve = static_cast<KeyCurve>(track % 6);
        const bool turns = track % 7 == 0;
        Keys keys;
        double time = step(random);
        for (std::size_t k = 0; k < keys_each; ++k, time += step(random)) {
            glm::dvec4 v(value(random), value(random), value(random), value(random));
            keys.push_back({time, turns ? v / glm::length(v) : v, curve});
        }
        sampler.add(turns ? TrackKind::rotation : TrackKind::numbers, keys);
    }
    return sampler;
}

TEST(TimelineTracks, JumpsAndStepsGiveTheSameBits) {
    Sampler stepped = random_tracks(100);
    double time = 0.0;
    for (int frame = 0; frame < 900; ++frame, time += 1.0 / 60.0) {
        const std::vector<glm::dvec4> now = stepped.at(time);
        if (frame % 37 != 0) continue;
        Sampler jumped = random_tracks(100);
        jumped.at(frame % 2 == 0 ? 1e9 : 3.0); // from elsewhere
        EXPECT_EQ(std::memcmp(now.data(), jumped.at(time).data(), now.size() * sizeof(glm::dvec4)), 0) << frame;
    }
}

TEST(TimelineTracks, AllocateNothing) {
    Sampler sampler = random_tracks(20);
    const std::size_t before = test::allocation_count();
    for (double time = 0.0; time < 5.0; time += 0.1) sampler.at(time);
    EXPECT_EQ(test::allocation_count(), before);
}

TEST(TimelineTracksDeath, OnlyKeysInOrderAreTaken) {
    TrackSet set;
    EXPECT_DEATH(add_track(set, TrackKind::numbers, {}), "has a key");
    const Keys twice{{1.0, glm::dvec4(0)}, {1.0, glm::dvec4(1)}};
    EXPECT_DEATH(add_track(set, TrackKind::numbers, twice), "ascend");
    const Keys line{{1.0, glm::dvec4(0), KeyCurve::linear}};
    EXPECT_DEATH(add_track(set, TrackKind::choice, line), "steps");
}

} // namespace
} // namespace hachure::animation
