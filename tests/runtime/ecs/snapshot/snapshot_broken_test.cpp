#include <hachure/runtime/error.h>
#include <hachure/tests/runtime/ecs/snapshot/snapshot_support.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <iterator>

namespace hachure::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class SnapshotBrokenTest : public testing::Test {
protected:
    const TypeRegistry types = all_types();
    World world = RandomWorld(11).make(40);
    Snapshot snapshot = save_snapshot(RandomWorld(12).make(120), types);

    template <class T> void write(std::size_t at, T value) { std::memcpy(snapshot.data() + at, &value, sizeof value); }
};

TEST_F(SnapshotBrokenTest, TruncatedIsRefused) {
    ASSERT_GT(snapshot.size(), 1000u);
    for (std::size_t size = 0; size < snapshot.size(); ++size) {
        const Snapshot part(snapshot.begin(), snapshot.begin() + static_cast<std::ptrdiff_t>(size));
        ASSERT_THAT(restore_fault(world, types, part), HasSubstr(size < 8 ? "is no snapshot" : "is truncated")) << size;
    }
}

TEST_F(SnapshotBrokenTest, ExtendedIsRefused) {
    snapshot.push_back(std::byte{0});
    EXPECT_THAT(restore_fault(world, types, snapshot), HasSubstr("has been altered"));
}

TEST_F(SnapshotBrokenTest, AnyAlteredByteIsRefused) {
    for (std::size_t at = 0; at < snapshot.size(); ++at)
        for (const unsigned change : {0x01u, 0x80u, 0xffu}) {
            Snapshot altered = snapshot;
            altered[at] ^= static_cast<std::byte>(change);
            ASSERT_THAT(restore_fault(world, types, altered), StartsWith("snapshot: ")) << at;
        }
}

TEST_F(SnapshotBrokenTest, AnyAlteredByteWithAFittingChecksumIsRefusedOrHarmless) {
    std::size_t restored = 0, refused = 0;
    for (std::size_t at = 0; at < snapshot.size() - 4; ++at)
        for (const unsigned change : {0x01u, 0xffu}) {
            Snapshot altered = snapshot;
            altered[at] ^= static_cast<std::byte>(change);
            seal(altered);
            World target = RandomWorld(13).make(20);
            const std::string fault = restore_fault(target, types, altered, true);
            ++(fault.empty() ? restored : refused);
            if (!fault.empty()) continue;
            // Whatever it says now, it is a world that can be saved and restored.
            World again;
            restore_snapshot(again, types, save_snapshot(target, types));
            ASSERT_EQ(look(again, types), look(target, types)) << at;
        }
    EXPECT_GT(restored, 100u);
    EXPECT_GT(refused, 100u);
}

TEST_F(SnapshotBrokenTest, NumbersWrittenOverItAreRefusedOrHarmless) {
    std::mt19937 random(5);
    const std::uint32_t likely[] = {0, 1, 2, 7, 255, 256, 65'535, 0x7fff'ffff, 0xffff'fffe, 0xffff'ffff, 0x7fc0'0000};
    std::size_t refused = 0;
    for (int i = 0; i < 3000; ++i) {
        Snapshot altered = snapshot;
        for (auto n = 1 + random() % 3; n > 0; --n) {
            const std::size_t at = random() % (altered.size() - 8);
            std::memcpy(altered.data() + at, &likely[random() % std::size(likely)], 1 + random() % 4);
        }
        seal(altered);
        refused += !restore_fault(world, types, altered, true).empty();
    }
    EXPECT_GT(refused, 100u);
}

TEST_F(SnapshotBrokenTest, ACutThatIsSealedAgainIsRefusedUnlessItIsBetweenSections) {
    std::size_t restored = 0;
    for (std::size_t size = 24; size < snapshot.size(); ++size) {
        Snapshot part(snapshot.begin(), snapshot.begin() + static_cast<std::ptrdiff_t>(size));
        seal(part);
        // Where a whole section was cut off the rest is a snapshot, of a world with fewer types.
        World target;
        restored += restore_fault(target, types, part, true).empty();
    }
    EXPECT_EQ(restored, types.types().size());
}

TEST_F(SnapshotBrokenTest, ForeignFilesAndOtherVersionsAreNamed) {
    EXPECT_EQ(restore_fault(world, types, {}), "snapshot: is no snapshot");
    EXPECT_EQ(restore_fault(world, types, Snapshot(100'000, std::byte{'g'})), "snapshot: is no snapshot");
    write(8, std::uint32_t{2});
    seal(snapshot);
    EXPECT_EQ(restore_fault(world, types, snapshot), "snapshot: is a snapshot of version 2, which is not known");
}

// The first section begins at byte 20: tag, length, then the number of slots at byte 32.
TEST_F(SnapshotBrokenTest, ClaimsBeyondTheFileAreRefusedBeforeMemoryIsTaken) {
    snapshot.resize(1024);
    for (const std::uint32_t claim : {100'000'000u, 0xffff'ffffu}) {
        write(32, claim);
        seal(snapshot);
        EXPECT_THAT(restore_fault(world, types, snapshot), HasSubstr("claims more than it holds")) << claim;
    }
    write(24, ~std::uint64_t{0});
    seal(snapshot);
    EXPECT_THAT(restore_fault(world, types, snapshot), HasSubstr("claims more than it holds (byte 32)"));
}

/// A snapshot of `slots` live entities and this tree section.
Snapshot with_tree(std::uint32_t slots, std::vector<std::uint32_t> tree) {
    World world;
    world.create_many(slots);
    Snapshot result = save_snapshot(world, TypeRegistry());
    // An empty tree is a section of one number, before the checksum.
    const std::uint64_t length = tree.size() * 4;
    result.resize(result.size() - 4 - 4 - 8 + 8 + length + 4);
    std::byte* section = result.data() + result.size() - 4 - length;
    std::memcpy(section - 8, &length, 8);
    std::memcpy(section, tree.data(), length);
    seal(result);
    return result;
}

TEST_F(SnapshotBrokenTest, WhatIsNoForestIsRefused) {
    EXPECT_EQ(restore_fault(world, types, with_tree(3, {1, 0, 2, 2, 1}), true), "");
    EXPECT_THAT(world.children({0, 1}), testing::ElementsAre(Entity{2, 1}, Entity{1, 1}));
    const std::vector<std::vector<std::uint32_t>> wrong{
        {1, 0, 1, 0},             // its own parent
        {2, 0, 1, 1, 1, 1, 0},    // a circle
        {2, 0, 1, 2, 1, 1, 2},    // two parents
        {1, 0, 2, 1, 1},          // twice a child
        {1, 3, 1, 0},             // a parent that is none
        {1, 0, 1, 3},             // a child that is none
        {1, 0, 0},                // a parent of nobody
        {2, 0, 1, 1, 0, 1, 2},    // twice a parent
        {1, 0, 1, 1, 5},          // more than it says
        {1, 0, 1'000'000'000, 1}, // less than it says
        {9},
    };
    for (const auto& tree : wrong)
        EXPECT_THAT(restore_fault(world, types, with_tree(3, tree)), HasSubstr("(byte "))
            << testing::PrintToString(tree);
}

} // namespace
} // namespace hachure::test
