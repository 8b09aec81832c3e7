#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <type_traits>

namespace hachure {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::ThrowsMessage;

static_assert(!std::is_copy_constructible_v<World>);
static_assert(std::is_nothrow_move_constructible_v<World> && std::is_nothrow_move_assignable_v<World>);

TEST(WorldTest, CreatesAndDestroys) {
    World world;
    EXPECT_EQ(world.size(), 0u);
    const Entity a = world.create();
    const Entity b = world.create();
    EXPECT_NE(a, b);
    EXPECT_EQ(world.size(), 2u);
    EXPECT_TRUE(world.destroy(a));
    EXPECT_FALSE(world.alive(a));
    EXPECT_TRUE(world.alive(b));
    EXPECT_EQ(world.size(), 1u);
    EXPECT_FALSE(world.destroy(a));
    EXPECT_FALSE(world.destroy(Entity::null));
}

TEST(WorldTest, AReusedSlotStartsEmpty) {
    World world;
    const Entity old = world.create_with(Position{1, 2}, Label{"old"});
    world.destroy(old);
    const Entity young = world.create();
    ASSERT_EQ(young.index, old.index);
    EXPECT_FALSE(world.has<Position>(young));
    world.add(young, Position{3, 4});
    EXPECT_FALSE(world.has<Position>(old));
    EXPECT_EQ(world.find<Position>(old), nullptr);
    EXPECT_EQ(world.find_mutable<Position>(old), nullptr);
    EXPECT_FALSE(world.remove<Position>(old));
    EXPECT_EQ(world.get<Position>(young), (Position{3, 4}));
}

TEST(WorldTest, GetsSeveralComponentsAtOnce) {
    World world;
    const Entity entity = world.create_with(Position{1, 2}, Label{"one"}, Heat{3});
    const auto [position, label, heat] = world.get<Position, Label, Heat>(entity);
    EXPECT_EQ(&position, &world.get<Position>(entity));
    EXPECT_EQ(&label, &world.get<Label>(entity));
    EXPECT_EQ(&heat, &world.get<Heat>(entity));
    EXPECT_THROW((world.get<Position, Speed>(entity)), MissingComponent);
    world.destroy(entity);
    EXPECT_THROW((world.get<Position, Label>(entity)), DeadEntity);
}

struct MadeBeforeMain {
    int value = 0;
};

struct BeforeMain {
    BeforeMain() {
        World world;
        const Entity entity = world.create_with(MadeBeforeMain{42});
        unnumbered = detail::type_id_of<detail::TypeFamily::component, MadeBeforeMain> == 0;
        found = world.has<MadeBeforeMain>(entity) ? world.get<MadeBeforeMain>(entity).value : 0;
    }

    bool unnumbered;
    int found;
};

// Before the variables that hold the numbers of types are set.
[[gnu::init_priority(200)]] const BeforeMain before_main;

TEST(WorldTest, CanBeReadBeforeTypesHaveNumbers) {
    EXPECT_TRUE(before_main.unnumbered);
    EXPECT_EQ(before_main.found, 42);
}

TEST(WorldTest, AddingTwiceReplacesTheValue) {
    World world;
    const Entity entity = world.create();
    EXPECT_EQ(world.add(entity, Label{"one"}).text, "one");
    EXPECT_EQ(world.add(entity, Label{"two"}).text, "two");
    EXPECT_EQ(world.get<Label>(entity).text, "two");
    EXPECT_EQ(world.query<const Label>().count(), 1u);
}

TEST(WorldTest, AddsADefault) {
    World world;
    EXPECT_EQ(world.add<Speed>(world.create()), Speed{1});
}

TEST(WorldTest, RemovingWhatIsAbsentIsFalse) {
    World world;
    const Entity entity = world.create_with(Speed{});
    EXPECT_FALSE(world.remove<Position>(entity));
    EXPECT_TRUE(world.remove<Speed>(entity));
    EXPECT_FALSE(world.remove<Speed>(entity));
    EXPECT_FALSE(world.remove<Speed>(Entity::null));
}

TEST(WorldTest, RemovingOneKeepsTheOthers) {
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 5; ++i) entities.push_back(world.create_with(Label{std::to_string(i)}));
    world.remove<Label>(entities[1]);
    world.destroy(entities[4]);
    EXPECT_EQ(world.get<Label>(entities[0]).text, "0");
    EXPECT_EQ(world.get<Label>(entities[2]).text, "2");
    EXPECT_EQ(world.get<Label>(entities[3]).text, "3");
    EXPECT_FALSE(world.has<Label>(entities[1]));
}

TEST(WorldTest, HoldsMoveOnlyComponents) {
    World world;
    const Entity a = world.create_with(Owner{std::make_unique<int>(1)});
    const Entity b = world.create_with(Owner{std::make_unique<int>(2)});
    world.destroy(a);
    EXPECT_EQ(*world.get<Owner>(b).value, 2);
}

TEST(WorldTest, GetOnADeadEntityThrows) {
    World world;
    const Entity dead = world.create_with(Position{});
    world.destroy(dead);
    const auto is_dead = ThrowsMessage<DeadEntity>(HasSubstr("entity 0v1 is dead"));
    EXPECT_THAT([&] { world.get<Position>(dead); }, is_dead);
    EXPECT_THAT([&] { world.get_mutable<Position>(dead); }, is_dead);
    EXPECT_THAT([&] { world.add(dead, Position{}); }, is_dead);
    EXPECT_THAT([&] { world.set_if_different(dead, Position{}); }, is_dead);
    EXPECT_THAT([&] { world.changed_tick<Position>(dead); }, is_dead);
    EXPECT_THROW(world.add<Speed>(Entity::null), DeadEntity);
}

TEST(WorldTest, GetNamesTheMissingComponent) {
    World world;
    const Entity entity = world.create();
    const auto is_missing =
        ThrowsMessage<MissingComponent>(testing::StrEq("entity 0v1 has no hachure::test::Position"));
    EXPECT_THAT([&] { world.get<Position>(entity); }, is_missing);
    EXPECT_THAT([&] { world.get_mutable<Position>(entity); }, is_missing);
    EXPECT_THAT([&] { world.changed_tick<Position>(entity); }, is_missing);
    EXPECT_THAT([&] { world.added_tick<Position>(entity); }, is_missing);
}

TEST(WorldTest, MovingKeepsEverything) {
    World from;
    const Entity entity = from.create_with(Position{1, 2});
    from.set_resource(Label{"kept"});
    from.advance_tick();
    const Entity queued = from.commands().create();
    World to = std::move(from);
    EXPECT_EQ(to.get<Position>(entity), (Position{1, 2}));
    EXPECT_EQ(to.resource<Label>().text, "kept");
    EXPECT_EQ(to.tick(), 2u);
    to.apply_commands();
    EXPECT_TRUE(to.alive(queued));
    World other;
    other.create();
    other = std::move(to);
    EXPECT_EQ(other.size(), 2u);
    EXPECT_EQ(other.query<const Position>().count(), 1u);
}

TEST(WorldTest, SparseSlotsFindTheirRows) {
    // More than one page of slots, with the component on few of them.
    World world;
    std::vector<Entity> entities;
    for (int i = 0; i < 20'000; ++i) entities.push_back(world.create());
    for (int i = 4095; i < 20'000; i += 4096) world.add(entities[i], Position{double(i), 0});
    for (int i = 0; i < 20'000; ++i) ASSERT_EQ(world.has<Position>(entities[i]), i % 4096 == 4095) << i;
    for (int i = 4095; i < 20'000; i += 4096) EXPECT_EQ(world.get<Position>(entities[i]).x, i);
}

TEST(WorldResourceTest, OnePerTypeMoveOnlyAllowed) {
    World world;
    EXPECT_EQ(world.find_resource<Owner>(), nullptr);
    Owner& owner = world.set_resource(Owner{std::make_unique<int>(7)});
    for (int i = 0; i < 100; ++i) world.create_with(Position{});
    EXPECT_EQ(&owner, &world.resource<Owner>()) << "a resource stays where it is";
    *world.resource_mutable<Owner>().value = 8;
    EXPECT_EQ(*std::as_const(world).resource<Owner>().value, 8);
    world.set_resource(Owner{std::make_unique<int>(9)});
    EXPECT_EQ(*world.find_resource<Owner>()->value, 9);
    EXPECT_TRUE(world.remove_resource<Owner>());
    EXPECT_FALSE(world.remove_resource<Owner>());
    EXPECT_EQ(std::as_const(world).find_resource<Owner>(), nullptr);
}

TEST(WorldResourceTest, NamesTheMissingResource) {
    World world;
    const auto is_missing = ThrowsMessage<MissingResource>(HasSubstr("hachure::test::Label"));
    EXPECT_THAT([&] { std::as_const(world).resource<Label>(); }, is_missing);
    EXPECT_THAT([&] { world.resource_mutable<Label>(); }, is_missing);
}

} // namespace
} // namespace hachure
