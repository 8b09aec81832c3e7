#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hachure::animation {

/// Finds the last key at or before a moment, galloping from where the last search ended: the cost is the logarithm of
/// the distance. `times` holds at least one key, strictly ascending.
template <class Seconds> class KeySearch {
public:
    KeySearch(std::span<const Seconds> times, double time) : times_(times), time_(time) {}

    /// The key; 0 also before the first one. `hint` is any number, best the result of a search nearby.
    std::uint32_t from(std::uint32_t hint) {
        if (!passed(0)) return 0;
        const std::size_t last = times_.size() - 1;
        if (passed(last)) return static_cast<std::uint32_t>(last);
        return static_cast<std::uint32_t>(between(std::min<std::size_t>(hint, last)));
    }

    std::uint64_t looked_at = 0; ///< keys

private:
    bool passed(std::size_t k) {
        ++looked_at;
        return times_[k] <= time_;
    }

    /// The first key is passed, the last one is not.
    std::size_t between(std::size_t hint) {
        std::size_t low = 0, high = times_.size() - 1;
        if (passed(hint)) {
            low = hint;
            for (std::size_t step = 1; low + step < high; step *= 2) {
                if (!passed(low + step)) {
                    high = low + step;
                    break;
                }
                low += step;
            }
        } else {
            high = hint;
            for (std::size_t step = 1; step < high; step *= 2) {
                if (passed(high - step)) {
                    low = high - step;
                    break;
                }
                high -= step;
            }
        }
        while (high - low > 1) {
            const std::size_t middle = low + (high - low) / 2;
            (passed(middle) ? low : high) = middle;
        }
        return low;
    }

    std::span<const Seconds> times_;
    double time_;
};

} // namespace hachure::animation
