// Systems that create entities through commands while other systems walk queries: nothing that is walked moves.

#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/schedule.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>
#include <hachure/tests/runtime/ecs/thread_limit.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <tuple>
#include <vector>

namespace hachure {
namespace {

using namespace test;

constexpr std::size_t rounds = 5;
constexpr std::size_t made_per_round = 3000; ///< more than the slots that the world begins with

struct Counts {
    double positions = 0;
    std::size_t parents = 0;
};

class SchedulePromiseTest : public testing::TestWithParam<int> {
    ThreadLimit limit_{GetParam()};

protected:
    World world;
    std::vector<Entity> known;
    std::vector<Entity> made;
    Counts counts;
    Schedule schedule;

    SchedulePromiseTest() {
        known = world.create_many(500, Position{1, 0}, Heat{1});
        for (std::size_t i = 1; i < known.size(); i += 2) world.set_parent(known[i], known[i - 1]);
        for (std::size_t i = 0; i < 40; ++i) world.destroy(world.create()); // some slots are free
    }
};
INSTANTIATE_TEST_SUITE_P(Threads, SchedulePromiseTest, testing::Values(1, 4));

TEST_P(SchedulePromiseTest, HandlesArePromisedWhileOthersWalk) {
    schedule.add(Stage::script, "make", [&](Commands& commands) {
        for (std::size_t i = 0; i < made_per_round; ++i) {
            const Entity entity = commands.create();
            commands.add(entity, Speed{double(made.size())});
            made.push_back(entity);
        }
    });
    schedule.add(Stage::script, "walk", [&](Query<const Position> query) {
        for (int i = 0; i < 20; ++i)
            for (auto [entity, position] : query) counts.positions += position.x;
    });
    schedule.add(Stage::script, "look up", [&](Query<OfParent<const Position>, Heat> query) {
        for (const Entity entity : known)
            if (auto found = query.find(entity)) ++counts.parents;
        query.each([](const Position&, Heat& heat) { heat.value += 1; });
    });
    for (std::size_t round = 1; round <= rounds; ++round) {
        schedule.run(world);
        ASSERT_EQ(made.size(), round * made_per_round);
        ASSERT_EQ(world.size(), known.size() + made.size());
    }
    EXPECT_EQ(std::set<Entity>(made.begin(), made.end()).size(), made.size());
    for (std::size_t i = 0; i < made.size(); ++i) ASSERT_EQ(world.get<Speed>(made[i]).value, double(i));
    EXPECT_EQ(counts.positions, double(rounds * 20 * known.size()));
    EXPECT_EQ(counts.parents, rounds * known.size() / 2);
    for (std::size_t i = 0; i < known.size(); ++i)
        ASSERT_EQ(world.get<Heat>(known[i]).value, i % 2 ? 1 + double(rounds) : 1);
}

TEST_P(SchedulePromiseTest, SeveralQueuesAreGivenHandlesInTheSameOrder) {
    std::vector<Entity> others;
    schedule.add(Stage::script, "one", [&](Commands& commands) {
        for (int i = 0; i < 100; ++i) made.push_back(commands.create());
    });
    schedule.add(Stage::script, "other", [&](Commands& commands) {
        for (int i = 0; i < 100; ++i) others.push_back(commands.create());
        for (int i = 0; i < 100; i += 2) commands.destroy(others[others.size() - 1 - i]);
    });
    for (std::size_t round = 0; round < rounds; ++round) schedule.run(world);
    World again;
    const auto same = again.create_many(500, Position{});
    for (std::size_t i = 0; i < 40; ++i) again.destroy(again.create());
    for (std::size_t round = 0; round < rounds; ++round) {
        std::vector<Entity> expected;
        for (int i = 0; i < 200; ++i) expected.push_back(again.create());
        for (std::size_t i = 0; i < 100; ++i) {
            ASSERT_EQ(made[round * 100 + i], expected[i]);
            ASSERT_EQ(others[round * 100 + i], expected[100 + i]);
        }
        for (std::size_t i = 0; i < 100; i += 2) again.destroy(expected[199 - i]);
    }
    EXPECT_EQ(world.size(), again.size());
}

TEST(CommandsPromiseTest, AClearedQueueGivesItsPromisesBack) {
    World world;
    world.create();
    std::vector<Entity> promised;
    {
        Commands commands(world);
        for (const auto& item : world.query<>())
            for (int i = 0; i < 1000; ++i) {
                EXPECT_TRUE(world.alive(std::get<0>(item)));
                promised.push_back(commands.create());
                commands.add(promised.back(), Position{});
            }
        commands.clear();
        EXPECT_TRUE(commands.empty());
        commands.apply(world);
    }
    EXPECT_EQ(world.size(), 1u);
    for (const Entity entity : promised) EXPECT_FALSE(world.alive(entity));
    EXPECT_EQ(world.create(), (Entity{promised.back().index, 2})) << "the slots are used again";
}

TEST(CommandsPromiseTest, TwoQueuesApplyInAnyOrder) {
    World world;
    Commands first(world), second(world);
    const Entity a = first.create(), b = second.create(), c = first.create();
    second.add(b, Label{"b"});
    second.set_parent(b, a);
    first.add(a, Label{"a"});
    first.destroy(c);
    const Entity d = world.create();
    EXPECT_TRUE(d != a && d != b && d != c);
    second.apply(world);
    EXPECT_TRUE(world.alive(b));
    EXPECT_EQ(world.parent(b), Entity::null) << "its parent was not alive by then";
    first.apply(world);
    EXPECT_EQ(world.get<Label>(a).text, "a");
    EXPECT_FALSE(world.alive(c));
    EXPECT_EQ(world.size(), 3u);
}

} // namespace
} // namespace hachure
