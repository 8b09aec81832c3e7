#pragma once

#include <hachure/runtime/gpu/rect.h>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

namespace hachure::gpu {

/// A number whose bytes are its value: no padding, so equal bits are what "unchanged" means (0 and -0 differ).
template <class T>
concept KeyScalar = (std::is_arithmetic_v<T> || std::is_enum_v<T>)&&sizeof(T) <= sizeof(std::uint64_t);

/// A 64-bit hash of everything a result depends on, in order. The length of strings and spans is part of it, so
/// ("ab", "c") differs from ("a", "bc"). The same on every run and machine of one byte order.
class KeyHash {
public:
    void add(KeyScalar auto value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof value);
        combine(bits);
    }

    void add(std::string_view text) { add_bytes(text.data(), text.size()); }
    void add(const char* text) { add(std::string_view(text)); }

    template <KeyScalar T> void add(std::span<const T> values) { add_bytes(values.data(), values.size_bytes()); }

    template <glm::length_t L, KeyScalar T, glm::qualifier Q> void add(const glm::vec<L, T, Q>& vector) {
        for (glm::length_t i = 0; i < L; ++i) add(vector[i]);
    }

    template <glm::length_t C, glm::length_t R, KeyScalar T, glm::qualifier Q>
    void add(const glm::mat<C, R, T, Q>& matrix) {
        for (glm::length_t i = 0; i < C; ++i) add(matrix[i]);
    }

    void add(const Rect& rect) {
        for (const int side : {rect.x, rect.y, rect.width, rect.height}) add(side);
    }

    [[nodiscard]] std::uint64_t value() const { return state_; }

private:
    /// The finaliser of SplitMix64: every input bit moves every output bit.
    static constexpr std::uint64_t mix(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    }

    void combine(std::uint64_t bits) { state_ = mix(std::rotl(state_, 23) ^ mix(bits + 0x9e3779b97f4a7c15u)); }

    void add_bytes(const void* data, std::size_t size) {
        combine(size ^ 0x13198a2e03707344u); // so that "" is not the number 0
        const char* bytes = static_cast<const char*>(data);
        for (std::size_t at = 0; at < size; at += sizeof(std::uint64_t)) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes + at, size - at < sizeof word ? size - at : sizeof word);
            combine(word);
        }
    }

    std::uint64_t state_ = 0x243f6a8885a308d3u; // arbitrary and not zero: digits of pi
};

/// The key of several values at once, for callers that keep one of their own.
template <class... T> [[nodiscard]] std::uint64_t key_of(const T&... values) {
    KeyHash hash;
    (hash.add(values), ...);
    return hash.value();
}

} // namespace hachure::gpu
