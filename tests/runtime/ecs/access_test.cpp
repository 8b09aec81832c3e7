#include <hachure/runtime/ecs/access.h>
#include <hachure/tests/runtime/ecs/components.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace hachure {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Access make(void (*fill)(Access&)) {
    Access access;
    fill(access);
    return access;
}

TEST(AccessTest, ReadersDoNotConflictAndWritersDo) {
    const Access reads = make([](Access& a) { a.read_component<Position>(); });
    const Access writes = make([](Access& a) { a.write_component<Position>(); });
    const Access other = make([](Access& a) { a.write_component<Speed>(); });
    EXPECT_FALSE(conflicts(reads, reads));
    EXPECT_TRUE(conflicts(reads, writes));
    EXPECT_TRUE(conflicts(writes, reads));
    EXPECT_TRUE(conflicts(writes, writes));
    EXPECT_FALSE(conflicts(writes, other));
    EXPECT_FALSE(conflicts({}, {}));
}

TEST(AccessTest, ComponentsAndResourcesOfOneTypeAreDifferentThings) {
    const Access component = make([](Access& a) { a.write_component<Position>(); });
    const Access resource = make([](Access& a) { a.write_resource<Position>(); });
    EXPECT_FALSE(conflicts(component, resource));
    EXPECT_TRUE(conflicts(resource, make([](Access& a) { a.read_resource<Position>(); })));
}

TEST(AccessTest, WritingWinsOverReading) {
    for (const bool write_first : {true, false}) {
        Access access;
        if (write_first) access.write_component<Position>();
        access.read_component<Position>();
        if (!write_first) access.write_component<Position>();
        ASSERT_EQ(access.components.size(), 1u);
        EXPECT_TRUE(access.components[0].writes);
    }
}

TEST(AccessTest, WhoQueuesCommandsAndWhoReadsTheWorld) {
    const Access nothing;
    const Access commands{.commands = true};
    const Access reads_world{.reads_world = true};
    const Access exclusive{.exclusive = true};
    const Access reads = make([](Access& a) { a.read_component<Position>(); });
    const Access writes = make([](Access& a) { a.write_resource<Position>(); });
    EXPECT_TRUE(conflicts(commands, commands));
    EXPECT_FALSE(conflicts(commands, writes));
    EXPECT_TRUE(conflicts(commands, reads_world));
    EXPECT_FALSE(conflicts(reads_world, reads_world));
    EXPECT_FALSE(conflicts(reads_world, reads));
    EXPECT_TRUE(conflicts(reads_world, writes));
    for (const Access& other : {nothing, commands, reads_world, exclusive, reads, writes})
        EXPECT_TRUE(conflicts(exclusive, other));
}

TEST(AccessTest, NamesWhatIsContested) {
    Access a;
    a.write_component<Speed>();
    a.write_component<Position>();
    a.read_resource<Label>();
    Access b;
    b.read_component<Position>();
    b.read_component<Speed>();
    b.read_resource<Label>();
    EXPECT_THAT(contested(a, b), ElementsAre(HasSubstr("Position"), HasSubstr("Speed")));
    EXPECT_THAT(contested({.reads_world = true}, a), ElementsAre(HasSubstr("Position"), HasSubstr("Speed")));
    EXPECT_THAT(contested({.commands = true}, {.commands = true}), ElementsAre("Commands"));
    EXPECT_THAT(contested({.exclusive = true}, b), ElementsAre("World"));
    EXPECT_THAT(contested(b, b), IsEmpty());
}

/// An access drawn by chance, and the same one as plain flags to judge by: bits 0-3 read, bits 4-7 written.
struct Drawn {
    Access access;
    unsigned bits = 0;
};

Drawn draw(std::mt19937& random) {
    Drawn drawn;
    const auto take = [&]<class C>(unsigned bit) {
        const unsigned kind = random() % 4;
        if (kind == 0) drawn.access.read_component<C>();
        if (kind == 1) drawn.access.write_component<C>();
        if (kind < 2) drawn.bits |= (kind == 0 ? 1u : 16u) << bit;
    };
    take.operator()<Hidden>(0);
    take.operator()<Position>(1);
    take.operator()<Owner>(2);
    take.operator()<Label>(3);
    return drawn;
}

TEST(AccessTest, AgreesWithSets) {
    std::mt19937 random(1);
    int conflicting = 0;
    for (int i = 0; i < 2000; ++i) {
        const Drawn a = draw(random), b = draw(random);
        const unsigned all_a = a.bits | a.bits >> 4, all_b = b.bits | b.bits >> 4;
        const bool expected = ((a.bits >> 4) & all_b & 15u) != 0 || ((b.bits >> 4) & all_a & 15u) != 0;
        conflicting += expected;
        ASSERT_EQ(conflicts(a.access, b.access), expected);
        ASSERT_EQ(contested(a.access, b.access).empty(), !expected);

        Access both = a.access;
        both.merge(b.access);
        const Drawn c = draw(random);
        ASSERT_EQ(conflicts(both, c.access), conflicts(a.access, c.access) || conflicts(b.access, c.access));
    }
    EXPECT_GT(conflicting, 300);
    EXPECT_LT(conflicting, 1900);
}

} // namespace
} // namespace hachure
