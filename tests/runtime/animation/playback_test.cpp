#include <hachure/runtime/animation/playback.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace hachure::animation {
namespace {

struct Moment {
    Playback playback;
    double time, clip_time;
};

TEST(Playback, GivesClipTimes) {
    const double d = 2.0;
    const Moment moments[] = {
        {{d, 1, LoopMode::once}, -1, 0},          {{d, 1, LoopMode::once}, 1.5, 1.5},
        {{d, 1, LoopMode::once}, 2, 2},           {{d, 1, LoopMode::once}, 99, 2},
        {{d, 1, LoopMode::loop}, 1.5, 1.5},       {{d, 1, LoopMode::loop}, 2, 0},
        {{d, 1, LoopMode::loop}, 7.25, 1.25},     {{d, 0.5, LoopMode::loop}, 5, 0.5},
        {{d, 1, LoopMode::ping_pong}, 1.5, 1.5},  {{d, 1, LoopMode::ping_pong}, 2, 2},
        {{d, 1, LoopMode::ping_pong}, 2.5, 1.5},  {{d, 1, LoopMode::ping_pong}, 4, 0},
        {{d, 1, LoopMode::ping_pong}, 5, 1},      {{d, 1, LoopMode::once, 0.5}, 1, 1.5},
        {{d, 1, LoopMode::once, -1}, 0.5, 0},     {{d, 1, LoopMode::once, -1}, 1.5, 0.5},
        {{d, 1, LoopMode::loop, -0.5}, 0, 1.5},   {{d, 1, LoopMode::ping_pong, -0.5}, 0, 0.5},
        {{d, -1, LoopMode::once}, 0, 2},          {{d, -1, LoopMode::once}, 0.5, 1.5},
        {{d, -1, LoopMode::once}, 5, 0},          {{d, -1, LoopMode::loop}, 0.5, 1.5},
        {{d, -1, LoopMode::loop}, 2.5, 1.5},      {{d, -1, LoopMode::ping_pong}, 0.5, 1.5},
        {{d, -1, LoopMode::ping_pong}, 2.5, 0.5}, {{d, 0, LoopMode::loop, 0.75}, 100, 0.75},
        {{0, 1, LoopMode::loop}, 5, 0},           {{0, 1, LoopMode::ping_pong}, 5, 0},
        {{0, -3, LoopMode::once, 4}, 5, 0},
    };
    for (const Moment& m : moments)
        EXPECT_EQ(clip_time(m.playback, m.time), m.clip_time)
            << "mode " << static_cast<int>(m.playback.mode) << " speed " << m.playback.speed << " at " << m.time;
}

TEST(Playback, StaysInTheClipWhateverTheNumbers) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> exponent(-300.0, 307.0);
    const auto number = [&] { return (random() % 2 ? 1.0 : -1.0) * std::pow(10.0, exponent(random)); };
    for (int i = 0; i < 20000; ++i) {
        const Playback playback{std::abs(number()), number(), static_cast<LoopMode>(random() % 3), number()};
        const double time = std::abs(number());
        const double clip = clip_time(playback, time);
        ASSERT_TRUE(clip >= 0.0 && clip <= playback.duration);
        int stretches = 0;
        for (PassedIntervals passed(playback, -1.0, time); passed.next();) ++stretches;
        ASSERT_LE(stretches, PassedIntervals::most_cycles + 1);
    }
}

TEST(Playback, PingPongIsSymmetric) {
    const Playback playback{1.7, 1.3, LoopMode::ping_pong};
    const double turn = 1.7 / 1.3;
    for (double t = 0.0; t < turn; t += 0.01)
        EXPECT_NEAR(clip_time(playback, turn - t), clip_time(playback, turn + t), 1e-12) << t;
}

TEST(Playback, BackwardsIsTheMirrorImage) {
    for (const LoopMode mode : {LoopMode::once, LoopMode::loop, LoopMode::ping_pong})
        for (double t = 0.0; t < 10.0; t += 0.03) {
            const double forward = clip_time({1.5, 0.7, mode, 0.2}, t), backward = clip_time({1.5, -0.7, mode, 0.2}, t);
            EXPECT_NEAR(forward + backward, 1.5, 1e-12) << t;
        }
}

TEST(Playback, FinishesOnce) {
    EXPECT_FALSE(finished({2.0, 1.0, LoopMode::once}, 1.99));
    EXPECT_TRUE(finished({2.0, 1.0, LoopMode::once}, 2.0));
    EXPECT_TRUE(finished({2.0, -2.0, LoopMode::once}, 1.0));
    EXPECT_FALSE(finished({2.0, 0.0, LoopMode::once}, 1e9));
    EXPECT_FALSE(finished({2.0, 1.0, LoopMode::loop}, 1e9));
}

TEST(Playback, ChangesSpeedWithoutAJump) {
    const double d = 2.0;
    for (const LoopMode mode : {LoopMode::once, LoopMode::loop, LoopMode::ping_pong})
        for (const double before : {1.0, -0.5, 3.0})
            for (const double after : {0.25, -1.0, -4.0, 0.0})
                for (const double time : {0.3, 0.55, 1.4, 2.6}) {
                    const Playback first{d, before, mode, 0.1}, second = with_speed(first, time, after);
                    const double at = clip_time(first, time);
                    EXPECT_NEAR(clip_time(second, time), at, 1e-9);
                    if (finished(first, time)) continue;
                    // Faster or slower the same way, or turned round.
                    const double h = 1e-4;
                    const double slope = (clip_time(first, time + h) - at) / (h * before);
                    EXPECT_NEAR(clip_time(second, time + h), at + slope * h * after, 1e-9)
                        << static_cast<int>(mode) << " " << before << " to " << after << " at " << time;
                }
}

std::vector<ClipInterval> passed(const Playback& playback, double from, double to) {
    std::vector<ClipInterval> all;
    for (PassedIntervals stretches(playback, from, to); stretches.next();) all.push_back(stretches.interval());
    return all;
}

void expect_interval(const ClipInterval& got, double from, double to, bool includes_from) {
    EXPECT_EQ(got.from, from);
    EXPECT_EQ(got.to, to);
    EXPECT_EQ(got.includes_from, includes_from);
    EXPECT_TRUE(got.includes_to);
}

TEST(PassedIntervals, LoopPassesBothEndsWhereItWraps) {
    const auto all = passed({2.0, 1.0, LoopMode::loop}, 1.5, 4.5);
    ASSERT_EQ(all.size(), 3u);
    expect_interval(all[0], 1.5, 2.0, false);
    expect_interval(all[1], 0.0, 2.0, true);
    expect_interval(all[2], 0.0, 0.5, true);
}

TEST(PassedIntervals, PingPongTurnsOnce) {
    const auto all = passed({2.0, 1.0, LoopMode::ping_pong}, 1.5, 4.5);
    ASSERT_EQ(all.size(), 3u);
    expect_interval(all[0], 1.5, 2.0, false);
    expect_interval(all[1], 2.0, 0.0, false);
    expect_interval(all[2], 0.0, 0.5, false);
}

TEST(PassedIntervals, BackwardsGoesFromTheEnd) {
    const auto all = passed({2.0, -1.0, LoopMode::loop}, not_started, 2.5);
    ASSERT_EQ(all.size(), 2u);
    expect_interval(all[0], 2.0, 0.0, true);
    expect_interval(all[1], 2.0, 1.5, true);
}

TEST(PassedIntervals, OnceEndsAtItsEndAndWaitsForItsStart) {
    auto all = passed({2.0, 1.0, LoopMode::once}, 1.0, 50.0);
    ASSERT_EQ(all.size(), 1u);
    expect_interval(all[0], 1.0, 2.0, false);
    EXPECT_TRUE(passed({2.0, 1.0, LoopMode::once}, 50.0, 60.0).empty());
    const Playback delayed{2.0, 1.0, LoopMode::once, -1.0};
    EXPECT_TRUE(passed(delayed, not_started, 0.5).empty());
    all = passed(delayed, 0.5, 1.5);
    ASSERT_EQ(all.size(), 1u);
    expect_interval(all[0], 0.0, 0.5, true);
}

TEST(PassedIntervals, NothingPassesWithoutTime) {
    const Playback playback{2.0, 1.0, LoopMode::loop};
    EXPECT_TRUE(passed(playback, 1.0, 1.0).empty());
    EXPECT_TRUE(passed(playback, 1.0, 0.5).empty());
    EXPECT_TRUE(passed(playback, -3.0, -1.0).empty());
    EXPECT_TRUE(passed({2.0, 0.0, LoopMode::loop}, 1.0, 5.0).empty());
    EXPECT_TRUE(passed({0.0, 1.0, LoopMode::loop}, 1.0, 5.0).empty());
    const auto start = passed({2.0, 0.0, LoopMode::loop, 0.5}, not_started, 0.0);
    ASSERT_EQ(start.size(), 1u);
    expect_interval(start[0], 0.5, 0.5, true);
    EXPECT_TRUE(start[0].contains(0.5));
}

TEST(PassedIntervals, AGiantStepGivesItsLastCycles) {
    const auto all = passed({1.0, 1.0, LoopMode::loop}, 0.0, 1e6 + 0.5);
    EXPECT_EQ(all.size(), static_cast<std::size_t>(PassedIntervals::most_cycles) + 1);
    EXPECT_EQ(all.back().to, 0.5);
}

/// The stretches together are as long as the way, and each goes on where the one before stopped.
TEST(PassedIntervals, AddUpToTheWay) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> number(0.0, 3.0);
    for (int i = 0; i < 2000; ++i) {
        const Playback playback{0.1 + number(random), number(random) - 1.5, static_cast<LoopMode>(1 + random() % 2),
                                number(random)};
        const double from = 3.0 * number(random), to = from + number(random);
        double way = 0.0, at = clip_time(playback, from);
        for (const ClipInterval& stretch : passed(playback, from, to)) {
            way += std::abs(stretch.to - stretch.from);
            EXPECT_TRUE(playback.mode != LoopMode::ping_pong || stretch.from == at);
            at = stretch.to;
        }
        EXPECT_NEAR(way, (to - from) * std::abs(playback.speed), 1e-9);
        EXPECT_EQ(at, clip_time(playback, to));
    }
}

} // namespace
} // namespace hachure::animation
