#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;

TEST(DestroyMatchingTest, TakesDescendantsThatDoNotMatch) {
    World world;
    const Entity root = world.create_with(Position{});
    const Entity child = world.create_with(Speed{});
    const Entity stays = world.create_with(Speed{});
    world.set_parent(child, root);
    world.destroy_matching(world.query<const Position>());
    EXPECT_FALSE(world.alive(root) || world.alive(child));
    EXPECT_TRUE(world.alive(stays));
}

TEST(DestroyMatchingTest, TakesParentsWhoseChildrenWentFirst) {
    // Without its children a parent is in a table that was gone through already.
    World world;
    world.create_with(Position{});
    const Entity child = world.create_with(Position{});
    const Entity parent = world.create_with(Position{});
    world.set_parent(child, parent);
    world.destroy_matching(world.query<const Position>());
    EXPECT_EQ(world.size(), 0u);
}

TEST(DestroyMatchingTest, LeavesParentsThatDoNotMatch) {
    World world;
    const Entity parent = world.create_with(Speed{});
    for (int i = 0; i < 3; ++i) world.set_parent(world.create_with(Position{}), parent);
    const Entity last = world.create_with(Speed{});
    world.set_parent(last, parent);
    world.destroy_matching(world.query<const Position>());
    EXPECT_THAT(world.children(parent), ElementsAre(last));
    world.destroy_matching(world.query<const Parent>());
    EXPECT_FALSE(world.has<Children>(parent));
    EXPECT_EQ(world.size(), 1u);
}

TEST(DestroyMatchingTest, SparseComponentsGoToo) {
    World world;
    for (int i = 0; i < 1000; ++i) world.create_with(Heat{}, Position{});
    const Entity stays = world.create_with(Heat{});
    world.destroy_matching(world.query<const Position>());
    EXPECT_EQ(world.query<const Heat>().count(), 1u);
    world.destroy_matching(world.query<const Heat>());
    EXPECT_FALSE(world.alive(stays));
    EXPECT_EQ(world.create_with(Position{}).index, stays.index);
    EXPECT_TRUE(world.query<const Heat>().empty());
}

TEST(DestroyMatchingTest, ObserversMayAskTheSameQuery) {
    World world;
    const auto query = world.query<const Position>();
    std::size_t most = 0;
    world.on_remove<Position>([&](World&, Entity entity) {
        EXPECT_TRUE(query.contains(entity));
        most = std::max(most, query.count());
    });
    for (int i = 0; i < 10; ++i) {
        const Entity parent = world.create_with(Position{}, Speed{});
        for (int k = 0; k < 3; ++k) world.set_parent(world.create_with(Position{}, Label{}), parent);
    }
    world.destroy_matching(query);
    EXPECT_EQ(most, 40u);
    EXPECT_EQ(world.size(), 0u);
}

} // namespace
} // namespace hachure
