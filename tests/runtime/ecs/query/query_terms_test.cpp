// Every kind of term, for components in tables and sparse ones, over a world that has every mixture of them.

#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>
#include <hachure/tests/runtime/ecs/thread_limit.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;

template <class... Terms> using ItemOf = typename Query<Terms...>::Item;
static_assert(std::is_same_v<ItemOf<AnyOf<Position, const Heat>>, std::tuple<Entity, Position*, const Heat*>>);
static_assert(std::is_same_v<ItemOf<OfParent<const Heat>>, std::tuple<Entity, const Heat&>>);
static_assert(std::is_same_v<ItemOf<Optional<OfParent<const Speed>>>, std::tuple<Entity, const Speed*>>);
static_assert(std::is_same_v<ItemOf<With<Heat>, Without<Chosen>, Heat>, std::tuple<Entity, Heat&>>);
static_assert(!Query<OfParent<const Heat>, AnyOf<const Heat, const Speed>, With<Heat>>::writes);
static_assert(Query<AnyOf<const Heat, Speed>>::writes && Query<Optional<Heat>>::writes);

/// What nobody has.
struct Unheard {
    static constexpr auto storage = Storage::sparse;
    int value = 0;
};

class QueryTermsTest : public testing::Test {
protected:
    World world;
    std::vector<Entity> all; ///< in ascending order

    /// Two entities for each set of six components; a third of them have a parent.
    QueryTermsTest() {
        for (unsigned i = 0; i < 128; ++i) {
            const Entity entity = world.create();
            const double value = i;
            if (i & 1) world.add(entity, Position{value, 0});
            if (i & 2) world.add(entity, Label{std::to_string(i)});
            if (i & 4) world.add(entity, Hidden{});
            if (i & 8) world.add(entity, Heat{value});
            if (i & 16) world.add(entity, Note{std::to_string(i)});
            if (i & 32) world.add(entity, Chosen{});
            all.push_back(entity);
            if (i % 3 == 2) world.set_parent(entity, all[i * 7 % (i - 1)]);
        }
    }

    template <class C> auto has() const {
        return [this](Entity entity) { return world.has<C>(entity); };
    }
    template <class C> auto parent_has() const {
        return [this](Entity entity) { return world.has<C>(world.parent(entity)); };
    }

    /// All ways to ask the query agree that it matches those for which all of `conditions` hold.
    template <class... Terms, class... Conditions> void expect_matches(Conditions... conditions) {
        const Query<Terms...> query = world.query<Terms...>();
        std::vector<Entity> expected;
        for (const Entity entity : all) {
            const bool matches = (conditions(entity) && ...);
            if (matches) expected.push_back(entity);
            EXPECT_EQ(query.contains(entity), matches);
            const auto found = query.find(entity);
            ASSERT_EQ(found.has_value(), matches);
            if (found) {
                EXPECT_EQ(std::get<0>(*found), entity);
            }
        }
        std::vector<Entity> walked;
        for (auto it = query.begin(); it != query.end(); ++it) {
            EXPECT_EQ(std::get<0>(*it), it.entity());
            walked.push_back(it.entity());
        }
        EXPECT_EQ(query.count(), expected.size());
        EXPECT_EQ(query.empty(), expected.empty());
        EXPECT_EQ(query.first(), walked.empty() ? Entity::null : walked.front());
        std::vector<Entity> by_each;
        query.each([&](Entity entity, auto&&...) { by_each.push_back(entity); });
        EXPECT_EQ(by_each, walked);
        std::ranges::sort(walked);
        EXPECT_EQ(walked, expected);
        EXPECT_EQ(sorted_by_entity(query), expected);
        EXPECT_EQ(by_parallel_each(query), expected);
        EXPECT_FALSE(query.contains(Entity::null));
        EXPECT_FALSE(query.find({0, 99}));
    }

private:
    template <class Q> static std::vector<Entity> sorted_by_entity(const Q& query) {
        std::vector<Entity> result;
        for (const auto& item : query.sorted([](Entity entity, auto&&...) { return entity; }))
            result.push_back(std::get<0>(item));
        return result;
    }
    template <class Q> static std::vector<Entity> by_parallel_each(const Q& query) {
        const ThreadLimit limit(4);
        std::mutex mutex;
        std::vector<Entity> result;
        query.parallel_each([&](Entity entity, auto&&...) {
            const std::scoped_lock lock(mutex);
            result.push_back(entity);
        });
        std::ranges::sort(result);
        return result;
    }
};

template <class F> auto negate(F f) {
    return [f](Entity entity) { return !f(entity); };
}
template <class F, class G> auto either(F f, G g) {
    return [f, g](Entity entity) { return f(entity) || g(entity); };
}

TEST_F(QueryTermsTest, FetchSparseComponents) {
    expect_matches<const Heat>(has<Heat>());
    expect_matches<Heat>(has<Heat>());
    expect_matches<Heat, const Chosen, Note>(has<Heat>(), has<Chosen>(), has<Note>());
    expect_matches<Heat, const Position>(has<Heat>(), has<Position>());
    expect_matches<Position, const Chosen>(has<Position>(), has<Chosen>());
    expect_matches<const Heat, const Label, const Position>(has<Heat>(), has<Label>(), has<Position>());
}

TEST_F(QueryTermsTest, RequireAndExclude) {
    expect_matches<With<Heat>>(has<Heat>());
    expect_matches<With<Heat, Position>>(has<Heat>(), has<Position>());
    expect_matches<With<Position, Label>, Without<Hidden>>(has<Position>(), has<Label>(), negate(has<Hidden>()));
    expect_matches<Without<Heat>>(negate(has<Heat>()));
    expect_matches<Without<Heat, Chosen, Hidden>>(negate(has<Heat>()), negate(has<Chosen>()), negate(has<Hidden>()));
    expect_matches<Position, With<Chosen>, Without<Note>>(has<Position>(), has<Chosen>(), negate(has<Note>()));
    expect_matches<Heat, With<Chosen, Hidden>>(has<Heat>(), has<Chosen>(), has<Hidden>());
    expect_matches<With<Heat>, Without<Heat>>(has<Heat>(), negate(has<Heat>()));
}

TEST_F(QueryTermsTest, WhatNobodyHas) {
    const auto never = [](Entity) { return false; };
    expect_matches<const Speed>(never);
    expect_matches<With<Speed>, const Heat>(never);
    expect_matches<AnyOf<Speed>>(never);
    expect_matches<OfParent<const Speed>>(never);
    expect_matches<Without<Speed>, const Heat>(has<Heat>());
    expect_matches<Unheard>(never);
    expect_matches<With<Unheard>, const Position>(never);
    expect_matches<AnyOf<const Unheard>>(never);
    expect_matches<AnyOf<const Unheard, Position>>(has<Position>());
    expect_matches<OfParent<const Unheard>>(never);
    expect_matches<Without<Unheard>>();
    expect_matches<Optional<Unheard>>();
    expect_matches<>();
}

TEST_F(QueryTermsTest, OptionalNeverExcludes) {
    expect_matches<Optional<Heat>>();
    expect_matches<Optional<const Position>>();
    expect_matches<Optional<Heat>, Optional<Position>, const Chosen>(has<Chosen>());
    expect_matches<Optional<const Chosen>, Position>(has<Position>());
    expect_matches<Optional<OfParent<const Heat>>>();
    expect_matches<Optional<OfParent<const Position>>, const Heat>(has<Heat>());
}

TEST_F(QueryTermsTest, AnyOfWantsOne) {
    expect_matches<AnyOf<Position>>(has<Position>());
    expect_matches<AnyOf<Position, const Label>>(either(has<Position>(), has<Label>()));
    expect_matches<AnyOf<const Heat>>(has<Heat>());
    expect_matches<AnyOf<Heat, const Chosen>>(either(has<Heat>(), has<Chosen>()));
    expect_matches<AnyOf<Heat, Position>>(either(has<Heat>(), has<Position>()));
    expect_matches<AnyOf<const Position, const Note>, AnyOf<const Label, const Chosen>, Without<Hidden>>(
        either(has<Position>(), has<Note>()), either(has<Label>(), has<Chosen>()), negate(has<Hidden>()));
    expect_matches<AnyOf<const Heat, const Chosen>, const Note>(either(has<Heat>(), has<Chosen>()), has<Note>());
}

TEST_F(QueryTermsTest, OfParentLooksOneUp) {
    expect_matches<OfParent<const Position>>(parent_has<Position>());
    expect_matches<OfParent<const Heat>>(parent_has<Heat>());
    expect_matches<OfParent<const Heat>, OfParent<const Label>>(parent_has<Heat>(), parent_has<Label>());
    expect_matches<OfParent<const Position>, Position>(parent_has<Position>(), has<Position>());
    expect_matches<OfParent<const Chosen>, Heat, Without<Note>>(parent_has<Chosen>(), has<Heat>(), negate(has<Note>()));
    expect_matches<OfParent<const Parent>>([this](Entity entity) { return bool(world.parent(world.parent(entity))); });
    expect_matches<OfParent<const Children>>([this](Entity entity) { return bool(world.parent(entity)); });
}

TEST_F(QueryTermsTest, ReferencesLeadToTheEntitysOwnComponents) {
    for (auto [entity, position, heat, note, label] :
         world.query<const Position, Heat, Optional<Note>, AnyOf<const Label>>()) {
        EXPECT_EQ(&position, world.find<Position>(entity));
        EXPECT_EQ(&heat, world.find<Heat>(entity));
        EXPECT_EQ(note, world.find<Note>(entity));
        EXPECT_EQ(label, world.find<Label>(entity));
        EXPECT_EQ(heat.value, position.x);
    }
    for (auto [entity, position, heat] : world.query<AnyOf<Position, const Heat>>()) {
        EXPECT_EQ(position, world.find<Position>(entity));
        EXPECT_EQ(heat, world.find<Heat>(entity));
    }
    for (auto [entity, heat, label] : world.query<OfParent<const Heat>, Optional<OfParent<const Label>>>()) {
        EXPECT_EQ(&heat, world.find<Heat>(world.parent(entity)));
        EXPECT_EQ(label, world.find<Label>(world.parent(entity)));
    }
    for (auto [entity, label] : world.query<Optional<OfParent<const Label>>>())
        EXPECT_EQ(label, world.find<Label>(world.parent(entity)));
    for (const Entity entity : all) {
        const auto found = world.query<const Heat, Optional<OfParent<const Note>>>().find(entity);
        if (!found) continue;
        EXPECT_EQ(&std::get<1>(*found), world.find<Heat>(entity));
        EXPECT_EQ(std::get<2>(*found), world.find<Note>(world.parent(entity)));
    }
}

TEST_F(QueryTermsTest, ARareSparseComponentLeadsTheWalk) {
    // More entities than matches by far: the walk goes through the sparse store.
    world.create_many(5000, Position{}, Hidden{});
    const auto position = has<Position>();
    const auto heat = has<Heat>();
    expect_matches<const Position, Heat>(position, heat);
    expect_matches<Optional<Position>, With<Heat, Chosen>>(heat, has<Chosen>());
    expect_matches<const Hidden, Heat, Without<Label>, AnyOf<const Position, Note>>(
        has<Hidden>(), heat, negate(has<Label>()), either(position, has<Note>()));
    expect_matches<const Heat, OfParent<const Heat>>(heat, parent_has<Heat>());
}

TEST_F(QueryTermsTest, AKeptQuerySeesNewTablesAndNewComponents) {
    World fresh;
    const auto heats = fresh.query<const Heat>();
    const auto mixed = fresh.query<const Heat, const Position>();
    const auto none = fresh.query<Without<Heat>, const Position>();
    EXPECT_TRUE(heats.empty() && mixed.empty() && none.empty());
    const Entity first = fresh.create_with(Position{});
    EXPECT_EQ(none.first(), first);
    fresh.add(first, Heat{});
    EXPECT_TRUE(heats.contains(first) && mixed.contains(first) && none.empty());
    const Entity second = fresh.create_with(Heat{}, Label{}, Position{});
    EXPECT_EQ(mixed.count(), 2u);
    EXPECT_TRUE(mixed.find(second));
    fresh.remove<Position>(second);
    EXPECT_EQ(mixed.count(), 1u);
    EXPECT_EQ(heats.count(), 2u);
}

TEST_F(QueryTermsTest, SortsStablyByWhatWasFetched) {
    // Three values, in the order of the walk among equals.
    const auto query = world.query<const Heat, Optional<const Position>>();
    std::vector<Entity> walked;
    query.each([&](Entity entity, auto&&...) { walked.push_back(entity); });
    const auto key = [](const Heat& heat, const Position*) { return static_cast<int>(heat.value) % 3; };
    std::ranges::stable_sort(walked, {}, [&](Entity entity) { return key(world.get<Heat>(entity), nullptr); });
    std::vector<Entity> by_query;
    for (const auto& [entity, heat, position] : query.sorted(key)) {
        EXPECT_EQ(&heat, world.find<Heat>(entity));
        EXPECT_EQ(position, world.find<Position>(entity));
        by_query.push_back(entity);
    }
    EXPECT_EQ(by_query, walked);
    EXPECT_TRUE(world.query<const Speed>().sorted([](const Speed& speed) { return speed.value; }).empty());
}

TEST_F(QueryTermsTest, SortsByKeysThatOwnMemory) {
    std::vector<std::string> texts;
    for (const auto& [entity, note] : world.query<const Note>().sorted([](const Note& n) { return n.text; }))
        texts.push_back(note.text);
    EXPECT_EQ(texts.size(), 64u);
    EXPECT_TRUE(std::ranges::is_sorted(texts));
}

TEST_F(QueryTermsTest, ChunksGiveSpans) {
    std::vector<Entity> seen;
    const auto query = world.query<Position, Optional<const Label>, With<Hidden>, AnyOf<const Label, const Parent>>();
    query.each_chunk([&](std::span<const Entity> entities, std::span<Position> positions, std::span<const Label> labels,
                         std::span<const Label> again, std::span<const Parent> parents) {
        ASSERT_FALSE(entities.empty()) << "an empty chunk is no run";
        EXPECT_EQ(positions.size(), entities.size());
        EXPECT_EQ(labels.size(), again.size());
        EXPECT_FALSE(again.empty() && parents.empty());
        const bool labelled = world.has<Label>(entities[0]);
        EXPECT_EQ(labels.size(), labelled ? entities.size() : 0);
        for (std::size_t i = 0; i < entities.size(); ++i) {
            EXPECT_EQ(&positions[i], world.find<Position>(entities[i]));
            if (labelled) {
                EXPECT_EQ(&labels[i], world.find<Label>(entities[i]));
            }
            if (!parents.empty()) {
                EXPECT_EQ(&parents[i], world.find<Parent>(entities[i]));
            }
            seen.push_back(entities[i]);
        }
    });
    std::ranges::sort(seen);
    std::vector<Entity> walked;
    query.each([&](Entity entity, auto&&...) { walked.push_back(entity); });
    std::ranges::sort(walked);
    EXPECT_EQ(seen, walked);
    EXPECT_FALSE(seen.empty());
}

TEST_F(QueryTermsTest, WritesReachTheComponents) {
    world.query<Heat, Optional<Note>, AnyOf<Position, Label>>().each(
        [](Heat& heat, Note* note, Position* position, Label* label) {
            heat.value = -1;
            if (note) note->text = "written";
            if (position) position->y = 7;
            if (label) label->text = "seen";
        });
    for (const Entity entity : all) {
        const bool visited = world.has<Heat>(entity) && (world.has<Position>(entity) || world.has<Label>(entity));
        if (const Heat* heat = world.find<Heat>(entity)) {
            EXPECT_EQ(heat->value == -1, visited);
        }
        if (const Note* note = world.find<Note>(entity)) {
            EXPECT_EQ(note->text == "written", visited);
        }
        if (const Position* position = world.find<Position>(entity)) {
            EXPECT_EQ(position->y == 7, visited);
        }
        if (const Label* label = world.find<Label>(entity)) {
            EXPECT_EQ(label->text == "seen", visited);
        }
    }
}

} // namespace
} // namespace hachure
