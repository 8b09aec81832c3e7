// Components of every size, alignment and storage.

#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using namespace test;

/// A member of that name says nothing about how a component is kept.
struct Shelf {
    int storage = 3;
};
static_assert(Component<Shelf> && storage_of<Shelf> == Storage::table);

struct InTable {};
struct Sparse {
    static constexpr auto storage = Storage::sparse;
};
static_assert(storage_of<InTable> == Storage::table && storage_of<Sparse> == Storage::sparse);

template <std::size_t bytes, std::size_t alignment, class Kind> struct alignas(alignment) Sized : Kind {
    std::array<std::uint8_t, bytes> values{};

    static Sized make(std::size_t n) {
        Sized result;
        for (std::size_t i = 0; i < bytes; ++i) result.values[i] = static_cast<std::uint8_t>(n + i);
        return result;
    }
    bool made_from(std::size_t n) const {
        for (std::size_t i = 0; i < bytes; ++i)
            if (values[i] != static_cast<std::uint8_t>(n + i)) return false;
        return reinterpret_cast<std::uintptr_t>(this) % alignment == 0;
    }
};

template <class C> class ComponentStorageTest : public testing::Test {};
using Shapes =
    testing::Types<Sized<1, 1, InTable>, Sized<7, 1, InTable>, Sized<12, 4, InTable>, Sized<20, 4, InTable>,
                   Sized<33, 1, InTable>, Sized<1, 32, InTable>, Sized<100, 64, InTable>, Sized<16'300, 4, InTable>,
                   Sized<40'000, 64, InTable>, Sized<9, 1, Sparse>, Sized<1, 64, Sparse>, Sized<5000, 8, Sparse>>;
TYPED_TEST_SUITE(ComponentStorageTest, Shapes);

TYPED_TEST(ComponentStorageTest, KeepItsBytes) {
    using C = TypeParam;
    World world;
    std::vector<Entity> entities;
    const std::size_t count = sizeof(C) > 4000 ? 60 : 900;
    for (std::size_t i = 0; i < count; ++i) {
        // One after another and in tables of their own, beside others and alone.
        const Entity entity = i % 2 ? world.create_with(C::make(i), Label{std::to_string(i)}) : world.create();
        if (i % 2 == 0) world.add(entity, C::make(i));
        if (i % 3 == 0) world.add(entity, Position{double(i), 0});
        if (i % 7 == 0) world.remove<Label>(entity);
        entities.push_back(entity);
    }
    std::mt19937 random(1);
    std::vector<bool> gone(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t n = random() % count;
        if (i % 3) {
            world.destroy(entities[n]);
        } else {
            world.remove<C>(entities[n]);
        }
        gone[n] = true;
    }
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const C* found = world.find<C>(entities[i]);
        ASSERT_EQ(found == nullptr, gone[i]);
        if (found) {
            ASSERT_TRUE(found->made_from(i)) << i;
        }
        left += found ? 1 : 0;
        if (const Label* label = world.find<Label>(entities[i])) {
            ASSERT_EQ(label->text, std::to_string(i));
        }
        if (const Position* position = world.find<Position>(entities[i])) {
            ASSERT_EQ(position->x, double(i));
        }
    }
    EXPECT_EQ(world.query<const C>().count(), left);
}

TYPED_TEST(ComponentStorageTest, ComesInBulk) {
    using C = TypeParam;
    World world;
    const std::size_t count = sizeof(C) > 4000 ? 40 : 5000;
    const auto copies = world.create_many(count, C::make(9), Speed{2});
    for (const Entity entity : copies) ASSERT_TRUE(world.get<C>(entity).made_from(9));
    std::vector<Entity> made;
    world.create_each<C, Speed>(count, [&](std::size_t i, Entity entity, C& value, Speed& speed) {
        value = C::make(i);
        speed.value = double(i);
        made.push_back(entity);
    });
    ASSERT_EQ(made.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(world.get<C>(made[i]).made_from(i));
        ASSERT_EQ(world.get<Speed>(made[i]).value, double(i));
    }
    EXPECT_EQ(world.query<const C>().count(), 2 * count);
}

} // namespace
} // namespace hachure
