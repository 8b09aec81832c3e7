// Walks on several threads leave the same bits and the same marks as walks on one.

#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>
#include <hachure/tests/runtime/ecs/thread_limit.h>

#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

namespace hachure {
namespace {

using namespace test;

constexpr std::size_t entity_count = 20'000;

/// One of two worlds that were built by the same calls.
struct Twin {
    World world;
    std::vector<Entity> all;

    Twin() {
        world.create_each<Position, Speed>(entity_count, [&](std::size_t i, Entity entity, Position& position, Speed& speed) {
            position = {std::sin(double(i)), std::cos(double(i))};
            speed.value = 1.0 / double(i + 1);
            all.push_back(entity);
        });
        for (std::size_t i = 0; i < entity_count; i += 3) world.add(all[i], Label{"third"});
        for (std::size_t i = 0; i < entity_count; i += 4) world.add(all[i], Heat{double(i)});
        for (std::size_t i = 0; i < entity_count; i += 7) world.remove<Speed>(all[i]);
        world.advance_tick();
        for (std::size_t i = 0; i < entity_count; i += 11) world.get_mutable<Position>(all[i]);
        world.advance_tick();
    }
};

class QueryParallelTest : public testing::TestWithParam<int> {
protected:
    ThreadLimit limit{GetParam()};
    Twin one, many;

    template <class C> void expect_same_ticks(Entity entity) {
        ASSERT_EQ(one.world.has<C>(entity), many.world.has<C>(entity));
        if (!one.world.has<C>(entity)) return;
        ASSERT_EQ(one.world.changed_tick<C>(entity), many.world.changed_tick<C>(entity));
        ASSERT_EQ(one.world.added_tick<C>(entity), many.world.added_tick<C>(entity));
    }
    void expect_same() {
        const auto same = [](double a, double b) {
            return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
        };
        ASSERT_EQ(one.all, many.all);
        for (const Entity entity : one.all) {
            const auto& a = one.world.get<Position>(entity);
            const auto& b = many.world.get<Position>(entity);
            ASSERT_TRUE(same(a.x, b.x) && same(a.y, b.y));
            if (const Heat* heat = one.world.find<Heat>(entity)) {
                ASSERT_TRUE(same(heat->value, many.world.get<Heat>(entity).value));
            }
            expect_same_ticks<Position>(entity);
            expect_same_ticks<Speed>(entity);
            expect_same_ticks<Label>(entity);
            expect_same_ticks<Heat>(entity);
        }
        ASSERT_EQ(changed(one), changed(many)) << "in the same order, too";
        EXPECT_EQ(one.world.last_changed<Position>(), many.world.last_changed<Position>());
        EXPECT_EQ(one.world.last_changed<Heat>(), many.world.last_changed<Heat>());
    }
    static std::vector<Entity> changed(Twin& twin) {
        std::vector<Entity> result;
        const auto query = twin.world.query<const Position>().changed_since<Position, Heat>(twin.world.tick() - 1);
        query.each([&](Entity entity, const Position&) { result.push_back(entity); });
        return result;
    }
};
INSTANTIATE_TEST_SUITE_P(Threads, QueryParallelTest, testing::Values(1, 2, 4));

void turn(Position& position, double by) {
    position = {position.x * std::cos(by) - position.y * std::sin(by),
                position.x * std::sin(by) + position.y * std::cos(by)};
}

TEST_P(QueryParallelTest, PlainWalks) {
    const auto f = [](Position& position, const Speed* speed) { turn(position, speed ? speed->value : 0.25); };
    one.world.query<Position, Optional<const Speed>>().each(f);
    many.world.query<Position, Optional<const Speed>>().parallel_each(f);
    expect_same();
}

TEST_P(QueryParallelTest, WholeChunks) {
    const auto f = [](std::span<const Entity> entities, std::span<Position> positions, std::span<const Label> labels) {
        for (std::size_t i = 0; i < entities.size(); ++i)
            turn(positions[i], entities[i].index + static_cast<double>(labels.size()));
    };
    const auto query = [](Twin& twin) { return twin.world.query<Position, Optional<const Label>, With<Speed>>(); };
    query(one).each_chunk(f);
    query(many).parallel_each_chunk(f);
    expect_same();
}

TEST_P(QueryParallelTest, SparseComponentsAndFilters) {
    const auto f = [](Entity entity, Position& position, Heat* heat) {
        turn(position, entity.index);
        if (heat) heat->value += position.x;
    };
    const auto query = [](Twin& twin) {
        return twin.world.query<Position, Optional<Heat>>().changed_since<Position>(1);
    };
    query(one).each(f);
    query(many).parallel_each(f);
    expect_same();
    const auto g = [](Heat& heat, Position& position) { turn(position, heat.value); };
    one.world.query<Heat, Position, Without<Label>>().each(g);
    many.world.query<Heat, Position, Without<Label>>().parallel_each(g);
    expect_same();
}

TEST_P(QueryParallelTest, EachMatchOnce) {
    std::vector<std::atomic<int>> visits(entity_count);
    const auto expect_once = [&](std::size_t of) {
        std::size_t visited = 0;
        for (auto& visit : visits) {
            ASSERT_LE(visit.load(), 1);
            visited += static_cast<std::size_t>(visit.exchange(0));
        }
        EXPECT_EQ(visited, of);
    };
    const auto visit = [&](Entity entity, auto&&...) { ++visits[entity.index]; };
    const auto plain = many.world.query<const Position, With<Speed>>();
    plain.parallel_each(visit);
    expect_once(plain.count());
    const auto by_row = many.world.query<const Position, With<Heat>>();
    by_row.parallel_each(visit);
    expect_once(by_row.count());
    many.world.query<const Position>().parallel_each_chunk([&](std::span<const Entity> entities, auto&&...) {
        for (const Entity entity : entities) visit(entity);
    });
    expect_once(entity_count);
    many.world.query<const Position, const Children>().parallel_each(visit);
    expect_once(0);
}

TEST_P(QueryParallelTest, AnExceptionComesOutAndUnlocks) {
    const auto thrower = [](Entity entity, auto&&...) {
        if (entity.index == entity_count / 2) throw std::runtime_error("left");
    };
    EXPECT_THROW(many.world.query<const Position>().parallel_each(thrower), std::runtime_error);
    EXPECT_THROW((many.world.query<const Position, Optional<const Heat>>().parallel_each(thrower)), std::runtime_error);
    many.world.create();
}

using QueryParallelDeathTest = QueryParallelTest;
INSTANTIATE_TEST_SUITE_P(Threads, QueryParallelDeathTest, testing::Values(1));

TEST_P(QueryParallelDeathTest, StructuralChangesAssert) {
    EXPECT_DEATH(many.world.query<const Position>().parallel_each(
                     [&](Entity entity, const Position&) { many.world.destroy(entity); }),
                 "keeps its structure");
    EXPECT_DEATH(many.world.query<const Position>().each_chunk([&](auto&&...) { many.world.create(); }),
                 "keeps its structure");
}

} // namespace
} // namespace hachure
