#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/runtime/ecs/components.h>
#include <hachure/tests/runtime/ecs/snapshot/snapshot_support.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace hachure::test {
namespace {

using testing::ElementsAre;
using testing::StrEq;
using testing::ThrowsMessage;

void expect_same_future(World& a, World& b) {
    for (int i = 0; i < 50; ++i) ASSERT_EQ(a.create(), b.create());
}

TEST(SnapshotTest, RandomWorldsComeBackExactly) {
    const TypeRegistry types = all_types();
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        World world = RandomWorld(seed).make(400);
        const Snapshot snapshot = save_snapshot(world, types);
        World fresh;
        restore_snapshot(fresh, types, snapshot);
        World used = RandomWorld(seed + 1000).make(300);
        restore_snapshot(used, types, snapshot);
        const auto expected = look(world, types);
        ASSERT_EQ(look(fresh, types), expected);
        ASSERT_EQ(look(used, types), expected);
        EXPECT_EQ(save_snapshot(fresh, types), snapshot);
        EXPECT_EQ(save_snapshot(used, types), snapshot);
        EXPECT_EQ(fresh.size(), world.size());
        EXPECT_FALSE(fresh.find_resource<UnknownComponents>());
        expect_same_future(world, fresh);
    }
}

TEST(SnapshotTest, AnEmptyWorldComesBack) {
    const TypeRegistry types = all_types();
    World world = RandomWorld(3).make(50);
    restore_snapshot(world, types, save_snapshot(World(), types));
    EXPECT_EQ(world.size(), 0u);
    EXPECT_EQ(world.create(), (Entity{0, 1}));
}

TEST(SnapshotTest, TheOrderOfRegistrationDoesNotMatter) {
    World world = RandomWorld(4).make(300);
    TypeRegistry other;
    other.add<Tone>();
    other.add<Link>();
    other.add<Everything>();
    other.add<Marker>();
    EXPECT_EQ(save_snapshot(world, all_types()), save_snapshot(world, other));
}

TEST(SnapshotTest, ASlotThatIsUsedUpStaysSo) {
    const TypeRegistry types = all_types();
    const std::uint32_t used_up = std::numeric_limits<std::uint32_t>::max();
    World world;
    world.restore_entities({{used_up, 5, used_up - 1}, {}});
    ASSERT_EQ(world.size(), 2u);
    World other;
    restore_snapshot(other, types, save_snapshot(world, types));
    EXPECT_EQ(other.size(), 2u);
    EXPECT_TRUE(other.alive({1, 5}));
    EXPECT_TRUE(other.destroy({2, used_up - 1}));
    EXPECT_EQ(other.create(), (Entity{3, 1}));
}

TEST(SnapshotTest, ComponentsCountAsAddedNowAndResourcesStay) {
    const TypeRegistry types = all_types();
    World world;
    const Entity entity = world.create_with(Tone{Shade::dark, 0.25f, 99}, Position{1, 2});
    const Snapshot snapshot = save_snapshot(world, types);
    World other;
    other.set_resource(std::string("kept"));
    const Entity former = other.create_with(Link{}, Position{});
    for (int i = 0; i < 5; ++i) other.advance_tick();
    restore_snapshot(other, types, snapshot);
    EXPECT_EQ(other.tick(), 6u);
    EXPECT_EQ(other.added_tick<Tone>(entity), 6u);
    EXPECT_EQ(other.get<Tone>(entity).shade, Shade::dark);
    EXPECT_EQ(other.get<Tone>(entity).cached, -1) << "no field describes it";
    EXPECT_FALSE(other.has<Position>(entity)) << "it is not registered";
    EXPECT_THAT(other.removed_since<Link>(5), ElementsAre(former));
    EXPECT_EQ(other.resource<std::string>(), "kept");
}

TEST(SnapshotTest, DefaultsTakeNoSpace) {
    const TypeRegistry types = all_types();
    World plain, told;
    for (int i = 0; i < 10'000; ++i) {
        plain.create_with(Everything{});
        Everything value;
        value.ratio = 0.05f;
        told.create_with(value);
    }
    const std::size_t handles = 4 * 10'000;
    EXPECT_LT(save_snapshot(plain, types).size(), handles + 1000);
    EXPECT_LT(save_snapshot(told, types).size(), handles + 4 * 10'000 + 1000);
}

TEST(SnapshotTest, RefusesToSaveWhatCouldNotBeRestored) {
    const TypeRegistry types = all_types();
    World world;
    const Entity entity = world.create_with(Tone{Shade::dark, 2.0f});
    EXPECT_THAT([&] { static_cast<void>(save_snapshot(world, types)); },
                ThrowsMessage<Error>(StrEq("tone.level: 2 is outside [0, 1]")));
    world.add(entity, Tone{Shade{9}});
    EXPECT_THAT([&] { static_cast<void>(save_snapshot(world, types)); },
                ThrowsMessage<Error>(StrEq("tone.shade: 9 is none of its options")));
}

TEST(SnapshotTest, ADeepTreeAndAWideOneComeBack) {
    const TypeRegistry types;
    World world;
    // The root has the last slot, so that slots don't go down the tree.
    const std::vector<Entity> chain = world.create_many(50'000);
    for (std::size_t i = chain.size() - 1; i > 0; --i) world.set_parent(chain[i - 1], chain[i]);
    const Entity hub = world.create();
    for (const Entity leaf : world.create_many(50'000)) world.set_parent(leaf, hub);
    World other;
    restore_snapshot(other, types, save_snapshot(world, types));
    EXPECT_EQ(other.descendants(chain.back()).size(), chain.size() - 1);
    EXPECT_EQ(other.parent(chain.front()), chain[1]);
    EXPECT_EQ(other.children(hub).size(), 50'000u);
}

TEST(SnapshotTest, AMillionEntitiesComeBack) {
    const TypeRegistry types = all_types();
    constexpr std::uint32_t count = 1'000'000;
    World world;
    world.create_each<Tone>(count, [](std::size_t i, Entity, Tone& tone) {
        tone.level = static_cast<float>(i % 1024) / 1024;
        tone.shade = i % 3 == 0 ? Shade::dark : Shade::light;
    });
    for (std::uint32_t i = 0; i < count; i += 1000) world.add(Entity{i, 1}, Link{Entity{i + 1, 1}, "link"});
    for (std::uint32_t i = 1; i < 1000; ++i) world.destroy({i * 7, 1});
    World other;
    restore_snapshot(other, types, save_snapshot(world, types));
    ASSERT_EQ(other.size(), world.size());
    std::size_t checked = 0;
    for (auto [entity, tone] : other.query<const Tone>()) {
        const Tone& expected = world.get<Tone>(entity);
        ASSERT_EQ(tone.level, expected.level);
        ASSERT_EQ(tone.shade, expected.shade);
        ++checked;
    }
    EXPECT_EQ(checked, world.size());
    for (auto [entity, link] : world.query<const Link>()) ASSERT_EQ(other.get<Link>(entity).target, link.target);
    expect_same_future(world, other);
}

TEST(SnapshotDeathTest, AReservedEntityAsserts) {
    World world;
    static_cast<void>(world.commands().create());
    EXPECT_DEATH(static_cast<void>(save_snapshot(world, TypeRegistry())), "commands are applied");
}

} // namespace
} // namespace hachure::test
