#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace hachure::assets {

/// No model, buffer or image file beyond this is read, in bytes.
inline constexpr std::uintmax_t max_file_bytes = std::uintmax_t{1} << 30;

/// The whole content of a regular file. Throws hachure::Error when it does not exist, is not a regular file (a
/// directory, a pipe, a device), is larger than `limit`, or cannot be read in full. The size is checked before anything
/// is allocated.
[[nodiscard]] std::vector<std::byte> read_file_bytes(const std::filesystem::path& file,
                                                     std::uintmax_t limit = max_file_bytes);

} // namespace hachure::assets
