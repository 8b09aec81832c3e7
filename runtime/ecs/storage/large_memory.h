#pragma once

#include <cstddef>

namespace hachure::detail {

/// Memory for large arrays, aligned to at least a cache line. From 2 MiB on it asks the system for large pages: walks
/// and random reads over it miss fewer address translations, and fresh memory costs one fault where it would cost 512.
/// Where the system has none to give, this changes nothing.
std::byte* allocate_large(std::size_t bytes);

/// `bytes` as it was allocated.
void release_large(std::byte* memory, std::size_t bytes);

} // namespace hachure::detail
