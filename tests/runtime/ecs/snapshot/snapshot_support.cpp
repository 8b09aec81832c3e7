#include <hachure/runtime/error.h>
#include <hachure/tests/runtime/ecs/snapshot/snapshot_support.h>

#include <zlib.h>

#include <cstring>

namespace hachure::test {

void seal(Snapshot& snapshot) {
    const std::uint64_t length = snapshot.size();
    std::memcpy(snapshot.data() + 12, &length, sizeof length);
    const auto checksum =
        static_cast<std::uint32_t>(::crc32_z(0, reinterpret_cast<const Bytef*>(snapshot.data()), snapshot.size() - 4));
    std::memcpy(snapshot.data() + snapshot.size() - 4, &checksum, sizeof checksum);
}

std::string restore_fault(World& world, const TypeRegistry& types, const Snapshot& snapshot, bool may_succeed) {
    const Snapshot before = save_snapshot(world, types);
    try {
        restore_snapshot(world, types, snapshot);
    } catch (const Error& error) {
        EXPECT_EQ(save_snapshot(world, types), before) << "the world changed: " << error.what();
        return error.what();
    }
    EXPECT_TRUE(may_succeed) << "it was restored";
    return {};
}

} // namespace hachure::test
