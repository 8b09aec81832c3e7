#pragma once

#include <cstdint>

namespace hachure {

/// What a random number of shade strokes is for.
enum class ShadePurpose : std::uint32_t { chain, start, pressure, segment, wander, order };

/// The finaliser of SplitMix64: every bit of `x` moves every bit of the result.
[[nodiscard]] constexpr std::uint64_t shade_mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// Random bits that are a function of their arguments alone.
[[nodiscard]] constexpr std::uint64_t shade_bits(std::uint64_t stream, ShadePurpose purpose, std::uint64_t index) {
    return shade_mix(shade_mix(stream ^ (static_cast<std::uint64_t>(purpose) << 56)) + index);
}

/// The same as a number in [0, 1).
[[nodiscard]] constexpr double shade_uniform(std::uint64_t stream, ShadePurpose purpose, std::uint64_t index) {
    return static_cast<double>(shade_bits(stream, purpose, index) >> 11) * 0x1p-53;
}

} // namespace hachure
