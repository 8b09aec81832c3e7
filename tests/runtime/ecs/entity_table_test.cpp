#include <hachure/runtime/ecs/entity_table.h>

#include <gtest/gtest.h>

#include <unordered_set>
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

TEST(EntityTableDeathTest, EndsAnEntityOnce) {
    detail::EntityTable table;
    const Entity entity = live(table);
    table.release(entity);
    EXPECT_DEATH(table.release(entity), "ends once");
    EXPECT_DEATH(table.activate(entity, {0, 0}), "becomes alive");
}

} // namespace
} // namespace hachure
