#include <hachure/runtime/ecs/schedule.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Gust {};
struct Hit {};

void nothing(LastRun) {}

TEST(ScheduleOrderTest, ASystemMovesBehindTheOneItComesAfter) {
    Schedule schedule;
    schedule.add(Stage::script, "a", nothing).after("c");
    schedule.add(Stage::script, "b", nothing);
    schedule.add(Stage::script, "c", nothing);
    schedule.add(Stage::script, "d", nothing);
    EXPECT_THAT(schedule.names(), ElementsAre("b", "c", "a", "d"));
}

TEST(ScheduleOrderTest, BeforeIsAfterSeenFromTheOtherSide) {
    Schedule schedule;
    schedule.add(Stage::script, "a", nothing);
    schedule.add(Stage::script, "b", nothing);
    schedule.add(Stage::script, "c", nothing).before("a");
    EXPECT_THAT(schedule.names(), ElementsAre("b", "c", "a"));
}

TEST(ScheduleOrderTest, ChainsHold) {
    Schedule schedule;
    schedule.add(Stage::script, "a", nothing).after("b").after("d");
    schedule.add(Stage::script, "b", nothing).after("c");
    schedule.add(Stage::script, "c", nothing);
    schedule.add(Stage::script, "d", nothing).before("c");
    EXPECT_THAT(schedule.names(), ElementsAre("d", "c", "b", "a"));
}

TEST(ScheduleOrderTest, NamesThatNeverComeMeanNothing) {
    Schedule schedule;
    schedule.add(Stage::script, "a", nothing).after("absent").before("missing");
    schedule.add(Stage::script, "b", nothing);
    EXPECT_THAT(schedule.names(), ElementsAre("a", "b"));
    schedule.add(Stage::script, "absent", nothing);
    EXPECT_THAT(schedule.names(), ElementsAre("b", "absent", "a")) << "and those that come late are heeded";
}

TEST(ScheduleOrderTest, OrderAcrossStagesAgreesWithThem) {
    Schedule schedule;
    schedule.add(Stage::render, "draw", nothing).after("move");
    schedule.add(Stage::script, "move", nothing).before("step");
    schedule.add(Stage::transform, "step", nothing);
    EXPECT_THAT(schedule.names(), ElementsAre("move", "step", "draw"));
}

TEST(ScheduleOrderTest, RandomOrdersAreKeptAndStable) {
    std::mt19937 random(7);
    for (int repeat = 0; repeat < 200; ++repeat) {
        const std::size_t count = 2 + random() % 12;
        std::vector<std::size_t> rank(count); // what explicit order agrees with
        for (std::size_t i = 0; i < count; ++i) rank[i] = i;
        std::ranges::shuffle(rank, random);
        std::vector<std::vector<bool>> before(count, std::vector<bool>(count));
        Schedule schedule;
        for (std::size_t i = 0; i < count; ++i) {
            auto handle = schedule.add(Stage::script, std::to_string(i), nothing);
            for (std::size_t other = 0; other < count; ++other) {
                if (random() % 6 != 0 || rank[other] == rank[i]) continue;
                if (rank[other] < rank[i])
                    handle.after(std::to_string(other));
                else
                    handle.before(std::to_string(other));
                (rank[other] < rank[i] ? before[other][i] : before[i][other]) = true;
            }
        }
        std::vector<std::size_t> left(count), expected;
        for (std::size_t i = 0; i < count; ++i) left[i] = i;
        while (!left.empty()) {
            const auto ready = std::ranges::find_if(left, [&](std::size_t candidate) {
                return std::ranges::none_of(left, [&](std::size_t other) { return before[other][candidate]; });
            });
            expected.push_back(*ready);
            left.erase(ready);
        }
        std::vector<std::string> names;
        for (const std::size_t system : expected) names.push_back(std::to_string(system));
        ASSERT_EQ(schedule.names(), std::vector<std::string_view>(names.begin(), names.end()));
    }
}

TEST(ScheduleOrderDeathTest, CyclesAreNamed) {
    Schedule schedule;
    schedule.add(Stage::script, "x", nothing);
    schedule.add(Stage::script, "a", nothing).before("b");
    schedule.add(Stage::script, "b", nothing).before("c");
    schedule.add(Stage::script, "c", nothing).before("a");
    schedule.add(Stage::render, "y", nothing);
    EXPECT_DEATH(schedule.names(), "no cycle: 'a' -> 'b' -> 'c' -> 'a'");
    Schedule alone;
    alone.add(Stage::script, "self", nothing).after("self");
    World world;
    EXPECT_DEATH(alone.run(world), "'self' -> 'self'");
}

TEST(ScheduleOrderDeathTest, OrderAgainstTheStagesIsNamed) {
    Schedule schedule;
    schedule.add(Stage::script, "early", nothing);
    schedule.add(Stage::render, "late", nothing).before("early");
    EXPECT_DEATH(schedule.names(), "'late' cannot run before 'early'");
}

TEST(ScheduleOrderTest, ConflictsWithoutOrderAreAmbiguous) {
    Schedule schedule;
    schedule.add(Stage::script, "writer", [](Query<Speed>) {});
    schedule.add(Stage::script, "reader", [](Query<const Speed, const Position>) {});
    schedule.add(Stage::script, "other", [](Query<const Position>, Gust*) {});
    schedule.add(Stage::render, "later", [](Query<Speed>) {});
    schedule.add(Stage::script, "step", [](Query<Speed>) {}).fixed();
    const std::vector<Ambiguity> found = schedule.ambiguities();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].first, "writer");
    EXPECT_EQ(found[0].second, "reader");
    EXPECT_EQ(found[0].stage, Stage::script);
    EXPECT_THAT(found[0].on, ElementsAre(HasSubstr("Speed")));
}

TEST(ScheduleOrderTest, ChainsOfOrderSettleAmbiguities) {
    Schedule schedule;
    schedule.add(Stage::script, "first", [](Query<Speed>) {}).before("between");
    schedule.add(Stage::script, "last", [](Query<Speed>) {}).after("between");
    EXPECT_EQ(schedule.ambiguities().size(), 1u) << "what they name is not there";
    schedule.add(Stage::script, "between", [](LastRun) {});
    EXPECT_THAT(schedule.ambiguities(), IsEmpty());
}

TEST(ScheduleOrderTest, ConditionsRaceToo) {
    Schedule schedule;
    schedule.add(Stage::script, "writer", [](Gust&) {});
    schedule.add(Stage::script, "asks", nothing).run_if([](const Gust&) { return true; });
    EXPECT_EQ(schedule.ambiguities().size(), 1u);
}

TEST(ScheduleOrderTest, SaysWhatSystemsTouch) {
    Schedule schedule;
    schedule.add(Stage::render, "draw", [](World&) {});
    schedule.add(Stage::script, "steer", [](Query<const Position, Speed>, Commands&) {}).run_if([](const Gust&) {
        return true;
    });
    const std::vector<SystemInfo> systems = schedule.systems();
    ASSERT_EQ(systems.size(), 2u);
    EXPECT_EQ(systems[0].name, "steer");
    EXPECT_EQ(systems[0].stage, Stage::script);
    Access expected;
    expected.read_component<Position>();
    expected.write_component<Speed>();
    expected.read_resource<Gust>();
    const auto same = [](const Access::Item& a, const Access::Item& b) { return a.id == b.id && a.writes == b.writes; };
    EXPECT_TRUE(std::ranges::equal(systems[0].access.components, expected.components, same));
    EXPECT_TRUE(std::ranges::equal(systems[0].access.resources, expected.resources, same)) << "of the condition";
    EXPECT_TRUE(systems[0].access.commands);
    EXPECT_FALSE(systems[0].access.exclusive);
    EXPECT_EQ(systems[1].name, "draw");
    EXPECT_TRUE(systems[1].access.exclusive);
}

TEST(ScheduleOrderTest, NamesWhatSystemsRaceOn) {
    const auto on = [](auto first, auto second) {
        Schedule schedule;
        schedule.add(Stage::script, "first", first);
        schedule.add(Stage::script, "second", second);
        const std::vector<Ambiguity> found = schedule.ambiguities();
        return found.empty() ? std::string("nothing") : std::string(found[0].on.at(0));
    };
    EXPECT_EQ(on([](Commands&) {}, [](Commands&) {}), "Commands");
    EXPECT_EQ(on([](World&) {}, nothing), "World");
    EXPECT_THAT(on([](EventWriter<Hit>) {}, [](EventReader<Hit>) {}), HasSubstr("Hit"));
    EXPECT_THAT(on([](const World&) {}, [](Gust&) {}), HasSubstr("Gust"));
    EXPECT_EQ(on([](Query<const Speed>) {}, [](Query<const Speed>) {}), "nothing");
    EXPECT_EQ(on([](Query<Speed>) {}, [](Query<const Position, With<Speed>>, Removed<Speed>) {}), "nothing");
}

} // namespace
} // namespace hachure
