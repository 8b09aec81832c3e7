#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/scene/snapshot_file.h>

namespace hachure {
namespace {

constexpr std::uintmax_t max_snapshot_bytes = std::uintmax_t{1} << 34;

} // namespace

void write_snapshot(const std::filesystem::path& path, const World& world, const TypeRegistry& types) {
    assets::write_file_atomically(path, save_snapshot(world, types));
}

void read_snapshot(const std::filesystem::path& path, World& world, const TypeRegistry& types) {
    restore_snapshot(world, types, assets::read_file_bytes(path, max_snapshot_bytes), path.string());
}

} // namespace hachure
