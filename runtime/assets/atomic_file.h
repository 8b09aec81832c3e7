#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace hachure::assets {

/// Writes `bytes` to a temporary neighbour of `path` and renames it over `path`: readers see the old file or the whole
/// new one, and nothing is left behind on failure. Throws Error naming `path` (no such folder, no permission, disk
/// full).
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

} // namespace hachure::assets
