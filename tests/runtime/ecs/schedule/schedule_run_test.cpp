#include <hachure/runtime/ecs/schedule.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/thread_limit.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

struct Wind {
    double speed = 0;
};

class ScheduleRunTest : public testing::TestWithParam<int> {
    ThreadLimit limit_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Threads, ScheduleRunTest, testing::Values(1, 4));

// What runs at the same time.

TEST(ScheduleParallelTest, SystemsWithoutConflictRunAtTheSameTime) {
    const ThreadLimit limit(4);
    World world;
    world.create_with(Speed{}, Position{});
    Schedule schedule;
    Meeting meeting(4);
    schedule.add(Stage::script, "write", [&](Query<Speed>) { EXPECT_TRUE(meeting.arrive()); });
    schedule.add(Stage::script, "read", [&](Query<const Position>) { EXPECT_TRUE(meeting.arrive()); });
    schedule.add(Stage::script, "too", [&](Query<const Position, With<Speed>>) { EXPECT_TRUE(meeting.arrive()); });
    schedule.add(Stage::script, "queue", [&](Commands&) { EXPECT_TRUE(meeting.arrive()); });
    schedule.run(world);
}

TEST(ScheduleParallelTest, ConflictingAndOrderedSystemsDoNot) {
    const ThreadLimit limit(4);
    World world;
    Schedule schedule;
    std::atomic<int> writers = 0, ordered = 0;
    const auto alone = [](std::atomic<int>& count) {
        EXPECT_EQ(++count, 1);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        --count;
    };
    for (int i = 0; i < 4; ++i)
        schedule.add(Stage::script, "writer" + std::to_string(i), [&](Query<Speed>) { alone(writers); });
    for (int i = 0; i < 4; ++i) {
        auto handle = schedule.add(Stage::script, "ordered" + std::to_string(i), [&](LastRun) { alone(ordered); });
        if (i > 0) handle.after("ordered" + std::to_string(i - 1));
    }
    for (int i = 0; i < 5; ++i) schedule.run(world);
}

TEST(ScheduleParallelTest, ExclusiveSystemsRunOnTheCallingThread) {
    const ThreadLimit limit(4);
    World world;
    Schedule schedule;
    const auto here = std::this_thread::get_id();
    for (int i = 0; i < 8; ++i) {
        schedule.add(Stage::script, "any" + std::to_string(i), [](LastRun) {});
        if (i % 3 == 0)
            schedule.add(Stage::script, "here" + std::to_string(i),
                         [here](World&) { EXPECT_EQ(std::this_thread::get_id(), here); });
    }
    for (int i = 0; i < 10; ++i) schedule.run(world);
}

// Conditions.

TEST_P(ScheduleRunTest, AllConditionsMustHold) {
    World world;
    world.set_resource(Wind{});
    Schedule schedule;
    bool switched_on = true;
    int runs = 0;
    schedule.add(Stage::script, "sail", [&](LastRun) { ++runs; })
        .run_if([](const Wind& wind) { return wind.speed > 0; })
        .run_if([&] { return switched_on; });
    schedule.run(world);
    EXPECT_EQ(runs, 0);
    world.resource_mutable<Wind>().speed = 1;
    schedule.run(world);
    EXPECT_EQ(runs, 1);
    switched_on = false;
    schedule.run(world);
    EXPECT_EQ(runs, 1);
    EXPECT_EQ(schedule.times()[0].ms, 0.0) << "it has not run";
}

TEST_P(ScheduleRunTest, AnExclusiveSystemCanHaveAConditionOnComponents) {
    World world;
    Schedule schedule;
    int runs = 0;
    schedule.add(Stage::script, "rebuild", [&](World&) { ++runs; }).run_if([](Query<const Speed> speeds, LastRun last) {
        return !speeds.changed_since<const Speed>(last.tick).empty();
    });
    schedule.run(world);
    const Entity entity = world.create_with(Speed{});
    schedule.run(world);
    schedule.run(world);
    EXPECT_EQ(runs, 1);
    world.get_mutable<Speed>(entity).value = 2;
    schedule.run(world);
    EXPECT_EQ(runs, 2);
}

// Ticks.

TEST_P(ScheduleRunTest, ASystemSeesWhatOthersOfItsBatchChangedSinceItsLastRun) {
    World world;
    const Entity entity = world.create_with(Speed{});
    Schedule schedule;
    std::vector<std::string> seen;
    bool early = false, late = false;
    schedule.add(Stage::script, "early", [&](Query<Speed> speeds) {
        if (early) speeds.each([](Speed& speed) { ++speed.value; });
    });
    schedule.add(Stage::script, "reader", [&](Query<const Speed> speeds, LastRun last) {
        seen.push_back(std::to_string(speeds.changed_since<Speed>(last.tick).count()));
    });
    schedule.add(Stage::script, "late", [&](Query<Speed> speeds) {
        if (late) speeds.each([](Speed& speed) { ++speed.value; });
    });
    const auto run = [&](bool e, bool l) {
        early = e;
        late = l;
        schedule.run(world);
    };
    run(false, false);
    run(false, false);
    run(true, false);
    run(false, true);
    run(false, false);
    run(false, false);
    EXPECT_THAT(seen, ElementsAre("1", "0", "1", "0", "1", "0"));
    EXPECT_EQ(world.get<Speed>(entity).value, 3);
}

TEST_P(ScheduleRunTest, ASystemDoesNotSeeItsOwnChanges) {
    World world;
    world.create_with(Speed{});
    Schedule schedule;
    std::vector<std::size_t> seen;
    schedule.add(Stage::script, "before", [](LastRun) {});
    schedule.add(Stage::script, "writer", [&](Query<Speed> speeds, LastRun last) {
        seen.push_back(speeds.changed_since<Speed>(last.tick).count());
        speeds.each([](Speed& speed) { ++speed.value; });
    });
    schedule.add(Stage::script, "after", [](LastRun) {});
    for (int i = 0; i < 3; ++i) schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(1, 0, 0));
}

TEST_P(ScheduleRunTest, EverySystemHasItsOwnTick) {
    World world;
    Schedule schedule;
    std::vector<Tick> last(3);
    for (std::size_t i = 0; i < 3; ++i)
        schedule.add(Stage::script, std::to_string(i), [&last, i](LastRun run) { last[i] = run.tick; });
    schedule.run(world);
    EXPECT_THAT(last, ElementsAre(0, 0, 0));
    schedule.run(world);
    EXPECT_THAT(last, ElementsAre(1, 2, 3));
    EXPECT_EQ(world.tick(), 7u);
}

TEST_P(ScheduleRunTest, ASystemThatDidNotRunKeepsItsLastRun) {
    World world;
    const Entity entity = world.create_with(Speed{});
    Schedule schedule;
    bool run = true;
    std::vector<std::size_t> seen;
    schedule
        .add(Stage::script, "reader",
             [&](Query<const Speed> speeds, LastRun last) {
                 seen.push_back(speeds.changed_since<Speed>(last.tick).count());
             })
        .run_if([&] { return run; });
    schedule.run(world);
    run = false;
    world.get_mutable<Speed>(entity).value = 2;
    for (int i = 0; i < 3; ++i) schedule.run(world);
    run = true;
    schedule.run(world);
    schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(1, 1, 0));
}

TEST_P(ScheduleRunTest, RemovedComponentsAreSeenOnceByEachSystem) {
    World world;
    const Entity entity = world.create_with(Speed{});
    Schedule schedule;
    std::vector<std::vector<Entity>> early, late;
    const auto collect = [](auto& into) {
        return [&into](Removed<Speed> removed) { into.emplace_back(removed.begin(), removed.end()); };
    };
    schedule.add(Stage::script, "early", collect(early));
    schedule.add(Stage::script, "remove", [&, runs = 0](Commands& commands) mutable {
        if (runs++ == 0) commands.remove<Speed>(entity);
    });
    schedule.add(Stage::script, "late", collect(late));
    for (int i = 0; i < 3; ++i) schedule.run(world);
    EXPECT_THAT(early, ElementsAre(IsEmpty(), ElementsAre(entity), IsEmpty()));
    EXPECT_THAT(late, ElementsAre(IsEmpty(), ElementsAre(entity), IsEmpty())) << "commands wait for the batch's end";
}

// Commands.

TEST_P(ScheduleRunTest, CommandsAreAppliedAtTheEndOfTheBatchInATickOfTheirOwn) {
    World world;
    Schedule schedule;
    Entity made;
    std::vector<std::size_t> seen;
    schedule.add(Stage::script, "make", [&](Commands& commands) {
        if (made) return;
        made = commands.create();
        commands.add(made, Speed{2});
    });
    const auto count = [&](Query<const Speed> speeds, LastRun last) {
        seen.push_back(speeds.changed_since<Speed>(last.tick).count());
    };
    schedule.add(Stage::script, "beside", count);
    schedule.add(Stage::animate, "next stage", count);
    schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(0, 1));
    EXPECT_EQ(world.added_tick<Speed>(made), 3u) << "behind both systems of the stage";
    schedule.run(world);
    schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(0, 1, 1, 0, 0, 0)) << "each sees it once";
}

TEST_P(ScheduleRunTest, WhoComesAfterCommandsSeesThemApplied) {
    for (const bool ordered : {false, true}) {
        World world;
        Schedule schedule;
        std::size_t seen = 99;
        schedule.add(Stage::script, "make", [](Commands& commands) { commands.add(commands.create(), Speed{}); });
        auto handle = schedule.add(Stage::script, "use", [&](Query<const Speed> speeds) { seen = speeds.count(); });
        if (ordered) handle.after("make");
        schedule.run(world);
        EXPECT_EQ(seen, ordered ? 1u : 0u);
    }
}

TEST_P(ScheduleRunTest, QueuesAreAppliedInTheOrderOfTheSystems) {
    World world;
    const Entity entity = world.create();
    Schedule schedule;
    std::vector<Entity> made(4);
    for (std::size_t i = 0; i < made.size(); ++i)
        schedule.add(Stage::script, std::to_string(i), [&made, i, entity](Commands& commands) {
            made[i] = commands.create();
            commands.add(entity, Speed{static_cast<double>(i)});
        });
    schedule.run(world);
    EXPECT_EQ(world.get<Speed>(entity).value, 3);
    for (std::size_t i = 0; i < made.size(); ++i) EXPECT_EQ(made[i].index, i + 1) << "handles are taken in order";
}

TEST_P(ScheduleRunTest, TheWorldsOwnQueueIsAppliedFirstAndAfterExclusiveSystems) {
    World world;
    Schedule schedule;
    std::vector<std::size_t> seen;
    schedule.add(Stage::input, "count", [&](Query<const Speed> speeds) { seen.push_back(speeds.count()); });
    schedule.add(Stage::script, "exclusive", [](World& w, Commands& own) {
        own.add(own.create(), Speed{});
        w.commands().add(w.commands().create(), Speed{});
    });
    schedule.add(Stage::script, "then", [&](Query<const Speed> speeds) { seen.push_back(speeds.count()); });
    world.commands().add(world.commands().create(), Speed{});
    schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(1, 3));
}

// Exceptions.

TEST_P(ScheduleRunTest, TheFirstExceptionInOrderIsThrown) {
    World world;
    Schedule schedule;
    for (int i = 0; i < 6; ++i)
        schedule.add(Stage::script, std::to_string(i), [i](LastRun) {
            if (i >= 2) throw std::runtime_error(std::to_string(i));
        });
    for (int i = 0; i < 30; ++i) {
        try {
            schedule.run(world);
            FAIL() << "nothing thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "2");
        }
    }
}

TEST_P(ScheduleRunTest, AnExceptionDropsTheQueuesAndStartsNothingMore) {
    World world;
    Schedule schedule;
    bool fail = true;
    int dependent = 0, later = 0;
    schedule.add(Stage::script, "make", [](Commands& commands) { commands.add(commands.create(), Speed{}); });
    schedule.add(Stage::script, "fail", [&](Wind*) {
        if (fail) throw std::runtime_error("failed");
    });
    schedule.add(Stage::script, "dependent", [&](const Wind*) { ++dependent; });
    schedule.add(Stage::render, "later", [&](LastRun) { ++later; });
    EXPECT_THROW(schedule.run(world), std::runtime_error);
    EXPECT_EQ(world.size(), 0u);
    EXPECT_EQ(dependent, 0);
    EXPECT_EQ(later, 0);
    fail = false;
    schedule.run(world);
    EXPECT_EQ(world.size(), 1u);
    EXPECT_EQ(dependent, 1);
    EXPECT_EQ(later, 1);
}

TEST_P(ScheduleRunTest, WhatAFailedRunChangedIsSeenByTheNext) {
    World world;
    world.create_with(Speed{}, Position{});
    Schedule schedule;
    bool fail = false;
    std::vector<std::size_t> seen;
    schedule.add(Stage::script, "reader", [&](Query<const Position> positions, LastRun last) {
        seen.push_back(positions.changed_since<Position>(last.tick).count());
    });
    schedule.add(Stage::script, "writer", [&](Query<Position> positions) {
        if (!fail) return;
        positions.each([](Position& position) { ++position.x; });
        throw std::runtime_error("failed");
    });
    schedule.run(world);
    fail = true;
    EXPECT_THROW(schedule.run(world), std::runtime_error);
    fail = false;
    schedule.run(world);
    schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(1, 0, 1, 0));
}

TEST_P(ScheduleRunTest, AnExceptionOfAnExclusiveSystemDropsItsCommands) {
    World world;
    Schedule schedule;
    schedule.add(Stage::script, "fail", [](World& w, Commands& own) {
        own.create();
        w.commands().create();
        throw std::runtime_error("failed");
    });
    EXPECT_THROW(schedule.run(world), std::runtime_error);
    EXPECT_TRUE(world.commands().empty());
    EXPECT_EQ(world.size(), 0u);
}

TEST_P(ScheduleRunTest, AFailingQueueDropsTheRest) {
    World world;
    const Entity entity = world.create();
    Schedule schedule;
    schedule.add(Stage::script, "cycle", [=](Commands& commands) { commands.set_parent(entity, entity); });
    schedule.add(Stage::script, "make", [](Commands& commands) { commands.create(); });
    EXPECT_THROW(schedule.run(world), HierarchyCycle);
    EXPECT_EQ(world.size(), 1u);
}

TEST_P(ScheduleRunTest, SystemsCanBeAddedBetweenRuns) {
    World world;
    Schedule schedule;
    std::string ran;
    schedule.add(Stage::render, "b", [&](World&) { ran += "b"; });
    schedule.run(world);
    Schedule moved = std::move(schedule);
    moved.add(Stage::input, "a", [&](World&) { ran += "a"; });
    moved.run(world);
    EXPECT_EQ(ran, "bab");
    EXPECT_EQ(moved.times().size(), 2u);
}

} // namespace
} // namespace hachure
