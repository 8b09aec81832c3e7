#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/snapshot_file.h>
#include <hachure/tests/runtime/ecs/reflected.h>
#include <hachure/tests/support/temp_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hachure::test {
namespace {

using testing::ElementsAre;
using testing::StartsWith;
using testing::ThrowsMessage;

class SnapshotFileTest : public testing::Test {
protected:
    SnapshotFileTest() {
        types.add<Everything>();
        world.create_with(Everything{.title = "kept"});
    }

    TempFolder folder;
    TypeRegistry types;
    World world;
};

TEST_F(SnapshotFileTest, ComesBackFromAFile) {
    const auto path = folder / "world.snapshot";
    write_snapshot(path, world, types);
    write_snapshot(path, world, types);
    EXPECT_THAT(folder.listing(), ElementsAre("world.snapshot"));
    World other;
    read_snapshot(path, other, types);
    EXPECT_EQ(other.get<Everything>({0, 1}).title, "kept");
}

TEST_F(SnapshotFileTest, FaultsNameTheFileAndLeaveTheWorld) {
    const auto missing = folder / "missing", text = folder.write("text", "hello"), cut = folder / "cut";
    write_snapshot(cut, world, types);
    std::filesystem::resize_file(cut, std::filesystem::file_size(cut) - 1);
    for (const auto& path : {missing, text, cut, folder.path()})
        EXPECT_THAT([&] { read_snapshot(path, world, types); }, ThrowsMessage<Error>(StartsWith(path.string() + ": ")));
    EXPECT_EQ(world.get<Everything>({0, 1}).title, "kept");
    EXPECT_THAT([&] { write_snapshot(folder / "none" / "world", world, types); },
                ThrowsMessage<Error>(StartsWith((folder / "none" / "world").string() + ": ")));
}

TEST_F(SnapshotFileTest, AWorldThatCanNotBeSavedLeavesTheFormerFile) {
    const auto path = folder / "world.snapshot";
    write_snapshot(path, world, types);
    world.get_mutable<Everything>({0, 1}).small = 99;
    EXPECT_THROW(write_snapshot(path, world, types), Error);
    World other;
    read_snapshot(path, other, types);
    EXPECT_EQ(other.get<Everything>({0, 1}).small, -3);
}

} // namespace
} // namespace hachure::test
