#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::assets {

/// The compression of GIF files: LZW with codes of 3 to 12 bits (GIF89a, appendix F). The table is kept between calls.
class GifCompressor {
public:
    /// Appends the data of an image to `to`: the byte that gives the size of a symbol, then blocks of at most 255
    /// bytes, then an empty one. Each of `indices` is below 2^symbol_bits; `symbol_bits` is 2 to 8.
    void compress(std::span<const std::uint8_t> indices, int symbol_bits, std::vector<std::byte>& to);

private:
    std::vector<std::uint16_t> longer_; // by code and the symbol behind it: the code of both; 0: there is none yet
};

} // namespace hachure::assets
