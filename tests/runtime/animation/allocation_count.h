#pragma once

#include <cstddef>

namespace hachure::test {

/// How often operator new was called in this program so far.
std::size_t allocation_count();

} // namespace hachure::test
