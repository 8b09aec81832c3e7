#include <hachure/runtime/ecs/storage/removal_log.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const Entity a{1, 1}, b{2, 1}, c{3, 1};

TEST(RemovalLogTest, TellsOneComponentFromAnother) {
    detail::RemovalLog log;
    log.note_removed(a, 7, 1);
    log.note_removed(b, 8, 1);
    log.note_removed(c, 7, 1);
    log.note_removed(a, 7, 3);
    EXPECT_THAT(log.since(7, 0), ElementsAre(a, c, a));
    EXPECT_THAT(log.since(8, 0), ElementsAre(b));
    EXPECT_THAT(log.since(7, 1), ElementsAre(a));
    EXPECT_THAT(log.since(7, 3), IsEmpty());
    EXPECT_THAT(log.since(9, 0), IsEmpty());
}

TEST(RemovalLogTest, ForgetsWholeTicks) {
    detail::RemovalLog log;
    log.forget_before(5);
    for (Tick tick = 1; tick <= 4; ++tick) {
        log.note_removed(a, 7, tick);
        log.note_removed(b, 8, tick);
        log.note_removed(c, 7, tick);
    }
    log.forget_before(1);
    EXPECT_EQ(log.since(7, 0).size(), 8u);
    log.forget_before(3);
    EXPECT_THAT(log.since(7, 0), ElementsAre(a, c, a, c));
    EXPECT_THAT(log.since(8, 3), ElementsAre(b));
    log.note_removed(a, 8, 4);
    EXPECT_THAT(log.since(8, 2), ElementsAre(b, b, a));
    log.forget_before(9);
    EXPECT_THAT(log.since(7, 0), IsEmpty());
    log.note_removed(b, 7, 9);
    EXPECT_THAT(log.since(7, 0), ElementsAre(b));
}

TEST(RemovalLogTest, EveryWayToLoseAComponent) {
    World world;
    const auto make = [&] { return world.create_with(Position{}, Heat{}, Chosen{}); };
    const Entity removed = make(), destroyed = make(), child = make(), cleared = make();
    const Entity bare = world.create();
    world.set_parent(child, destroyed);
    world.remove<Heat>(removed);
    world.remove<Position>(removed);
    EXPECT_THAT(world.removed_since<Heat>(0), ElementsAre(removed));
    EXPECT_THAT(world.removed_since<Chosen>(0), IsEmpty());
    world.destroy(destroyed);
    EXPECT_THAT(world.removed_since<Heat>(0), ElementsAre(removed, destroyed, child));
    EXPECT_THAT(world.removed_since<Position>(0), ElementsAre(removed, destroyed, child));
    EXPECT_THAT(world.removed_since<Parent>(0), ElementsAre(child));
    world.advance_tick();
    world.destroy(bare);
    world.clear();
    EXPECT_THAT(world.removed_since<Chosen>(1), UnorderedElementsAre(removed, cleared));
    EXPECT_THAT(world.removed_since<Position>(1), ElementsAre(cleared));
    EXPECT_THAT(world.removed_since<Heat>(1), ElementsAre(cleared));
}

TEST(RemovalLogTest, OncePerLoss) {
    World world;
    const Entity entity = world.create();
    for (int i = 0; i < 3; ++i) {
        world.add(entity, Heat{});
        world.add(entity, Position{});
        world.remove<Heat>(entity);
        world.remove<Position>(entity);
    }
    EXPECT_THAT(world.removed_since<Heat>(0), ElementsAre(entity, entity, entity));
    EXPECT_THAT(world.removed_since<Position>(0), ElementsAre(entity, entity, entity));
}

TEST(RemovalLogTest, RandomlyAsAList) {
    std::mt19937 random(1);
    detail::RemovalLog log;
    std::vector<std::pair<Tick, std::pair<detail::TypeId, Entity>>> all;
    Tick now = 1, forgotten = 0;
    for (int step = 0; step < 4000; ++step) {
        const auto component = static_cast<detail::TypeId>(random() % 3);
        const Entity entity{static_cast<std::uint32_t>(random() % 50), 1};
        log.note_removed(entity, component, now);
        all.push_back({now, {component, entity}});
        if (random() % 5 == 0) ++now;
        if (random() % 100 == 0) {
            forgotten = std::max(forgotten, now - random() % std::min<Tick>(now, 6));
            log.forget_before(forgotten);
        }
        const Tick since = now - random() % std::min<Tick>(now, 12);
        std::vector<Entity> expected;
        for (const auto& [tick, loss] : all)
            if (tick > since && tick >= forgotten && loss.first == component) expected.push_back(loss.second);
        ASSERT_EQ(log.since(component, since), expected) << "step " << step;
    }
}

} // namespace
} // namespace hachure
