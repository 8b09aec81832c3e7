#include <hachure/runtime/animation/timeline_events.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace hachure::animation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<PassedEvent> passed(const std::vector<TimelineEvent>& events, const Playback& playback, double from,
                                double to) {
    std::vector<PassedEvent> result;
    PassedEventsJob job{events, playback, from, to, &result};
    job.validate();
    job.run();
    return result;
}

std::string names(const std::vector<TimelineEvent>& events, const Playback& playback, double from, double to) {
    std::string text;
    for (const PassedEvent& event : passed(events, playback, from, to)) text += events[event.event].name;
    return text;
}

const std::vector<TimelineEvent> steps{{0.0, "s"}, {0.5, "l"}, {1.5, "r"}, {1.5, "R"}, {2.0, "e"}};

TEST(SortEvents, SortsMovesAndLeavesOut) {
    std::vector<std::string> warnings;
    const auto sorted = sort_events({{5.0, "late"},
                                     {1.0, "b"},
                                     {-1.0, "early"},
                                     {1.0, "c"},
                                     {std::numeric_limits<double>::quiet_NaN(), "never"},
                                     {0.5, "a"}},
                                    2.0, warnings);
    std::string order;
    for (const TimelineEvent& event : sorted) order += event.name + " ";
    EXPECT_EQ(order, "early a b c late ");
    EXPECT_EQ(sorted.front().time, 0.0);
    EXPECT_EQ(sorted.back().time, 2.0);
    EXPECT_THAT(warnings, ElementsAre(HasSubstr("'never'"), HasSubstr("'late'"), HasSubstr("'early'")));
}

TEST(PassedEvents, HappenInOrder) {
    EXPECT_EQ(names(steps, {2.0, 1.0, LoopMode::once}, not_started, 0.0), "s");
    EXPECT_EQ(names(steps, {2.0, 1.0, LoopMode::once}, 0.0, 0.5), "l");
    EXPECT_EQ(names(steps, {2.0, 1.0, LoopMode::once}, 0.5, 9.0), "rRe");
    EXPECT_EQ(names(steps, {2.0, 1.0, LoopMode::once}, 9.0, 10.0), "");
    EXPECT_EQ(names(steps, {2.0, 1.0, LoopMode::loop}, not_started, 4.0), "slrReslrRes");
    EXPECT_EQ(names(steps, {2.0, 1.0, LoopMode::ping_pong}, not_started, 4.5), "slrReRrlsl");
    EXPECT_EQ(names(steps, {2.0, -1.0, LoopMode::once}, not_started, 5.0), "eRrls");
    EXPECT_EQ(names(steps, {2.0, -1.0, LoopMode::loop}, not_started, 2.5), "eRrlseRr");
    EXPECT_EQ(names(steps, {2.0, 1.0, LoopMode::loop, 1.0}, not_started, 0.5), "rR");
    EXPECT_EQ(names(steps, {2.0, 0.0, LoopMode::loop, 1.5}, not_started, 9.0), "rR");
    EXPECT_EQ(names({{0.0, "s"}}, {0.0, 1.0, LoopMode::loop}, not_started, 9.0), "s");
    EXPECT_THAT(passed({}, {2.0, 1.0, LoopMode::loop}, not_started, 9.0), IsEmpty());
}

TEST(PassedEvents, SayWhen) {
    const auto events = passed(steps, {2.0, 2.0, LoopMode::loop}, not_started, 1.25);
    ASSERT_EQ(events.size(), 7u);
    EXPECT_EQ(events[1], (PassedEvent{1, 0.25}));
    EXPECT_EQ(events[4], (PassedEvent{4, 1.0}));
    EXPECT_EQ(events[6], (PassedEvent{1, 1.25}));
    EXPECT_EQ(passed(steps, {2.0, -0.5, LoopMode::ping_pong}, 0.0, 1.0),
              (std::vector<PassedEvent>{{3, 1.0}, {2, 1.0}}));
}

/// However a time is divided, the same events happen in the same order, at times that differ by no more than rounding.
TEST(PassedEvents, HappenExactlyOnceOverAnySteps) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int round = 0; round < 3000; ++round) {
        const double duration = 0.1 + unit(random), end = 8.0 * unit(random);
        std::vector<TimelineEvent> events{{0.0, "start"}, {duration, "end"}};
        for (int i = 0; i < 6; ++i) events.push_back({duration * unit(random), "e"});
        std::vector<std::string> warnings;
        events = sort_events(events, duration, warnings);
        const Playback playback{duration, 4.0 * (unit(random) - 0.5), static_cast<LoopMode>(random() % 3),
                                2.0 * (unit(random) - 0.5)};
        const std::vector<PassedEvent> once = passed(events, playback, not_started, end);
        std::vector<PassedEvent> stepped;
        for (double from = not_started, to = 0.0;; from = to) {
            // Steps also end exactly on wraps and events.
            const double choice = unit(random);
            const double wrap =
                (std::round(unit(random) * 8.0) * duration - playback.offset) / std::abs(playback.speed);
            if (from >= 0.0) to = choice < 0.2 ? wrap : from + 0.3 * unit(random);
            to = std::min(std::max(to, from), end);
            for (const PassedEvent& event : passed(events, playback, from, to)) stepped.push_back(event);
            if (to >= end) break;
        }
        ASSERT_EQ(stepped.size(), once.size()) << "round " << round;
        for (std::size_t i = 0; i < once.size(); ++i) {
            ASSERT_EQ(stepped[i].event, once[i].event) << "round " << round;
            ASSERT_NEAR(stepped[i].time, once[i].time, 1e-12) << "round " << round; // a step's end bounds it
        }
    }
}

TEST(PassedEvents, HappenWhenTheirMomentIsShown) {
    // At 60 frames a second, the frame that shows the event's moment or the first one behind it.
    const std::vector<TimelineEvent> events{{0.25, "x"}};
    const Playback playback{1.0, 1.0, LoopMode::once};
    double before = not_started;
    for (int frame = 0; frame < 60; ++frame) {
        const double now = frame / 60.0;
        EXPECT_EQ(passed(events, playback, before, now).size(), frame == 15 ? 1u : 0u) << frame;
        before = now;
    }
}

} // namespace
} // namespace hachure::animation
