#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hachure::picture {

/// The value that `share` (0 to 1) of the values do not exceed, one of them; 0 when there are none. Reorders them.
[[nodiscard]] inline double percentile(std::vector<double>& values, double share) {
    if (values.empty()) return 0.0;
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 1e-9);
    std::ranges::nth_element(values, values.begin() + at);
    return values[static_cast<std::size_t>(at)];
}

} // namespace hachure::picture
