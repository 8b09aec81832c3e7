#pragma once

#include <cstdint>

namespace hachure {

/// Resource: where the random numbers of a scene begin. The same seed gives the same scene; absent it is 1.
struct SceneSeed {
    std::uint64_t value = 1;
};

} // namespace hachure
