#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

class HierarchyTest : public testing::Test {
protected:
    World world;
    Entity root = world.create();
    Entity a = world.create();
    Entity b = world.create();
    Entity a1 = world.create();
    Entity a2 = world.create();

    void build() {
        world.set_parent(a, root);
        world.set_parent(b, root);
        world.set_parent(a1, a);
        world.set_parent(a2, a);
    }
};

TEST_F(HierarchyTest, RootsAndLeaves) {
    EXPECT_EQ(world.parent(root), Entity::null);
    EXPECT_THAT(world.children(root), IsEmpty());
    EXPECT_EQ(world.parent(Entity::null), Entity::null);
    EXPECT_THAT(world.children(Entity::null), IsEmpty());
    EXPECT_FALSE(world.has<Parent>(root));
    EXPECT_FALSE(world.has<Children>(root));
}

TEST_F(HierarchyTest, KeepsChildrenInOrderOfInsertion) {
    build();
    EXPECT_THAT(world.children(root), ElementsAre(a, b));
    EXPECT_THAT(world.children(a), ElementsAre(a1, a2));
    EXPECT_EQ(world.parent(a2), a);
    EXPECT_EQ(world.get<Parent>(a2).entity, a);
    world.set_parent(a1, root);
    EXPECT_THAT(world.children(root), ElementsAre(a, b, a1));
    EXPECT_THAT(world.children(a), ElementsAre(a2));
    world.set_parent(a, root);
    EXPECT_THAT(world.children(root), ElementsAre(a, b, a1)) << "a child of it already";
}

TEST_F(HierarchyTest, WalksDescendantsParentsFirst) {
    build();
    EXPECT_THAT(world.descendants(root), ElementsAre(a, a1, a2, b));
    std::vector<Entity> seen;
    world.for_each_descendant(root, [&](Entity entity) {
        seen.push_back(entity);
        world.add(entity, Speed{});
    });
    EXPECT_THAT(seen, ElementsAre(a, a1, a2, b));
}

TEST_F(HierarchyTest, ClearingMakesARoot) {
    build();
    world.clear_parent(a1);
    world.clear_parent(a2);
    world.clear_parent(a2);
    world.clear_parent(Entity::null);
    EXPECT_FALSE(world.has<Parent>(a1));
    EXPECT_FALSE(world.has<Children>(a));
    EXPECT_EQ(world.parent(a), root);
}

TEST_F(HierarchyTest, DestroyingTakesDescendantsAlong) {
    build();
    world.add(a2, Speed{});
    EXPECT_TRUE(world.destroy(a));
    EXPECT_FALSE(world.alive(a1));
    EXPECT_FALSE(world.alive(a2));
    EXPECT_EQ(world.size(), 2u);
    EXPECT_THAT(world.children(root), ElementsAre(b));
    EXPECT_THAT(world.removed_since<Speed>(0), ElementsAre(a2));
    world.destroy(b);
    EXPECT_FALSE(world.has<Children>(root));
}

TEST_F(HierarchyTest, RefusesCycles) {
    build();
    EXPECT_THAT([&] { world.set_parent(root, a2); }, ThrowsMessage<HierarchyCycle>(HasSubstr("0v1")));
    EXPECT_THROW(world.set_parent(a, a), HierarchyCycle);
    EXPECT_THROW(world.set_parent(a, a1), HierarchyCycle);
    EXPECT_EQ(world.parent(a), root);
    EXPECT_THAT(world.descendants(root), ElementsAre(a, a1, a2, b));
}

TEST_F(HierarchyTest, RefusesTheDead) {
    world.destroy(a);
    EXPECT_THROW(world.set_parent(a, root), DeadEntity);
    EXPECT_THROW(world.set_parent(root, a), DeadEntity);
    EXPECT_THROW(world.set_parent(root, Entity::null), DeadEntity);
}

TEST_F(HierarchyTest, ReparentingMarksChanged) {
    build();
    const Tick before = world.tick();
    world.advance_tick();
    world.set_parent(a1, a);
    EXPECT_EQ(world.last_changed<Parent>(), before) << "nothing moved";
    world.set_parent(a1, b);
    EXPECT_EQ(world.query<const Parent>().changed_since<Parent>(before).first(), a1);
    EXPECT_EQ(world.query<const Parent>().changed_since<Parent>(before).count(), 1u);
    EXPECT_EQ(world.added_tick<Parent>(a1), before);
    EXPECT_TRUE(world.changed_since<Children>(a, before));
    EXPECT_TRUE(world.changed_since<Children>(b, before));
    EXPECT_FALSE(world.changed_since<Children>(root, before));
    world.clear_parent(a1);
    EXPECT_THAT(world.removed_since<Parent>(before), ElementsAre(a1));
}

TEST_F(HierarchyTest, DeepTreesNeedNoStack) {
    Entity deepest = root;
    std::vector<Entity> chain;
    // Built from the leaf upwards, so that no cycle check has far to walk.
    for (int i = 0; i < 200'000; ++i) {
        const Entity above = world.create();
        world.set_parent(deepest, above);
        chain.push_back(deepest = above);
    }
    EXPECT_EQ(world.descendants(deepest).size(), chain.size());
    world.destroy(deepest);
    EXPECT_FALSE(world.alive(root));
    EXPECT_EQ(world.size(), 4u);
}

} // namespace
} // namespace hachure
