// What a walk marks changed: exactly the components that it writes of the entities that it visits.

#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>

#include <gtest/gtest.h>

#include <set>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using Visited = std::set<Entity>;

/// A few thousand entities in tables of many chunks, all of tick 1; the world is in tick 2.
class QueryMarksTest : public testing::Test {
protected:
    World world;
    std::vector<Entity> all;

    QueryMarksTest() {
        keep(world.create_many(1500, Position{}, Speed{}));
        keep(world.create_many(30, Position{}));
        keep(world.create_many(700, Position{}, Label{}));
        keep(world.create_many(40, Speed{}, Label{}));
        for (std::size_t i = 0; i < all.size(); i += 3) world.add(all[i], Heat{});
        for (std::size_t i = 0; i < all.size(); i += 5) world.add(all[i], Note{});
        world.advance_tick();
    }

    void keep(const std::vector<Entity>& some) { all.insert(all.end(), some.begin(), some.end()); }

    /// C was marked since tick 1 for those in `visited` and for no other.
    template <class C> void expect_marked(const Visited& visited, const char* where) {
        Visited with;
        for (const Entity entity : all) {
            if (!world.has<C>(entity)) continue;
            if (visited.contains(entity)) with.insert(entity);
            ASSERT_EQ(world.changed_tick<C>(entity), visited.contains(entity) ? world.tick() : 1) << where;
            ASSERT_EQ(world.added_tick<C>(entity), 1u) << where;
        }
        EXPECT_EQ(world.last_changed<C>(), with.empty() ? 1 : world.tick()) << where;
        for (const auto how : {detail::ChangeWalk::queue, detail::ChangeWalk::sweep}) {
            Visited found;
            std::size_t visits = 0;
            world.query<const C>().template changed_since<C>(1).finding_changes(how).each([&](Entity e, const C&) {
                found.insert(e);
                ++visits;
            });
            EXPECT_EQ(found, with) << where;
            EXPECT_EQ(visits, with.size()) << where;
        }
    }
    void expect_unmarked(const char* where) {
        expect_marked<Position>({}, where);
        expect_marked<Speed>({}, where);
        expect_marked<Label>({}, where);
        expect_marked<Heat>({}, where);
        expect_marked<Note>({}, where);
    }
};

/// Breaks off after so many visits.
class QueryMarksAfter : public QueryMarksTest, public testing::WithParamInterface<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Visits, QueryMarksAfter, testing::Values(1, 2, 63, 64, 65, 400, 503, 504, 505, 1500, 2229));

TEST_P(QueryMarksAfter, ABrokenPlainWalk) {
    Visited visited;
    for (auto [entity, position, speed] : world.query<Position, Optional<Speed>>()) {
        visited.insert(entity);
        if (visited.size() == GetParam()) break;
    }
    expect_marked<Position>(visited, "written");
    expect_marked<Speed>(visited, "optional");
    expect_marked<Label>({}, "not named");
}

TEST_P(QueryMarksAfter, ABrokenWalkByRow) {
    Visited visited;
    for (auto [entity, position, heat, label, again] :
         world.query<Position, Optional<Heat>, AnyOf<Label, const Position>>()) {
        visited.insert(entity);
        if (visited.size() == GetParam()) break;
    }
    expect_marked<Position>(visited, "written");
    expect_marked<Heat>(visited, "optional and sparse");
    expect_marked<Label>(visited, "one of any");
    expect_marked<Speed>({}, "not named");
}

TEST_P(QueryMarksAfter, AnExceptionInTheLoop) {
    Visited visited;
    try {
        for (auto [entity, position] : world.query<Position>()) {
            visited.insert(entity);
            if (visited.size() == GetParam()) throw std::runtime_error("left");
        }
    } catch (const std::runtime_error&) {
    }
    expect_marked<Position>(visited, "written");
}

TEST_P(QueryMarksAfter, ABrokenFilteredWalk) {
    Visited visited;
    for (auto [entity, speed, position] : world.query<Speed, Optional<Position>>().changed_since<Speed>(0)) {
        visited.insert(entity);
        if (visited.size() == GetParam()) break;
    }
    expect_marked<Position>(visited, "optional");
    expect_marked<Speed>(visited, "written");
}

TEST_F(QueryMarksTest, AWholeWalk) {
    Visited visited;
    for (auto [entity, position, heat] : world.query<Position, Heat>()) visited.insert(entity);
    EXPECT_GT(visited.size(), 700u);
    expect_marked<Position>(visited, "sparse beside");
    expect_marked<Heat>(visited, "sparse");
    expect_marked<Note>({}, "not named");
}

TEST_F(QueryMarksTest, ReachingIsVisiting) {
    const auto query = world.query<Position>();
    const Entity first = query.first();
    {
        auto it = query.begin();
        EXPECT_EQ(it.entity(), first);
        auto moved = std::move(it);
        EXPECT_EQ(moved.entity(), first);
    }
    expect_marked<Position>({first}, "an iterator that was not read");
}

TEST_F(QueryMarksTest, MovedIteratorsMarkOnce) {
    const auto query = world.query<Heat>();
    Visited visited;
    {
        auto it = query.begin();
        for (int i = 0; i < 10; ++i) {
            visited.insert(it.entity());
            auto next = std::move(it);
            it = std::move(next);
            if (i < 9) ++it;
        }
    }
    expect_marked<Heat>(visited, "moved to and fro");
}

TEST_F(QueryMarksTest, ConstantTermsMarkNothing) {
    for (auto item : world.query<const Position, Optional<const Speed>, AnyOf<const Label, const Heat>, With<Note>>())
        ASSERT_TRUE(std::get<0>(item));
    world.query<const Position>().each([](const Position&) {});
    world.query<const Position>().each_chunk([](std::span<const Entity>, std::span<const Position>) {});
    world.query<const Heat>().parallel_each([](const Heat&) {});
    world.query<const Position>().parallel_each_chunk([](std::span<const Entity>, std::span<const Position>) {});
    world.query<const Heat>().sorted([](const Heat& heat) { return heat.value; });
    world.query<const Heat>().find(all[0]);
    expect_unmarked("constant");
}

TEST_F(QueryMarksTest, AskingMarksNothing) {
    const auto plain = world.query<Position, Speed>();
    const auto by_row = world.query<Position, Optional<Heat>, AnyOf<Label, Note>>();
    const auto filtered = world.query<Speed>().changed_since<Speed>(0);
    EXPECT_FALSE(plain.empty() || by_row.empty() || filtered.empty());
    EXPECT_TRUE(plain.count() > 0 && by_row.count() > 0 && filtered.count() > 0);
    EXPECT_TRUE(plain.first() && by_row.first() && filtered.first());
    for (const Entity entity : all)
        if (plain.contains(entity) && by_row.contains(entity) && filtered.contains(entity)) break;
    EXPECT_TRUE(world.query<Label>().changed_since<Label>(1).empty());
    expect_unmarked("asking");
}

TEST_F(QueryMarksTest, FindMarksOne) {
    const Entity entity = all[15];
    EXPECT_TRUE((world.query<Position, Optional<Label>, Heat, AnyOf<Note, const Speed>>().find(entity)));
    EXPECT_FALSE((world.query<Position, Label>().find(entity)));
    EXPECT_FALSE(world.query<Speed>().changed_since<Speed>(1).find(entity));
    expect_marked<Position>({entity}, "found");
    expect_marked<Heat>({entity}, "found");
    expect_marked<Note>({entity}, "found");
    expect_marked<Label>({}, "absent");
    expect_marked<Speed>({}, "constant, or not passed by the filter");
}

TEST_F(QueryMarksTest, EveryWholeWalkMarksTheSame) {
    Visited visited;
    world.query<const Position, With<Label>>().each([&](Entity entity, const Position&) { visited.insert(entity); });
    const auto query = world.query<Position, With<Label>>();
    const auto nothing = [](auto&&...) {};
    const auto check = [&](const char* where) {
        expect_marked<Position>(visited, where);
        for (const Entity entity : visited) ASSERT_EQ(world.changed_tick<Position>(entity), world.tick()) << where;
        world.advance_tick();
    };
    query.each(nothing);
    check("each");
    query.each_chunk(nothing);
    expect_marked<Speed>({}, "each_chunk");
    for (const Entity entity : visited) EXPECT_EQ(world.changed_tick<Position>(entity), world.tick());
    query.parallel_each(nothing);
    query.parallel_each_chunk(nothing);
    query.sorted([](const Position& position) { return position.x; });
    check("all others");
}

TEST_F(QueryMarksTest, WalksInsideWalks) {
    Visited outer, inner;
    for (auto [entity, position] : world.query<Position>()) {
        outer.insert(entity);
        for (auto [other, heat] : world.query<Heat>()) {
            inner.insert(other);
            if (inner.size() == 2 * outer.size()) break;
        }
        if (outer.size() == 7) break;
    }
    expect_marked<Position>(outer, "outer");
    expect_marked<Heat>(inner, "inner");
}

TEST_F(QueryMarksTest, TwoWalksOfOneComponentAtATime) {
    // The second ends first; both mark what they reached.
    const auto query = world.query<Position>();
    Visited visited;
    {
        auto slow = query.begin();
        auto fast = query.begin();
        for (int i = 0; i < 600; ++i, ++fast) visited.insert(fast.entity());
        visited.insert(fast.entity());
        for (int i = 0; i < 300; ++i) ++slow;
    }
    expect_marked<Position>(visited, "two at a time");
}

} // namespace
} // namespace hachure
