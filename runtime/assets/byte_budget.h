#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hachure::assets {

/// Bounds what decoding a file may allocate by the bytes the file really has, so that a small file cannot claim a large
/// model: `floor` + `growth` * input. A factor of 32 covers the best rates of mesh compression and the sharing of
/// accessors between primitives.
class ByteBudget {
public:
    static constexpr std::uint64_t floor = std::uint64_t{64} << 20;
    static constexpr std::uint64_t growth = 32;

    /// `file` is named in errors.
    explicit ByteBudget(std::string file) : file_(std::move(file)) {}

    /// Counts bytes that were read.
    void add_input(std::uint64_t bytes) { limit_ += growth * bytes; }

    /// Call before allocating `count` elements. Throws hachure::Error, at `where`, when that is beyond the bound.
    void spend(std::uint64_t count, std::uint64_t element_bytes, std::string_view where);

private:
    std::string file_;
    std::uint64_t limit_ = floor;
    std::uint64_t spent_ = 0;
};

} // namespace hachure::assets
