// Many types of components, and many mixtures of them, in one world.

#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using namespace test;

struct NumberedInTable {};
struct NumberedSparse {
    static constexpr auto storage = Storage::sparse;
};

/// One of many types.
template <std::size_t number, class Kind> struct Numbered : Kind { std::uint32_t value = number; };

template <class Kind, class F, std::size_t... i> void for_numbered(F&& f, std::index_sequence<i...>) {
    (f.template operator()<Numbered<i, Kind>>(i), ...);
}

constexpr std::size_t many = 40; ///< of each kind: more than a world makes room for at once

TEST(ManyComponentsTest, WorldsWidenWithTypes) {
    // Each type comes when others are there already: on entities that have all before it, and on new ones.
    World world;
    const Entity all = world.create();
    std::vector<Entity> singles;
    const auto use = [&]<class C>(std::size_t i) {
        const auto n = static_cast<std::uint32_t>(i);
        EXPECT_EQ(world.find<C>(all), nullptr);
        EXPECT_TRUE(world.query<const C>().empty());
        world.add(all, C{{}, n + 1});
        singles.push_back(world.create_with(C{{}, n + 2}, Label{"single"}));
    };
    for_numbered<NumberedInTable>(use, std::make_index_sequence<many>());
    for_numbered<NumberedSparse>(use, std::make_index_sequence<many>());
    std::size_t next = 0;
    const auto check = [&]<class C>(std::size_t i) {
        const auto n = static_cast<std::uint32_t>(i);
        EXPECT_EQ(world.get<C>(all).value, n + 1);
        EXPECT_EQ(world.get<C>(singles[next++]).value, n + 2);
        EXPECT_EQ(world.query<const C>().count(), 2u);
    };
    for_numbered<NumberedInTable>(check, std::make_index_sequence<many>());
    for_numbered<NumberedSparse>(check, std::make_index_sequence<many>());
    // Of the first, one in the middle and the last: a compiler takes a second for the templates of each.
    const auto check_terms = [&]<class C>(std::size_t) {
        EXPECT_EQ((world.query<const C, With<Label>>().count()), 1u);
        EXPECT_TRUE((world.query<const C, Without<Numbered<0, NumberedInTable>>>().count()) <= 1u);
    };
    using Some = std::index_sequence<0, many / 2, many - 1>;
    for_numbered<NumberedInTable>(check_terms, Some());
    for_numbered<NumberedSparse>(check_terms, Some());
    const Entity copy = world.instantiate(all);
    for_numbered<NumberedInTable>([&]<class C>(std::size_t i) { EXPECT_EQ(world.get<C>(copy).value, i + 1); },
                                  std::make_index_sequence<many>());
    for_numbered<NumberedInTable>([&]<class C>(std::size_t) { EXPECT_TRUE(world.remove<C>(all)); },
                                  std::make_index_sequence<many>());
    EXPECT_EQ((world.get<Numbered<7, NumberedSparse>>(all).value), 8u);
}

TEST(ManyComponentsTest, AThousandTables) {
    World world;
    constexpr std::size_t bits = 10;
    constexpr std::size_t sets = 1 << bits;
    std::vector<Entity> entities;
    const auto kept = world.query<const Numbered<3, NumberedInTable>, Without<Numbered<5, NumberedInTable>>>();
    for (std::size_t set = 0; set < 3 * sets; ++set) {
        const Entity entity = world.create();
        for_numbered<NumberedInTable>(
            [&]<class C>(std::size_t i) {
                if (set >> i & 1) world.add(entity, C{{}, static_cast<std::uint32_t>(set)});
            },
            std::make_index_sequence<bits>());
        entities.push_back(entity);
    }
    for (std::size_t set = 0; set < 3 * sets; ++set)
        for_numbered<NumberedInTable>(
            [&]<class C>(std::size_t i) {
                const C* found = world.find<C>(entities[set]);
                ASSERT_EQ(found != nullptr, (set >> i & 1) != 0);
                if (found) {
                    ASSERT_EQ(found->value, set);
                }
            },
            std::make_index_sequence<bits>());
    EXPECT_EQ(kept.count(), 3 * sets / 4);
    std::size_t visits = 0;
    kept.each([&](const auto&) { ++visits; });
    EXPECT_EQ(visits, 3 * sets / 4);
    EXPECT_EQ((world.query<AnyOf<Numbered<0, NumberedInTable>, Numbered<1, NumberedInTable>>>().count()),
              3 * sets * 3 / 4);
    world.destroy_matching(kept);
    EXPECT_EQ(world.size(), 3 * sets * 3 / 4);
}

TEST(ManyComponentsTest, IterationIsCompleteUnderChurn) {
    // Chunks merge all the while; every entity is met once.
    World world;
    std::mt19937 random(3);
    std::vector<Entity> entities = world.create_many(20'000, Position{}, Label{"x"});
    std::ranges::shuffle(entities, random);
    while (!entities.empty()) {
        const std::size_t drop = std::min<std::size_t>(entities.size(), 1 + entities.size() / 3);
        for (std::size_t i = 0; i < drop; ++i) {
            if (i % 2) {
                world.destroy(entities.back());
            } else {
                world.remove<Label>(entities.back());
            }
            entities.pop_back();
        }
        std::vector<Entity> seen;
        for (auto [entity, position, label] : world.query<const Position, const Label>()) seen.push_back(entity);
        std::vector<Entity> expected = entities;
        std::ranges::sort(seen);
        std::ranges::sort(expected);
        ASSERT_EQ(seen, expected);
    }
}

} // namespace
} // namespace hachure
