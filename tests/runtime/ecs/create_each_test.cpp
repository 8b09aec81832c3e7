#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/sparse_components.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace hachure {
namespace {

using namespace test;

/// Makes `count` entities, and throws before number `last` is told.
template <class... C> std::vector<Entity> create_until(World& world, std::size_t count, std::size_t last) {
    std::vector<Entity> made;
    EXPECT_THROW(world.create_each<C...>(count,
                                         [&](std::size_t i, Entity entity, auto&... values) {
                                             made.push_back(entity);
                                             if (i == last) throw std::runtime_error("left");
                                             ((values.text = std::string(50, 'x')), ...);
                                         }),
                 std::runtime_error);
    return made;
}

template <class... C> void expect_sound_after_an_exception(std::size_t count, std::size_t last) {
    World world;
    const Entity before = world.create_with(C{"before"}...);
    const std::vector<Entity> made = create_until<C...>(world, count, last);
    ASSERT_EQ(made.size(), last + 1);
    // Those that were begun are there, and whole; no others are.
    EXPECT_EQ(world.size(), made.size() + 1);
    EXPECT_EQ((world.query<const C...>().count()), made.size() + 1);
    for (std::size_t i = 0; i < last; ++i) {
        ASSERT_TRUE(((world.get<C>(made[i]).text.size() == 50) && ...));
    }
    EXPECT_TRUE(((world.get<C>(made[last]).text.empty()) && ...));
    EXPECT_TRUE(((world.get<C>(before).text == "before") && ...));
    const Entity next = world.create_with(C{"next"}...);
    EXPECT_TRUE(((world.get<C>(next).text == "next") && ...));
    EXPECT_TRUE(((world.query<const C>().template added_since<C>(0).count() == made.size() + 2) && ...));
    world.destroy_many(made);
    EXPECT_EQ(world.size(), 2u);
}

TEST(CreateEachTest, AnExceptionLeavesTheWorldSound) {
    for (const std::size_t last : {0, 1, 57, 99}) expect_sound_after_an_exception<Label>(100, last);
    for (const std::size_t last : {0, 57, 4000, 4999}) expect_sound_after_an_exception<Label>(5000, last);
    for (const std::size_t last : {0, 57, 99}) expect_sound_after_an_exception<Note>(100, last);
    for (const std::size_t last : {0, 57, 99}) expect_sound_after_an_exception<Label, Note>(100, last);
}

TEST(CreateEachTest, CommandsMayBeQueued) {
    World world;
    const Entity root = world.create();
    world.create_each<Position>(3000, [&](std::size_t, Entity entity, Position&) {
        world.commands().set_parent(entity, root);
        world.commands().add(entity, Speed{});
    });
    world.apply_commands();
    EXPECT_EQ(world.children(root).size(), 3000u);
    EXPECT_EQ((world.query<const Position, const Speed, const Parent>().count()), 3000u);
}

TEST(CreateEachDeathTest, StructuralChangesAssert) {
    // Rows that follow hold no values yet.
    World world;
    const Entity root = world.create();
    const char* message = "keeps its structure";
    EXPECT_DEATH(
        world.create_each<Label>(9, [&](std::size_t, Entity entity, Label&) { world.set_parent(entity, root); }),
        message);
    EXPECT_DEATH(world.create_each<Label>(9, [&](std::size_t, Entity entity, Label&) { world.destroy(entity); }),
                 message);
    EXPECT_DEATH((world.create_each<Label, Note>(
                     9, [&](std::size_t, Entity entity, Label&, Note&) { world.add(entity, Position{}); })),
                 message);
}

} // namespace
} // namespace hachure
