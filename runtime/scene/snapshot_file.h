#pragma once

#include <hachure/runtime/ecs/snapshot.h>

#include <filesystem>

namespace hachure {

/// `save_snapshot` into a file, which appears whole or not at all. Throws Error as that does, and when the file can't
/// be written.
void write_snapshot(const std::filesystem::path& path, const World& world, const TypeRegistry& types);

/// `restore_snapshot` from a file. Throws Error naming it, and leaves the world as it was, when it can't be read, is
/// larger than 16 GiB, or is no snapshot that fits.
void read_snapshot(const std::filesystem::path& path, World& world, const TypeRegistry& types);

} // namespace hachure
