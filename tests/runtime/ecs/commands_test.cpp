#include <hachure/runtime/ecs/commands.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;

TEST(CommandsTest, NothingHappensBeforeApply) {
    World world;
    const Entity entity = world.create_with(Position{});
    Commands commands(world);
    EXPECT_TRUE(commands.empty());
    const Entity created = commands.create();
    commands.add(created, Label{"new"});
    commands.add(entity, Speed{2});
    commands.remove<Position>(entity);
    EXPECT_FALSE(commands.empty());
    EXPECT_FALSE(world.alive(created));
    EXPECT_FALSE(world.has<Speed>(entity));
    EXPECT_TRUE(world.has<Position>(entity));
    commands.apply(world);
    EXPECT_TRUE(commands.empty());
    EXPECT_EQ(world.get<Label>(created).text, "new");
    EXPECT_EQ(world.get<Speed>(entity), Speed{2});
    EXPECT_FALSE(world.has<Position>(entity));
}

TEST(CommandsTest, ApplyInOrder) {
    World world;
    const Entity entity = world.create();
    Commands commands(world);
    commands.add(entity, Speed{1});
    commands.add(entity, Speed{2});
    commands.remove<Speed>(entity);
    commands.add(entity, Speed{3});
    commands.apply(world);
    EXPECT_EQ(world.get<Speed>(entity), Speed{3});
}

TEST(CommandsTest, DropWhatIsDeadByThen) {
    World world;
    const Entity gone = world.create();
    const Entity stays = world.create();
    Commands commands(world);
    commands.add(gone, Speed{});
    commands.set_parent(stays, gone);
    commands.set_parent(gone, stays);
    commands.clear_parent(gone);
    commands.destroy(stays);
    commands.add(stays, Speed{});
    commands.destroy(stays);
    const Entity brief = commands.create();
    commands.destroy(brief);
    commands.add(brief, Speed{});
    world.destroy(gone);
    commands.apply(world);
    EXPECT_EQ(world.size(), 0u);
    EXPECT_EQ(world.last_changed<Speed>(), 0u);
}

TEST(CommandsTest, CarryMoveOnlyComponentsAndTheTree) {
    World world;
    Commands& commands = world.commands();
    const Entity parent = commands.create();
    const Entity child = commands.create();
    commands.set_parent(child, parent);
    commands.add(child, Owner{std::make_unique<int>(5)});
    world.apply_commands();
    EXPECT_THAT(world.children(parent), ElementsAre(child));
    EXPECT_EQ(*world.get<Owner>(child).value, 5);
    commands.clear_parent(child);
    world.apply_commands();
    EXPECT_EQ(world.parent(child), Entity::null);
}

TEST(CommandsTest, AQueueIsUsedAgain) {
    World world;
    Commands commands(world);
    for (int round = 0; round < 3; ++round) {
        const Entity entity = commands.create();
        commands.add(entity, Speed{double(round)});
        commands.apply(world);
        EXPECT_EQ(world.get<Speed>(entity), Speed{double(round)});
    }
    EXPECT_EQ(world.size(), 3u);
}

TEST(CommandsTest, ForgottenCreationsGiveTheirIdsBack) {
    World world;
    Entity forgotten;
    {
        Commands commands(world);
        forgotten = commands.create();
    }
    const Entity next = world.create();
    EXPECT_EQ(next.index, forgotten.index);
    EXPECT_FALSE(world.alive(forgotten));
    EXPECT_TRUE(world.alive(next));
}

TEST(CommandsTest, ACycleEndsTheQueue) {
    World world;
    const Entity parent = world.create();
    const Entity child = world.create();
    world.set_parent(child, parent);
    Commands commands(world);
    commands.set_parent(parent, child);
    const Entity later = commands.create();
    commands.add(parent, Speed{});
    EXPECT_THROW(commands.apply(world), HierarchyCycle);
    EXPECT_TRUE(commands.empty());
    EXPECT_FALSE(world.alive(later));
    EXPECT_FALSE(world.has<Speed>(parent));
    EXPECT_EQ(world.size(), 2u);
}

TEST(CommandsTest, MayOutliveTheirWorldAndMove) {
    auto world = std::make_unique<World>();
    Commands commands(*world);
    commands.create();
    Commands moved = std::move(commands);
    World other;
    moved = Commands(other);
    const Entity entity = moved.create();
    moved.apply(other);
    EXPECT_TRUE(other.alive(entity));
    Commands orphan(*world);
    orphan.create();
    world.reset();
}

TEST(CommandsDeathTest, AQueueBelongsToOneWorld) {
    World world;
    World other;
    Commands commands(world);
    commands.create();
    EXPECT_DEATH(commands.apply(other), "made for");
}

} // namespace
} // namespace hachure
