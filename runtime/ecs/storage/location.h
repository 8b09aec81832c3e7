#pragma once

#include <cstdint>

namespace hachure::detail {

/// Where a row of a table is: a chunk of the world, and the row in it, in 32 bits.
class Location {
public:
    static constexpr std::uint32_t row_bits = 11;
    static constexpr std::uint32_t max_rows = 1u << row_bits;
    static constexpr std::uint32_t max_chunks = 1u << (31 - row_bits);

    constexpr Location() = default;
    constexpr Location(std::uint32_t chunk, std::uint32_t row) : packed_(chunk << row_bits | row) {}

    /// False for the default: nowhere.
    explicit constexpr operator bool() const { return static_cast<std::int32_t>(packed_) >= 0; }
    constexpr std::uint32_t chunk() const { return packed_ >> row_bits; }
    constexpr std::uint32_t row() const { return packed_ & (max_rows - 1); }

    /// As one number; of a location that is somewhere, it is less than 2^31.
    constexpr std::uint32_t packed() const { return packed_; }
    static constexpr Location unpack(std::uint32_t packed) {
        Location result;
        result.packed_ = packed;
        return result;
    }

    friend constexpr bool operator==(Location, Location) = default;

private:
    std::uint32_t packed_ = 0xffff'ffffu;
};

} // namespace hachure::detail
