#include <hachure/runtime/ecs/schedule.h>
#include <hachure/runtime/ecs/schedule/fixed_step.h>
#include <hachure/runtime/ecs/world.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace hachure {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(FixedStepTest, AnHourOfAwkwardFramesDoesNotDrift) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(0.0, 0.033);
    const double step = 1.0 / 60.0;
    detail::FixedStep fixed(step, 8);
    long double elapsed = 0;
    std::uint64_t steps = 0;
    while (elapsed < 3600.0L) {
        const double delta = jitter(random);
        elapsed += delta;
        steps += static_cast<std::uint64_t>(fixed.advance(delta));
        ASSERT_EQ(steps, static_cast<std::uint64_t>(std::floor(elapsed / static_cast<long double>(step))));
        ASSERT_NEAR(fixed.fraction(),
                    static_cast<double>(elapsed / static_cast<long double>(step) - static_cast<long double>(steps)),
                    1e-9);
        ASSERT_GE(fixed.fraction(), 0.0);
        ASSERT_LT(fixed.fraction(), 1.0);
    }
    EXPECT_EQ(fixed.dropped(), 0u);
    EXPECT_EQ(fixed.taken(), steps);
}

TEST(FixedStepTest, FramesOfOneStepTakeOneStepEach) {
    for (const double rate : {24.0, 30.0, 50.0, 59.94, 60.0, 90.0, 144.0}) {
        detail::FixedStep fixed(1.0 / rate, 8);
        for (int i = 0; i < 100000; ++i) ASSERT_EQ(fixed.advance(1.0 / rate), 1) << "frame " << i << " at " << rate;
    }
}

TEST(FixedStepTest, FramesOfAPartOfAStepTakeOneInSo) {
    detail::FixedStep fixed(1.0 / 60.0, 8);
    int steps = 0;
    for (int i = 0; i < 240 * 600; ++i) steps += fixed.advance(1.0 / 240.0);
    EXPECT_EQ(steps, 60 * 600);
}

TEST(FixedStepTest, WhatIsTooMuchIsDroppedAndCounted) {
    detail::FixedStep fixed(0.25, 3);
    EXPECT_EQ(fixed.advance(2.125), 3);
    EXPECT_EQ(fixed.dropped(), 5u);
    EXPECT_EQ(fixed.fraction(), 0.5) << "less than a step is never dropped";
    EXPECT_EQ(fixed.advance(0.125), 1);
    EXPECT_EQ(fixed.advance(0), 0);
    EXPECT_EQ(fixed.taken(), 4u);
}

TEST(FixedStepDeathTest, ChecksItsInput) {
    EXPECT_DEATH(detail::FixedStep(0, 1), "takes time");
    EXPECT_DEATH(detail::FixedStep(0.1, 0), "has room");
    detail::FixedStep fixed(0.1, 1);
    EXPECT_DEATH(fixed.advance(-0.1), "goes forward");
    EXPECT_DEATH(fixed.advance(std::nan("")), "goes forward");
    EXPECT_DEATH(fixed.advance(1e300), "counted");
}

TEST(ScheduleTimeTest, StepsRunBetweenInputAndTheOtherStages) {
    World world;
    Schedule schedule;
    schedule.set_fixed_step(0.5);
    std::string ran;
    const auto add = [&](Stage stage, const char* name) {
        return schedule.add(stage, name, [&ran, name](World&) { ran += name; });
    };
    add(Stage::render, "r");
    add(Stage::render, "R").fixed();
    add(Stage::script, "s");
    add(Stage::script, "S").fixed();
    add(Stage::input, "i");
    add(Stage::input, "I").fixed();
    schedule.run(world, 1.25);
    EXPECT_EQ(ran, "iISRISRsr");
    EXPECT_THAT(schedule.names(), ElementsAre("i", "I", "S", "R", "s", "r"));
    ran.clear();
    schedule.run(world);
    EXPECT_EQ(ran, "isr") << "no time has passed";
}

TEST(ScheduleTimeTest, TimeSaysWhatTimeItIs) {
    World world;
    Schedule schedule;
    schedule.set_fixed_step(0.5);
    std::vector<Time> input, fixed, frame;
    schedule.add(Stage::input, "input", [&](const Time& time) { input.push_back(time); });
    schedule.add(Stage::script, "fixed", [&](const Time& time) { fixed.push_back(time); }).fixed();
    schedule.add(Stage::script, "frame", [&](const Time& time) { frame.push_back(time); });
    schedule.run(world, 0.25);
    schedule.run(world, 1.0);
    ASSERT_EQ(frame.size(), 2u);
    EXPECT_THAT(frame[1].delta, DoubleEq(1.0));
    EXPECT_THAT(frame[1].elapsed, DoubleEq(1.25));
    EXPECT_EQ(frame[0].frame, 0u);
    EXPECT_EQ(frame[1].frame, 1u);
    EXPECT_THAT(frame[0].step_fraction, DoubleEq(0.5));
    EXPECT_THAT(frame[1].step_fraction, DoubleEq(0.5));
    EXPECT_EQ(input[1].elapsed, frame[1].elapsed);
    EXPECT_EQ(input[1].step_fraction, frame[1].step_fraction);
    ASSERT_EQ(fixed.size(), 2u);
    EXPECT_THAT(fixed[0].delta, DoubleEq(0.5));
    EXPECT_THAT(fixed[0].elapsed, DoubleEq(0.5));
    EXPECT_THAT(fixed[1].elapsed, DoubleEq(1.0));
    EXPECT_EQ(fixed[1].frame, 1u);
    EXPECT_EQ(fixed[1].step_fraction, 0.0);
    EXPECT_EQ(world.resource<Time>().elapsed, 1.25);
}

TEST(ScheduleTimeTest, AnHourOfFramesRunsAnHourOfSteps) {
    World world;
    Schedule schedule;
    std::uint64_t steps = 0;
    schedule.add(Stage::script, "step", [&](LastRun) { ++steps; }).fixed();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> jitter(0.001, 0.1);
    long double elapsed = 0;
    while (elapsed < 3600.0L) {
        const double delta = jitter(random);
        elapsed += delta;
        schedule.run(world, delta);
    }
    EXPECT_EQ(steps, static_cast<std::uint64_t>(std::floor(elapsed / static_cast<long double>(1.0 / 60.0))));
    EXPECT_EQ(schedule.dropped_steps(), 0u);
    EXPECT_NEAR(world.resource<Time>().elapsed, static_cast<double>(elapsed), 1e-9);
}

TEST(ScheduleTimeTest, ALongFrameDropsTimeVisibly) {
    World world;
    Schedule schedule;
    schedule.set_fixed_step(0.1, 4);
    int steps = 0;
    schedule.add(Stage::script, "step", [&](LastRun) { ++steps; }).fixed();
    schedule.run(world, 1.05);
    EXPECT_EQ(steps, 4);
    EXPECT_EQ(schedule.dropped_steps(), 6u);
    EXPECT_NEAR(world.resource<Time>().elapsed, 1.05, 1e-12) << "frames keep their time";
    schedule.set_fixed_step(0.25);
    EXPECT_EQ(schedule.dropped_steps(), 0u);
    schedule.run(world, 0.5);
    EXPECT_EQ(steps, 6);
    EXPECT_NEAR(world.resource<Time>().elapsed, 1.55, 1e-12);
}

TEST(ScheduleTimeTest, AStepThatDoesNotComeTakesNoTime) {
    World world;
    Schedule schedule;
    schedule.set_fixed_step(1.0);
    int steps = 0;
    schedule
        .add(Stage::script, "step",
             [&](LastRun) {
                 ++steps;
                 volatile double sink = 0;
                 for (int i = 0; i < 100000; ++i) sink = sink + 1;
             })
        .fixed();
    schedule.run(world, 1.0);
    EXPECT_GT(schedule.times()[0].ms, 0.0);
    schedule.run(world, 0.5);
    EXPECT_EQ(schedule.times()[0].ms, 0.0) << "no step, no time";
    EXPECT_EQ(steps, 1);
}

} // namespace
} // namespace hachure
