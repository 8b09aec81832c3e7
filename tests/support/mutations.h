#pragma once

#include <algorithm>
#include <cstdlib>

namespace hachure::test {

/// How many damaged files a test tries: 400, or what the environment says. `HACHURE_MUTATIONS=10000` searches longer.
inline int mutation_count() {
    const char* wanted = std::getenv("HACHURE_MUTATIONS");
    return wanted ? std::max(1, std::atoi(wanted)) : 400;
}

} // namespace hachure::test
