// Finding changes through the queue and through the sweep: the same entities, whatever has happened.

#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using detail::ChangeWalk;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr std::array ways{ChangeWalk::queue, ChangeWalk::sweep, ChangeWalk::automatic};

/// What the query visits, in ascending order; repeated visits show.
template <class Q> std::vector<Entity> walked(const Q& query, ChangeWalk how) {
    std::vector<Entity> result;
    const Q walk = query.finding_changes(how);
    for (auto it = walk.begin(); it != walk.end(); ++it) result.push_back(it.entity());
    std::ranges::sort(result);
    return result;
}

template <class Q> void expect_walked(const Q& query, std::vector<Entity> expected, const char* what = "") {
    std::ranges::sort(expected);
    for (const ChangeWalk how : ways) {
        EXPECT_EQ(walked(query, how), expected) << what << ", way " << static_cast<int>(how);
        EXPECT_EQ(query.finding_changes(how).count(), expected.size()) << what;
    }
}

TEST(ChangeWalkTest, MarksOfSeveralTicksAreOneVisit) {
    World world;
    const auto entities = world.create_many(100, Position{}, Heat{});
    for (int i = 0; i < 5; ++i) {
        world.advance_tick();
        world.get_mutable<Position>(entities[3]);
        world.get_mutable<Heat>(entities[3]);
        world.get_mutable<Heat>(entities[4]);
        world.get_mutable<Position>(entities[3]);
    }
    for (const Tick since : {1, 2, 4, 5}) {
        expect_walked(world.query<const Position>().changed_since<Position>(since), {entities[3]});
        expect_walked(world.query<const Heat>().changed_since<Heat>(since), {entities[3], entities[4]});
        expect_walked(world.query<>().changed_since<Heat, Position>(since), {entities[3], entities[4]});
        expect_walked(world.query<>().changed_since<Heat>(since).changed_since<Position>(since), {entities[3]});
        expect_walked(world.query<>().added_since<Heat, Position>(since), {});
    }
    expect_walked(world.query<>().changed_since<Heat, Position>(6), {});
}

TEST(ChangeWalkTest, RemovedAndAddedAgainInOneTick) {
    World world;
    const auto entities = world.create_many(100, Position{}, Heat{});
    world.advance_tick();
    for (int i = 0; i < 3; ++i) {
        world.remove<Position>(entities[7]);
        world.add(entities[7], Position{});
        world.remove<Heat>(entities[8]);
        world.add(entities[8], Heat{});
    }
    world.get_mutable<Heat>(entities[9]);
    world.remove<Heat>(entities[9]);
    expect_walked(world.query<>().changed_since<Position>(1), {entities[7]});
    expect_walked(world.query<>().added_since<Heat>(1), {entities[8]});
    expect_walked(world.query<>().changed_since<Heat, Position>(1), {entities[7], entities[8]});
}

TEST(ChangeWalkTest, SlotsThatAreUsedAgain) {
    World world;
    auto entities = world.create_many(100, Position{}, Heat{});
    world.advance_tick();
    for (int i = 0; i < 3; ++i) {
        world.get_mutable<Heat>(entities[5]);
        world.destroy(entities[5]);
        entities[5] = world.create_with(Position{}, Heat{});
    }
    expect_walked(world.query<>().changed_since<Position>(1), {entities[5]});
    expect_walked(world.query<>().changed_since<Heat>(1), {entities[5]});
    expect_walked(world.query<>().added_since<Heat, Position>(1), {entities[5]});
}

TEST(ChangeWalkTest, HandlesThatAreRestoredInTheSameTick) {
    World world;
    const Entity entity = world.create_with(Position{}, Heat{});
    const Entity other = world.create_with(Label{});
    world.restore_entities(world.entity_ids());
    world.add(entity, Position{});
    world.add(entity, Heat{});
    world.add(other, Position{});
    expect_walked(world.query<>().changed_since<Position>(0), {entity, other});
    expect_walked(world.query<>().added_since<Heat>(0), {entity});
    world.advance_tick();
    world.get_mutable<Position>(other);
    world.restore_entities(world.entity_ids());
    world.add(other, Position{});
    expect_walked(world.query<>().changed_since<Position>(1), {other});
    EXPECT_EQ(world.last_changed<Speed>(), 0u);
}

TEST(ChangeWalkTest, MoreChangesThanTheQueueHolds) {
    World world;
    const auto entities = world.create_many(3000, Position{}, Heat{});
    std::vector<Entity> changed;
    for (std::size_t i = 0; i < 600; ++i) {
        if (i % 40 == 0) world.advance_tick();
        world.get_mutable<Position>(entities[i * 5]);
        world.get_mutable<Heat>(entities[i * 5]);
        changed.push_back(entities[i * 5]);
    }
    for (Tick since = 1; since <= world.tick(); ++since) {
        const std::vector<Entity> expected(changed.begin() + static_cast<std::ptrdiff_t>(40 * (since - 1)),
                                           changed.end());
        expect_walked(world.query<const Position>().changed_since<Position>(since), expected);
        expect_walked(world.query<>().changed_since<Heat>(since), expected);
        expect_walked(world.query<const Heat>().changed_since<Heat, Position>(since), expected);
    }
}

TEST(ChangeWalkTest, WalksThatMarkWhatTheyWalk) {
    // Each way on a world of its own.
    for (const ChangeWalk how : ways) {
        World world;
        const auto entities = world.create_many(1000, Position{}, Heat{});
        world.advance_tick();
        for (std::size_t i = 0; i < 1000; i += 100) world.get_mutable<Position>(entities[i]);
        world.advance_tick();
        std::vector<Entity> visited;
        for (auto [entity, position, heat] :
             world.query<Position, Heat>().changed_since<Position, Heat>(1).finding_changes(how)) {
            visited.push_back(entity);
            world.get_mutable<Heat>(entity);
        }
        EXPECT_EQ(visited.size(), 10u);
        std::ranges::sort(visited);
        expect_walked(world.query<>().changed_since<Position>(2), visited, "what was walked is changed");
        expect_walked(world.query<>().changed_since<Heat>(2), visited, "what was walked is changed");
        expect_walked(world.query<>().changed_since<Position>(3), {});
    }
}

TEST(ChangeWalkTest, ChangesBehindTheWalkAreForTheNext) {
    for (const ChangeWalk how : ways) {
        World world;
        const auto entities = world.create_many(500, Position{});
        world.advance_tick();
        world.get_mutable<Position>(entities[400]);
        std::vector<Entity> visited;
        for (auto it = world.query<const Position>().changed_since<Position>(1).finding_changes(how).begin();
             it != std::default_sentinel; ++it) {
            visited.push_back(it.entity());
            world.get_mutable<Position>(entities[2]);
        }
        EXPECT_THAT(visited, ElementsAre(entities[400]));
        expect_walked(world.query<>().changed_since<Position>(1), {entities[2], entities[400]});
    }
}

TEST(ChangeWalkTest, AQueryMayBeKeptOverTicks) {
    World world;
    const auto entities = world.create_many(100, Position{});
    const auto query = world.query<const Position>().changed_since<Position>(1);
    EXPECT_TRUE(query.empty());
    world.advance_tick();
    world.add(entities[1], Label{});
    world.get_mutable<Position>(entities[1]);
    expect_walked(query, {entities[1]});
}

TEST(ChangeWalkTest, AChangeMovesWithItsEntity) {
    World world;
    const auto entities = world.create_many(600, Position{}, Speed{});
    world.advance_tick();
    world.get_mutable<Position>(entities[1]);
    world.get_mutable<Speed>(entities[599]);
    world.advance_tick();
    world.add(entities[1], Label{});
    world.remove<Speed>(entities[1]);
    world.destroy(entities[0]);
    for (std::size_t i = 10; i < 590; ++i) world.destroy(entities[i]); // what is left gathers
    expect_walked(world.query<>().changed_since<Position>(1), {entities[1]});
    expect_walked(world.query<>().changed_since<Speed>(1), {entities[599]});
    expect_walked(world.query<>().changed_since<Position>(2), {});
    expect_walked(world.query<>().added_since<Label>(2), {entities[1]});
}

// Random operations against a map.

enum Kind { position, label, heat, chosen, kinds };

struct Ticks {
    Tick added, changed;
};
using Node = std::array<std::optional<Ticks>, kinds>;

template <class F> void with_kind(int kind, F&& f) {
    switch (kind) {
    case position:
        return f.template operator()<Position>();
    case label:
        return f.template operator()<Label>();
    case heat:
        return f.template operator()<Heat>();
    default:
        return f.template operator()<Chosen>();
    }
}

struct Sizes {
    unsigned seed;
    std::size_t entities;
    int steps;
};

class ChangeWalkRandomTest : public testing::TestWithParam<Sizes> {
protected:
    World world;
    std::map<Entity, Node> model;
    std::vector<Entity> known;
    std::mt19937 random{GetParam().seed};

    std::size_t pick(std::size_t n) { return random() % n; }
    Entity any() { return known.empty() ? Entity::null : known[pick(known.size())]; }

    void put(Entity entity, int kind) {
        auto& cell = model.at(entity)[kind];
        cell = Ticks{cell ? cell->added : world.tick(), world.tick()};
    }
    void remember(Entity entity) {
        model[entity];
        known.push_back(entity);
    }

    void create_some() {
        const std::size_t count = pick(10) == 0 ? pick(GetParam().entities / 2) : 1;
        if (model.size() + count > GetParam().entities) return;
        for (const Entity entity : world.create_many(count, Position{}, Label{})) {
            remember(entity);
            put(entity, position);
            put(entity, label);
        }
        const Entity mixed = world.create_with(Heat{}, Position{}, Chosen{});
        remember(mixed);
        for (const int kind : {position, heat, chosen}) put(mixed, kind);
    }
    void destroy_some() {
        for (std::size_t i = pick(20) == 0 ? pick(GetParam().entities) : 1; i > 0 && !known.empty(); --i) {
            std::swap(known[pick(known.size())], known.back());
            world.destroy(known.back());
            model.erase(known.back());
            known.pop_back();
        }
    }
    void change(Entity entity) {
        const int kind = static_cast<int>(pick(kinds));
        auto& cell = model.at(entity)[kind];
        const std::size_t what = pick(6);
        with_kind(kind, [&]<class C>() {
            if (what == 0) {
                EXPECT_EQ(world.remove<C>(entity), cell.has_value());
                cell.reset();
            } else if (what < 3) {
                world.add(entity, C{});
                put(entity, kind);
            } else if (world.find_mutable<C>(entity)) {
                put(entity, kind);
            }
        });
    }
    /// Walks a while and writes, in any of the ways.
    void walk() {
        const std::size_t most = pick(3) ? pick(20) : model.size();
        std::size_t visits = 0;
        const Tick since = any_tick();
        const ChangeWalk how = ways[pick(3)];
        if (pick(2)) {
            for (auto [entity, a, b] :
                 world.query<Position, Optional<Heat>>().changed_since<Heat, Label>(since).finding_changes(how)) {
                put(entity, position);
                if (b) put(entity, heat);
                if (++visits > most) break;
            }
        } else {
            for (auto [entity, a, b] : world.query<Label, Optional<Position>>()) {
                put(entity, label);
                if (b) put(entity, position);
                if (++visits > most) break;
            }
        }
    }
    /// Mostly a few ticks ago.
    Tick any_tick() {
        const Tick now = world.tick();
        return pick(4) == 0 ? pick(now + 1) : now - std::min<Tick>(now, pick(8));
    }

    template <class Q, class P> void expect_matches(const Q& query, P passes) {
        std::vector<Entity> expected;
        for (const auto& [entity, node] : model)
            if (passes(node)) expected.push_back(entity);
        for (const ChangeWalk how : ways) ASSERT_EQ(walked(query, how), expected) << static_cast<int>(how);
        const Entity entity = any();
        if (entity) {
            ASSERT_EQ(query.contains(entity), passes(model.at(entity)));
        }
    }
    void compare() {
        const Tick a = any_tick(), b = any_tick();
        const auto changed = [](const Node& node, int kind, Tick since) {
            return node[kind] && node[kind]->changed > since;
        };
        const auto added = [](const Node& node, int kind, Tick since) {
            return node[kind] && node[kind]->added > since;
        };
        expect_matches(world.query<>().changed_since<Position>(a),
                       [&](const Node& node) { return changed(node, position, a); });
        expect_matches(world.query<const Heat>().changed_since<Heat>(a),
                       [&](const Node& node) { return changed(node, heat, a); });
        expect_matches(world.query<const Label, Without<Chosen>>().added_since<Chosen, Position, Heat>(a),
                       [&](const Node& node) {
                           return node[label] && !node[chosen] && (added(node, position, a) || added(node, heat, a));
                       });
        expect_matches(world.query<AnyOf<const Heat, const Label>>()
                           .changed_since<Position, Label, Chosen>(a)
                           .added_since<Heat, Label>(b),
                       [&](const Node& node) {
                           return (changed(node, position, a) || changed(node, label, a) || changed(node, chosen, a)) &&
                                  (added(node, heat, b) || added(node, label, b));
                       });
        expect_matches(
            world.query<With<Chosen>, const Position>().changed_since<Heat>(a).changed_since<Position>(b),
            [&](const Node& node) { return node[chosen] && changed(node, heat, a) && changed(node, position, b); });
    }
};
INSTANTIATE_TEST_SUITE_P(Worlds, ChangeWalkRandomTest,
                         testing::Values(Sizes{1, 12, 4000}, Sizes{2, 100, 3000}, Sizes{3, 3000, 1500}));

TEST_P(ChangeWalkRandomTest, BothWaysFindTheSame) {
    for (int step = 0; step < GetParam().steps; ++step) {
        const std::size_t dice = pick(100);
        if (dice < 15) create_some();
        if (dice >= 15 && dice < 25) destroy_some();
        if (dice >= 25 && dice < 85)
            for (std::size_t i = pick(8); i > 0 && !known.empty(); --i) change(any());
        if (dice >= 85 && dice < 90) walk();
        if (dice >= 75) world.advance_tick();
        if (model.size() < 200 || step % 10 == 0) compare();
        if (HasFatalFailure()) FAIL() << "step " << step;
    }
}

} // namespace
} // namespace hachure
