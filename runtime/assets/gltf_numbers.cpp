#include <hachure/runtime/assets/gltf_numbers.h>

#include <algorithm>
#include <cmath>

namespace hachure::assets {

std::vector<float> to_floats(const std::vector<double>& numbers) {
    std::vector<float> floats(numbers.size());
    std::transform(numbers.begin(), numbers.end(), floats.begin(), [](double n) { return static_cast<float>(n); });
    return floats;
}

bool all_finite(std::span<const float> numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](float n) { return std::isfinite(n); });
}

bool zero_non_finite(std::span<float> numbers) {
    bool any = false;
    for (float& number : numbers) {
        if (std::isfinite(number)) continue;
        number = 0.0f;
        any = true;
    }
    return any;
}

} // namespace hachure::assets
