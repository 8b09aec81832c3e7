#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

using PositionQuery = decltype(std::declval<World&>().query<const Position, Speed, Optional<Label>, With<Hidden>>());
static_assert(std::is_same_v<PositionQuery::Item, std::tuple<Entity, const Position&, Speed&, Label*>>);
static_assert(std::input_iterator<PositionQuery::Iterator>);
static_assert(std::sentinel_for<std::default_sentinel_t, PositionQuery::Iterator>);

template <class W, class... Terms>
concept CanQuery = requires(W& world) {
    world.template query<Terms...>();
};
static_assert(CanQuery<World, Position> && CanQuery<const World, const Position, Optional<const Speed>, With<Hidden>>);
static_assert(!CanQuery<const World, Position> && !CanQuery<const World, Optional<Position>>);

template <class Q> std::vector<Entity> entities_of(const Q& query) {
    std::vector<Entity> result;
    for (auto it = query.begin(); it != query.end(); ++it) result.push_back(it.entity());
    return result;
}

class QueryTest : public testing::Test {
protected:
    World world;
    Entity plain = world.create_with(Position{1, 0});
    Entity moving = world.create_with(Position{2, 0}, Speed{20});
    Entity hidden = world.create_with(Position{3, 0}, Speed{30}, Hidden{});
    Entity still = world.create_with(Speed{40});
    Entity bare = world.create();
};

TEST_F(QueryTest, FetchesWhatItNames) {
    for (auto [entity, position, speed] : world.query<Position, const Speed>()) position.y = speed.value;
    EXPECT_EQ(world.get<Position>(plain), (Position{1, 0}));
    EXPECT_EQ(world.get<Position>(moving), (Position{2, 20}));
    EXPECT_EQ(world.get<Position>(hidden), (Position{3, 30}));
}

TEST_F(QueryTest, ExcludesAndRequires) {
    EXPECT_THAT(entities_of(world.query<const Position, Without<Hidden>>()), UnorderedElementsAre(plain, moving));
    EXPECT_THAT(entities_of(world.query<const Speed, Without<Position, Hidden>>()), UnorderedElementsAre(still));
    EXPECT_THAT(entities_of(world.query<With<Position, Speed>>()), UnorderedElementsAre(moving, hidden));
    EXPECT_THAT(entities_of(world.query<Without<Position>>()), UnorderedElementsAre(still, bare));
    EXPECT_THAT(entities_of(world.query<const Position, Without<Label>>()),
                UnorderedElementsAre(plain, moving, hidden));
}

TEST_F(QueryTest, WithoutTermsVisitsAll) {
    EXPECT_THAT(entities_of(world.query<>()), UnorderedElementsAre(plain, moving, hidden, still, bare));
}

TEST_F(QueryTest, OptionalGivesNullWhereAbsent) {
    for (auto [entity, position, speed, label] :
         world.query<const Position, Optional<const Speed>, Optional<Label>>()) {
        EXPECT_EQ(speed != nullptr, entity != plain);
        EXPECT_EQ(label, nullptr);
        EXPECT_EQ(speed ? speed->value : 0, speed ? position.x * 10 : 0);
    }
    EXPECT_EQ(world.query<Optional<const Position>>().count(), world.size());
}

TEST_F(QueryTest, EachTakesTheEntityOrNot) {
    std::vector<Entity> seen;
    double sum = 0;
    world.query<const Position>().each([&](Entity entity, const Position& position) {
        seen.push_back(entity);
        sum += position.x;
    });
    world.query<const Position, With<Hidden>>().each([&](const Position& position) { sum += 100 * position.x; });
    EXPECT_THAT(seen, UnorderedElementsAre(plain, moving, hidden));
    EXPECT_EQ(sum, 306);
}

TEST_F(QueryTest, WhatNobodyHasMatchesNothing) {
    EXPECT_TRUE((world.query<const Position, const Label>().empty()));
    EXPECT_TRUE((world.query<With<Label>>().empty()));
    EXPECT_EQ((world.query<const Label>().first()), Entity::null);
    EXPECT_EQ((world.query<const Label>().count()), 0u);
    EXPECT_TRUE(std::as_const(world).query<const Label>().empty());
}

TEST_F(QueryTest, ReadsAConstantWorld) {
    const World& constant = world;
    EXPECT_THAT(entities_of(constant.query<const Position, const Speed>()), UnorderedElementsAre(moving, hidden));
}

TEST_F(QueryTest, MayBeKeptAndWalkedAgain) {
    const auto query = world.query<const Label>();
    EXPECT_EQ(query.count(), 0u);
    world.add(bare, Label{});
    EXPECT_EQ(query.first(), bare);
}

TEST_F(QueryTest, FindsChangesSinceATick) {
    const Tick before = world.tick();
    EXPECT_EQ(world.query<const Position>().changed_since<Position>(0).count(), 3u);
    EXPECT_TRUE(world.query<const Position>().changed_since<Position>(before).empty());
    world.advance_tick();
    world.get_mutable<Position>(moving);
    world.get_mutable<Speed>(hidden);
    world.get_mutable<Speed>(still);
    world.add(bare, Position{});
    const auto positions = world.query<const Position>();
    EXPECT_THAT(entities_of(positions.changed_since<Position>(before)), UnorderedElementsAre(moving, bare));
    EXPECT_THAT(entities_of(positions.added_since<Position>(before)), UnorderedElementsAre(bare));
    EXPECT_THAT(entities_of(positions.changed_since<Speed>(before)), UnorderedElementsAre(hidden));
    EXPECT_THAT(entities_of((positions.changed_since<Position, Speed>(before))),
                UnorderedElementsAre(moving, hidden, bare))
        << "one of them is enough";
    world.get_mutable<Speed>(moving);
    EXPECT_THAT(entities_of(positions.changed_since<Position>(before).changed_since<Speed>(before)),
                UnorderedElementsAre(moving))
        << "chained filters must all hold";
    EXPECT_THAT(entities_of(positions.changed_since<Position>(before).added_since<Speed>(before)), ElementsAre());
    EXPECT_THAT(entities_of(world.query<>().changed_since<Speed>(before)), UnorderedElementsAre(moving, hidden, still));
}

TEST_F(QueryTest, SameCallsGiveTheSameOrder) {
    const auto build = [] {
        World other;
        std::vector<Entity> entities;
        for (int i = 0; i < 200; ++i) entities.push_back(other.create_with(Position{double(i), 0}));
        for (int i = 0; i < 200; i += 3) other.remove<Position>(entities[i]);
        for (int i = 0; i < 200; i += 7) other.destroy(entities[i]);
        for (int i = 0; i < 20; ++i) other.create_with(Position{});
        return entities_of(other.query<const Position>());
    };
    EXPECT_EQ(build(), build());
}

TEST_F(QueryTest, CommandsChangeWhatIsWalked) {
    for (auto [entity, position] : world.query<const Position>()) {
        world.commands().remove<Position>(entity);
        world.commands().add(world.commands().create(), Position{position.x + 10, 0});
    }
    EXPECT_EQ(world.query<const Position>().count(), 3u);
    world.apply_commands();
    std::vector<double> left;
    world.query<const Position>().each([&](const Position& position) { left.push_back(position.x); });
    EXPECT_THAT(left, UnorderedElementsAre(11, 12, 13));
}

TEST_F(QueryTest, ReplacingAndRemovingTheAbsentAreNoStructuralChange) {
    for (auto [entity, position] : world.query<const Position>()) {
        world.add(entity, Position{9, 9});
        EXPECT_FALSE(world.remove<Label>(entity));
    }
    EXPECT_EQ(world.get<Position>(plain), (Position{9, 9}));
}

TEST_F(QueryTest, LeavingTheLoopUnlocksTheWorld) {
    for (auto item : world.query<const Position>()) {
        EXPECT_TRUE(std::get<0>(item));
        break;
    }
    world.create();
    try {
        world.query<const Position>().each([](const Position&) { throw std::runtime_error("left"); });
        FAIL();
    } catch (const std::runtime_error&) {
        world.create();
    }
    for (auto [entity, position] : world.query<const Position>())
        for (auto [inner, speed] : world.query<const Speed>()) EXPECT_TRUE(world.alive(entity) && world.alive(inner));
    world.create();
}

using QueryDeathTest = QueryTest;

template <class F> void while_walking(World& world, F change) {
    for (auto [entity, position] : world.query<const Position>()) change(entity);
}

TEST_F(QueryDeathTest, StructuralChangesAssertWhileWalking) {
    const char* message = "keeps its structure";
    EXPECT_DEATH(while_walking(world, [&](Entity) { world.create(); }), message);
    EXPECT_DEATH(while_walking(world, [&](Entity entity) { world.destroy(entity); }), message);
    EXPECT_DEATH(while_walking(world, [&](Entity entity) { world.add(entity, Label{}); }), message);
    EXPECT_DEATH(while_walking(world, [&](Entity entity) { world.remove<Position>(entity); }), message);
    EXPECT_DEATH(while_walking(world, [&](Entity) { world.set_parent(bare, still); }), message);
    EXPECT_DEATH(while_walking(world, [&](Entity) { world.advance_tick(); }), message);
    EXPECT_DEATH(while_walking(world,
                               [&](Entity entity) {
                                   world.commands().destroy(entity);
                                   world.apply_commands();
                               }),
                 message);
    EXPECT_DEATH(while_walking(world, [&](Entity) { World stolen = std::move(world); }), message);
}

} // namespace
} // namespace hachure
