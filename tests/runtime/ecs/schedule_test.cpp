#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(ScheduleTest, RunsByStageThenByRegistration) {
    std::vector<std::string> ran;
    Schedule schedule;
    const auto add = [&](Stage stage, const char* name) {
        schedule.add(stage, name, [&ran, name](World&) { ran.emplace_back(name); });
    };
    add(Stage::render, "draw");
    add(Stage::input, "keys");
    add(Stage::light, "sun");
    add(Stage::render, "present");
    add(Stage::input, "mouse");
    World world;
    schedule.run(world);
    EXPECT_THAT(ran, ElementsAre("keys", "mouse", "sun", "draw", "present"));
    EXPECT_THAT(schedule.names(), ElementsAre("keys", "mouse", "sun", "draw", "present"));
}

TEST(ScheduleTest, AppliesCommandsAndAdvancesTheTickAfterEachSystem) {
    World world;
    Schedule schedule;
    Entity made;
    schedule.add(Stage::script, "make", [&](World& w) {
        made = w.commands().create();
        w.commands().add(made, Speed{4});
        EXPECT_EQ(w.tick(), 1u);
    });
    schedule.add(Stage::script, "use", [&](World& w) {
        EXPECT_EQ(w.tick(), 2u);
        EXPECT_EQ(w.query<const Speed>().changed_since<Speed>(0).first(), made);
        EXPECT_EQ(w.added_tick<Speed>(made), 1u);
    });
    schedule.run(world);
    EXPECT_EQ(world.tick(), 3u);
}

TEST(ScheduleTest, ASystemSeesTheChangesOfOthersOnceAndNotItsOwn) {
    World world;
    const Entity entity = world.create_with(Speed{});
    Schedule schedule;
    std::vector<std::size_t> seen;
    bool change = true;
    schedule.add(Stage::animate, "reader", [&, last = Tick{0}](World& w) mutable {
        seen.push_back(w.query<const Speed>().changed_since<Speed>(last).count());
        if (change) w.get_mutable<Speed>(entity).value = 2;
        last = w.tick();
    });
    schedule.add(Stage::render, "writer", [&](World& w) {
        if (change) w.get_mutable<Speed>(entity).value = 3;
    });
    schedule.run(world);
    schedule.run(world);
    change = false;
    schedule.run(world);
    schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(1, 1, 1, 0));
}

TEST(ScheduleTest, RemovalsLastUntilEverySystemSawThem) {
    World world;
    const Entity entity = world.create_with(Speed{});
    Schedule schedule;
    std::vector<std::size_t> seen;
    int runs = 0;
    schedule.add(Stage::input, "reader", [&, last = Tick{0}](World& w) mutable {
        seen.push_back(w.removed_since<Speed>(last).size());
        last = w.tick();
    });
    schedule.add(Stage::render, "remover", [&](World& w) {
        if (runs++ == 0) w.remove<Speed>(entity);
    });
    for (int i = 0; i < 4; ++i) schedule.run(world);
    EXPECT_THAT(seen, ElementsAre(0, 1, 0, 0));
    EXPECT_THAT(world.removed_since<Speed>(0), IsEmpty()) << "the memory of removals is bounded";
}

TEST(ScheduleTest, MeasuresEachSystem) {
    World world;
    Schedule schedule;
    schedule.add(Stage::render, "slow", [](World&) { std::this_thread::sleep_for(std::chrono::milliseconds(3)); });
    schedule.add(Stage::input, "fast", [](World&) {});
    ASSERT_EQ(schedule.times().size(), 2u);
    EXPECT_EQ(schedule.times()[1].ms, 0);
    schedule.run(world);
    EXPECT_EQ(schedule.times()[0].name, "fast");
    EXPECT_EQ(schedule.times()[0].stage, Stage::input);
    EXPECT_EQ(schedule.times()[1].name, "slow");
    EXPECT_GE(schedule.times()[1].ms, 3.0);
}

TEST(ScheduleTest, AnExceptionEndsTheRun) {
    World world;
    Schedule schedule;
    int later = 0;
    bool fail = true;
    schedule.add(Stage::input, "fails", [&](World&) {
        if (fail) throw std::runtime_error("failed");
    });
    schedule.add(Stage::render, "later", [&](World&) { ++later; });
    EXPECT_THROW(schedule.run(world), std::runtime_error);
    EXPECT_EQ(later, 0);
    fail = false;
    schedule.run(world);
    EXPECT_EQ(later, 1);
}

TEST(ScheduleTest, SpellsStages) {
    EXPECT_EQ(to_string(Stage::input), "input");
    EXPECT_EQ(to_string(Stage::transform), "transform");
    EXPECT_EQ(to_string(Stage::render), "render");
}

TEST(ScheduleDeathTest, NamesAreUnique) {
    Schedule schedule;
    schedule.add(Stage::input, "one", [](World&) {});
    EXPECT_DEATH(schedule.add(Stage::render, "one", [](World&) {}), "name is its own");
    EXPECT_DEATH(schedule.add(Stage::render, "two", std::function<void(World&)>{}), "can be called");
}

TEST(ScheduleDeathTest, DoesNotChangeWhileRunning) {
    World world;
    Schedule schedule;
    schedule.add(Stage::input, "adds", [&](World&) { schedule.add(Stage::input, "late", [](World&) {}); });
    EXPECT_DEATH(schedule.run(world), "between runs");
    Schedule nested;
    nested.add(Stage::input, "runs", [&](World& w) { nested.run(w); });
    EXPECT_DEATH(nested.run(world), "its own schedule");
}

} // namespace
} // namespace hachure
