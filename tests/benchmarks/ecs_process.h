#pragma once

#include <cstddef>

namespace hachure::bench {

// What the system says of this process.

/// Bytes of memory that it occupies now.
[[nodiscard]] std::size_t resident_bytes();

/// The most that it ever occupied.
[[nodiscard]] std::size_t peak_resident_bytes();

} // namespace hachure::bench
