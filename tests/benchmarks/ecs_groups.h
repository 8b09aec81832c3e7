#pragma once

#include <hachure/tests/benchmarks/ecs_measure.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace hachure::bench {

// The operations that are timed, each on a world of `count` entities with two components of 12 bytes.

[[nodiscard]] Group iterate_group(std::size_t count);   ///< walking; the floor is p[i] += v[i]
[[nodiscard]] Group create_group(std::size_t count);    ///< the floor is push_back into two vectors that start empty
[[nodiscard]] Group destroy_group(std::size_t count);   ///< the floor is that of creation
[[nodiscard]] Group component_group(std::size_t count); ///< adding and removing a third; the floor is that of creation
[[nodiscard]] Group access_group(std::size_t count);    ///< by handle in random order; the floor is p[index[id]]
[[nodiscard]] Group write_group(std::size_t count);     ///< the same, writing
[[nodiscard]] Group change_group(std::size_t count);    ///< finding what changed
[[nodiscard]] Group tree_group(std::size_t count);      ///< parents and children
[[nodiscard]] Group footprint_group(std::size_t count); ///< bytes per entity

/// Appends the two vectors' worth of data to empty ones: the floor of all structural changes, nanoseconds per entity.
[[nodiscard]] double create_raw(std::size_t count);

/// All of the above, in order.
[[nodiscard]] const std::vector<std::function<Group(std::size_t)>>& all_groups();

} // namespace hachure::bench
