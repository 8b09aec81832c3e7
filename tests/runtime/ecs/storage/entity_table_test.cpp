#include <hachure/runtime/ecs/storage/entity_table.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <thread>
#include <unordered_set>
#include <utility>
#include <vector>

namespace hachure {
namespace {

Entity live(detail::EntityTable& table) {
    const Entity entity = table.reserve();
    table.activate(entity, {entity.index, 7});
    return entity;
}

TEST(EntityTest, NullIsTheDefaultAndFalse) {
    EXPECT_EQ(Entity{}, Entity::null);
    EXPECT_FALSE(Entity::null);
    EXPECT_TRUE((Entity{0, 1}));
    EXPECT_EQ(to_string(Entity::null), "null");
    EXPECT_EQ(to_string({12, 3}), "12v3");
}

TEST(EntityTest, OrdersByIndexThenGeneration) {
    EXPECT_LT((Entity{1, 9}), (Entity{2, 1}));
    EXPECT_LT((Entity{2, 1}), (Entity{2, 2}));
}

TEST(EntityTest, HashesIndexAndGeneration) {
    const std::unordered_set<Entity> set{{1, 1}, {1, 2}, {2, 1}};
    EXPECT_EQ(set.size(), 3u);
    EXPECT_TRUE(set.contains({1, 2}));
    EXPECT_FALSE(set.contains({2, 2}));
}

TEST(EntityTableTest, ReservedIsNotAlive) {
    detail::EntityTable table;
    const Entity entity = table.reserve();
    EXPECT_TRUE(table.reserved(entity));
    EXPECT_FALSE(table.alive(entity));
    EXPECT_EQ(table.alive_count(), 0u);
    table.activate(entity, {1, 2});
    EXPECT_EQ(table.find(entity), (detail::Location{1, 2}));
    EXPECT_FALSE(table.reserved(entity));
    EXPECT_TRUE(table.alive(entity));
}

TEST(EntityTableTest, ReusesSlotsWithANewGeneration) {
    detail::EntityTable table;
    const Entity first = live(table);
    table.release(first);
    const Entity second = live(table);
    EXPECT_EQ(second.index, first.index);
    EXPECT_EQ(second.generation, first.generation + 1);
    EXPECT_FALSE(table.alive(first));
    EXPECT_TRUE(table.alive(second));
}

TEST(EntityTableTest, KnowsWhereTheLivingAre) {
    detail::EntityTable table;
    std::vector<Entity> entities;
    for (int i = 0; i < 10; ++i) entities.push_back(live(table));
    for (const int gone : {0, 9, 4}) table.release(entities[gone]);
    table.set_row(entities[5], {99, 3});
    EXPECT_EQ(table.alive_count(), 7u);
    EXPECT_FALSE(table.find(entities[4]));
    EXPECT_EQ(table.find(entities[5]), (detail::Location{99, 3}));
    EXPECT_EQ(table.find(entities[6]), (detail::Location{6, 7}));
}

TEST(EntityTableTest, RestoredIdsGoOnInTheSameWay) {
    detail::EntityTable table;
    std::vector<Entity> entities;
    for (int i = 0; i < 10; ++i) entities.push_back(live(table));
    for (const int gone : {2, 7, 3, 3, 7}) {
        if (!table.alive(entities[gone])) entities[gone] = live(table);
        table.release(entities[gone]);
    }
    detail::EntityTable other;
    live(other);
    other.release({0, 1});
    other.restore(table.ids(), [&](Entity entity) { other.activate(entity, {1, entity.index}); });
    EXPECT_EQ(other.alive_count(), table.alive_count());
    for (const Entity entity : entities) EXPECT_EQ(other.alive(entity), table.alive(entity));
    for (int i = 0; i < 5; ++i) EXPECT_EQ(other.reserve(), table.reserve());
}

TEST(EntityTableTest, ForeignHandlesAreDead) {
    detail::EntityTable table;
    const Entity entity = live(table);
    EXPECT_FALSE(table.alive(Entity::null));
    EXPECT_FALSE(table.alive({entity.index + 1, 1}));
    EXPECT_FALSE(table.alive({entity.index, entity.generation + 1}));
    EXPECT_FALSE(table.alive({entity.index, 0}));
}

TEST(EntityTableTest, APromiseIsReserved) {
    detail::EntityTable table;
    const Entity before = live(table);
    const Entity first = table.promise();
    const Entity second = table.promise();
    EXPECT_NE(first, second);
    EXPECT_TRUE(table.reserved(first) && table.reserved(second));
    EXPECT_FALSE(table.alive(first) || table.alive(second));
    EXPECT_FALSE(table.reserved({second.index + 1, 1})) << "nobody was promised that";
    EXPECT_FALSE(table.reserved({first.index, 2}));
    EXPECT_FALSE(table.reserved(Entity::null));
    EXPECT_EQ(table.alive_count(), 1u);
    table.activate(second, {5, 6});
    EXPECT_TRUE(table.alive(second) && table.reserved(first));
    table.activate(first, {7, 8});
    EXPECT_EQ(table.find(first), (detail::Location{7, 8}));
    EXPECT_EQ(table.find(second), (detail::Location{5, 6}));
    EXPECT_EQ(table.find(before), (detail::Location{before.index, 7}));
    EXPECT_EQ(table.alive_count(), 3u);
}

TEST(EntityTableTest, PromisesAndReservationsGiveTheSameHandles) {
    // In any order of the two, and with slots that are free again.
    std::mt19937 random(1);
    detail::EntityTable table, reference;
    std::vector<Entity> entities;
    for (int step = 0; step < 3000; ++step) {
        if (random() % 3 > 0 || entities.empty()) {
            const Entity expected = reference.reserve();
            ASSERT_EQ(random() % 2 ? table.promise() : table.reserve(), expected);
            entities.push_back(expected);
        } else {
            std::swap(entities[random() % entities.size()], entities.back());
            if (random() % 2 && table.reserved(entities.back())) {
                table.activate(entities.back(), {1, 1});
                reference.activate(entities.back(), {1, 1});
            } else {
                table.release(entities.back());
                reference.release(entities.back());
                entities.pop_back();
            }
        }
        ASSERT_EQ(table.alive_count(), reference.alive_count());
        for (const Entity entity : entities) {
            ASSERT_EQ(table.alive(entity), reference.alive(entity));
            ASSERT_EQ(table.reserved(entity), reference.reserved(entity));
        }
        if (step % 100 != 0) continue;
        ASSERT_EQ(table.ids().generations, reference.ids().generations);
        ASSERT_EQ(table.ids().free, reference.ids().free);
    }
}

TEST(EntityTableTest, PromisesMayBeTakenBack) {
    detail::EntityTable table;
    std::vector<Entity> promised;
    for (int i = 0; i < 1000; ++i) promised.push_back(table.promise());
    for (const Entity entity : promised) table.release(entity);
    EXPECT_EQ(table.alive_count(), 0u);
    for (const Entity entity : promised) EXPECT_FALSE(table.reserved(entity) || table.alive(entity));
    const Entity next = live(table);
    EXPECT_EQ(next, (Entity{promised.back().index, 2}));
}

TEST(EntityTableTest, PromisesAreAmongTheIds) {
    detail::EntityTable table;
    const Entity gone = live(table);
    live(table);
    table.release(gone);
    EXPECT_EQ(table.promise(), (Entity{gone.index, 2}));
    const Entity fresh = table.promise();
    const EntityIds ids = table.ids();
    EXPECT_EQ(ids.generations, (std::vector<std::uint32_t>{2, 1, 1}));
    EXPECT_TRUE(ids.free.empty());
    EXPECT_TRUE(table.reserved(fresh)) << "asking changes nothing";
}

TEST(EntityTableTest, PromisesWriteNothingThatReadersRead) {
    // For the thread sanitizer: one thread looks up what lives and what is dead, another is promised handles.
    detail::EntityTable table;
    std::vector<Entity> alive, dead;
    for (int i = 0; i < 400; ++i) alive.push_back(live(table));
    for (int i = 0; i < 200; ++i) {
        dead.push_back(alive.back());
        table.release(alive.back());
        alive.pop_back();
    }
    std::thread reader([&] {
        for (int round = 0; round < 20; ++round) {
            for (const Entity entity : alive) EXPECT_EQ(table.find(entity).chunk(), entity.index);
            for (const Entity entity : dead) EXPECT_FALSE(table.alive(entity));
            EXPECT_EQ(table.alive_count(), 200u);
        }
    });
    std::vector<Entity> promised;
    for (int i = 0; i < 1000; ++i) promised.push_back(table.promise());
    reader.join();
    for (const Entity entity : promised) table.activate(entity, {entity.index, 7});
    EXPECT_EQ(table.alive_count(), 1200u);
    for (const Entity entity : promised) EXPECT_EQ(table.find(entity).chunk(), entity.index);
}

TEST(EntityTableDeathTest, EndsAnEntityOnce) {
    detail::EntityTable table;
    const Entity entity = live(table);
    table.release(entity);
    EXPECT_DEATH(table.release(entity), "ends once");
    EXPECT_DEATH(table.activate(entity, {0, 0}), "becomes alive");
    const Entity promised = table.promise();
    table.release(promised);
    EXPECT_DEATH(table.release(promised), "ends once");
    EXPECT_DEATH(table.activate({1000, 1}, {0, 0}), "becomes alive");
}

} // namespace
} // namespace hachure
