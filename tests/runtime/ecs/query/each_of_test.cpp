#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <vector>

namespace hachure::test {
namespace {

using ::testing::ElementsAre;

struct NeverMade {};
struct NeverMadeTag {
    static constexpr auto storage = Storage::sparse;
};

/// What `each_of` is defined by: one entity after the other.
template <class Query> std::vector<Entity> visited(const Query& query, const std::vector<Entity>& entities) {
    std::vector<Entity> result;
    query.each_of(entities, [&](Entity entity, auto&&...) { result.push_back(entity); });
    return result;
}

template <class Query> std::vector<Entity> contained(const Query& query, const std::vector<Entity>& entities) {
    std::vector<Entity> result;
    std::ranges::copy_if(entities, std::back_inserter(result), [&](Entity entity) { return query.contains(entity); });
    return result;
}

/// Entities of all kinds, dead ones among them, in random order and some of them twice; more than are taken in one go.
struct EachOfTest : ::testing::Test {
    EachOfTest() {
        for (int i = 0; i < 500; ++i) {
            const Entity entity = world.create();
            if (random() % 2) world.add(entity, Position{double(i), 0});
            if (random() % 2) world.add(entity, Speed{double(i)});
            if (random() % 3 == 0) world.add(entity, Hidden{});
            if (random() % 3 == 0) world.add(entity, Heat{double(i)});
            entities.push_back(entity);
        }
        for (int i = 0; i < 100; ++i) entities.push_back(entities[random() % 500]);
        for (int i = 0; i < 50; ++i) world.destroy(entities[random() % 500]);
        entities.push_back(Entity::null);
        entities.push_back({1'000'000, 1});
        std::ranges::shuffle(entities, random);
    }

    template <class... Terms> void expect_same() {
        const auto query = world.query<Terms...>();
        const std::vector<Entity> expected = contained(query, entities);
        EXPECT_EQ(visited(query, entities), expected);
        for (std::size_t count : {0u, 1u, 31u, 32u, 33u, 64u, 65u}) {
            const std::vector<Entity> some(entities.begin(), entities.begin() + static_cast<std::ptrdiff_t>(count));
            EXPECT_EQ(visited(query, some), contained(query, some)) << count;
        }
    }

    std::mt19937 random{7};
    World world;
    std::vector<Entity> entities;
};

TEST_F(EachOfTest, VisitsTheListedOnesThatMatchInTheirOrder) {
    expect_same<const Position>();
    expect_same<const Position, const Speed>();
    expect_same<const Position, With<Hidden>>();
    expect_same<const Position, Without<Hidden>>();
    expect_same<const Position, Optional<const Speed>>();
    expect_same<AnyOf<const Position, const Speed>>();
    expect_same<Without<Position, Speed>>();
}

TEST_F(EachOfTest, TakesSparseComponents) {
    expect_same<const Heat>();
    expect_same<const Position, const Heat>();
    expect_same<const Position, Without<Heat>>();
    expect_same<const Position, Optional<const Heat>>();
}

TEST_F(EachOfTest, TakesComponentsThatTheWorldHasNeverSeen) {
    expect_same<const Position, Without<NeverMade>>();
    expect_same<const Position, Optional<const NeverMade>>();
    expect_same<const Position, Without<NeverMadeTag>>();
    EXPECT_TRUE(visited(world.query<const Position, With<NeverMade>>(), entities).empty());
    EXPECT_TRUE(visited(world.query<const NeverMade>(), entities).empty());
}

TEST_F(EachOfTest, GivesTheValuesOfTheEntity) {
    world.query<const Position, Optional<const Speed>>().each_of(
        entities, [&](Entity entity, const Position& position, const Speed* speed) {
            EXPECT_EQ(&position, world.find<Position>(entity));
            EXPECT_EQ(speed, world.find<Speed>(entity));
        });
}

TEST_F(EachOfTest, MarksWhatItVisits) {
    world.advance_tick();
    const Tick now = world.tick();
    std::vector<Entity> some(entities.begin(), entities.begin() + 100);
    world.query<Position, With<Speed>>().each_of(some, [](Position& position) { position.y = 1; });
    for (auto [entity, position] : world.query<const Position>()) {
        const bool listed = std::ranges::find(some, entity) != some.end() && world.has<Speed>(entity);
        EXPECT_EQ(world.changed_tick<Position>(entity) == now, listed) << to_string(entity);
        EXPECT_EQ(position.y == 1, listed);
    }
}

TEST_F(EachOfTest, KeepsToChangeFilters) {
    world.advance_tick();
    const Tick since = world.tick();
    world.advance_tick();
    for (std::size_t i = 0; i < entities.size(); i += 3)
        if (Position* position = world.find_mutable<Position>(entities[i])) position->x += 1;
    const auto query = world.query<const Position>().changed_since<Position>(since);
    EXPECT_FALSE(visited(query, entities).empty());
    EXPECT_EQ(visited(query, entities), contained(query, entities));
}

TEST_F(EachOfTest, StopsWhereTheVisitorThrows) {
    int visits = 0;
    EXPECT_THROW(world.query<const Position>().each_of(entities,
                                                       [&](const Position&) {
                                                           if (++visits == 40) throw 1;
                                                       }),
                 int);
    EXPECT_EQ(visits, 40);
    world.create(); // the walk has ended
}

} // namespace
} // namespace hachure::test
