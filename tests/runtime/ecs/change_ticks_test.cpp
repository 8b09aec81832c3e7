#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(ChangeTicksTest, StartAtOneAndAdvanceByOne) {
    World world;
    EXPECT_EQ(world.tick(), 1u);
    EXPECT_EQ(world.advance_tick(), 2u);
    EXPECT_EQ(world.tick(), 2u);
}

TEST(ChangeTicksTest, AddingSetsBoth) {
    World world;
    world.advance_tick();
    const Entity entity = world.create_with(Position{});
    EXPECT_EQ(world.added_tick<Position>(entity), 2u);
    EXPECT_EQ(world.changed_tick<Position>(entity), 2u);
    EXPECT_EQ(world.last_changed<Position>(), 2u);
    EXPECT_EQ(world.last_changed<Speed>(), 0u);
}

TEST(ChangeTicksTest, SinceIsExclusive) {
    World world;
    const Entity entity = world.create_with(Position{});
    EXPECT_TRUE(world.changed_since<Position>(entity, 0));
    EXPECT_FALSE(world.changed_since<Position>(entity, 1));
    EXPECT_FALSE(world.changed_since<Speed>(entity, 0));
    EXPECT_FALSE(world.changed_since<Position>(Entity::null, 0));
}

TEST(ChangeTicksTest, EveryWayToWriteMarksChangedAndNotAdded) {
    World world;
    const Entity entity = world.create_with(Position{});
    Tick before = world.tick();
    const auto expect_changed = [&](const char* how) {
        EXPECT_EQ(world.changed_tick<Position>(entity), world.tick()) << how;
        EXPECT_EQ(world.last_changed<Position>(), world.tick()) << how;
        EXPECT_EQ(world.added_tick<Position>(entity), 1u) << how;
        EXPECT_TRUE(world.changed_since<Position>(entity, before)) << how;
        before = world.tick();
        world.advance_tick();
    };
    world.advance_tick();
    world.get_mutable<Position>(entity).x = 1;
    expect_changed("get_mutable");
    world.find_mutable<Position>(entity)->x = 2;
    expect_changed("find_mutable");
    world.add(entity, Position{3, 0});
    expect_changed("add");
    world.set_if_different(entity, Position{4, 0});
    expect_changed("set_if_different");
    for (auto [visited, position] : world.query<Position>()) position.x = 5;
    expect_changed("query");
    for (auto [visited, position] : world.query<Optional<Position>>()) position->x = 6;
    expect_changed("optional");
}

TEST(ChangeTicksTest, ReadingMarksNothing) {
    World world;
    const Entity entity = world.create_with(Position{1, 2});
    world.advance_tick();
    world.get<Position>(entity);
    world.find<Position>(entity);
    world.has<Position>(entity);
    EXPECT_FALSE(world.set_if_different(entity, Position{1, 2}));
    world.query<const Position>().each([](const Position&) {});
    world.query<Optional<const Position>>().each([](const Position*) {});
    EXPECT_EQ(world.query<Position>().count(), 1u);
    EXPECT_EQ(world.query<Position>().first(), entity);
    EXPECT_FALSE(world.query<Position>().empty());
    EXPECT_EQ(world.last_changed<Position>(), 1u);
}

TEST(ChangeTicksTest, SetIfDifferentAddsWhatIsAbsent) {
    World world;
    const Entity entity = world.create();
    EXPECT_TRUE(world.set_if_different(entity, Speed{3}));
    EXPECT_FALSE(world.set_if_different(entity, Speed{3}));
    EXPECT_TRUE(world.set_if_different(entity, Speed{4}));
    EXPECT_EQ(world.get<Speed>(entity), Speed{4});
}

TEST(ChangeTicksTest, AQueryMarksOnlyWhatItVisits) {
    World world;
    const Entity seen = world.create_with(Position{}, Speed{});
    const Entity skipped = world.create_with(Position{});
    const Entity hidden = world.create_with(Position{}, Speed{}, Hidden{});
    world.advance_tick();
    world.query<Position, const Speed, Without<Hidden>>().each([](Position&, const Speed&) {});
    EXPECT_EQ(world.changed_tick<Position>(seen), 2u);
    EXPECT_EQ(world.changed_tick<Speed>(seen), 1u);
    EXPECT_EQ(world.changed_tick<Position>(skipped), 1u);
    EXPECT_EQ(world.changed_tick<Position>(hidden), 1u);
}

TEST(ChangeTicksTest, RemovalKeepsTheTicksOfOthers) {
    World world;
    const Entity a = world.create_with(Position{});
    world.advance_tick();
    const Entity b = world.create_with(Position{});
    world.advance_tick();
    const Entity c = world.create_with(Position{});
    world.advance_tick();
    world.get_mutable<Position>(c);
    world.remove<Position>(a);
    EXPECT_EQ(world.added_tick<Position>(b), 2u);
    EXPECT_EQ(world.added_tick<Position>(c), 3u);
    EXPECT_EQ(world.changed_tick<Position>(c), 4u);
}

TEST(ChangeTicksTest, RemovalsAreRemembered) {
    World world;
    const Entity a = world.create_with(Position{}, Speed{});
    const Entity b = world.create_with(Position{});
    EXPECT_THAT(world.removed_since<Position>(0), IsEmpty());
    world.advance_tick();
    world.remove<Position>(b);
    world.advance_tick();
    world.destroy(a);
    EXPECT_THAT(world.removed_since<Position>(0), ElementsAre(b, a));
    EXPECT_THAT(world.removed_since<Position>(2), ElementsAre(a));
    EXPECT_THAT(world.removed_since<Position>(3), IsEmpty());
    EXPECT_THAT(world.removed_since<Speed>(0), ElementsAre(a));
    EXPECT_THAT(world.removed_since<Label>(0), IsEmpty());
    EXPECT_EQ(world.last_changed<Position>(), 3u);
}

TEST(ChangeTicksTest, RemovalsCanBeForgotten) {
    World world;
    const Entity a = world.create_with(Position{});
    const Entity b = world.create_with(Position{});
    world.destroy(a);
    world.advance_tick();
    world.destroy(b);
    world.forget_removed_before(2);
    EXPECT_THAT(world.removed_since<Position>(0), ElementsAre(b));
    world.forget_removed_before(3);
    EXPECT_THAT(world.removed_since<Position>(0), IsEmpty());
    EXPECT_EQ(world.last_changed<Position>(), 2u);
}

} // namespace
} // namespace hachure
