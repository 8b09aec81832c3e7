#pragma once

#include <cstdint>
#include <string_view>

/// Random numbers that depend on a counter and on nothing else.
namespace hachure::script {

/// The finaliser of SplitMix64: every bit of `x` moves every bit of the result.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// 64 random bits: those of number `index` in the row that `key` names.
[[nodiscard]] constexpr std::uint64_t random_bits(std::uint64_t key, std::uint64_t index) {
    return mix(mix(key) ^ index);
}

/// A key for `text` after those in `key`.
[[nodiscard]] constexpr std::uint64_t extend_key(std::uint64_t key, std::string_view text) {
    for (const char c : text) key = mix(key ^ static_cast<unsigned char>(c));
    return mix(key ^ (std::uint64_t{1} << 32 | text.size()));
}

} // namespace hachure::script
