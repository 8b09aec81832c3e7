#include <hachure/runtime/assert.h>
#include <hachure/runtime/assets/gif_lzw.h>

#include <algorithm>

namespace hachure::assets {
namespace {

constexpr std::uint32_t most_codes = 4096; // 12 bits
constexpr std::size_t symbols = 256;
constexpr std::size_t block_size = 255;

/// Codes as a stream of bits, the lowest first, in blocks that begin with their size.
class CodeStream {
public:
    explicit CodeStream(std::vector<std::byte>& to) : to_(&to) { begin_block(); }

    void put(std::uint32_t code, int bits) {
        waiting_ |= code << count_;
        for (count_ += bits; count_ >= 8; count_ -= 8, waiting_ >>= 8) put_byte(waiting_ & 0xffu);
    }

    void end() {
        if (count_ > 0) put_byte(waiting_ & 0xffu);
        end_block();
        if ((*to_)[block_] != std::byte{0}) to_->push_back(std::byte{0}); // an empty block is the last
    }

private:
    void begin_block() {
        block_ = to_->size();
        to_->push_back(std::byte{0});
    }
    void end_block() { (*to_)[block_] = static_cast<std::byte>(to_->size() - block_ - 1); }
    void put_byte(std::uint32_t value) {
        if (to_->size() - block_ - 1 == block_size) {
            end_block();
            begin_block();
        }
        to_->push_back(static_cast<std::byte>(value));
    }

    std::vector<std::byte>* to_;
    std::size_t block_ = 0;
    std::uint32_t waiting_ = 0;
    int count_ = 0; // bits that wait
};

} // namespace

void GifCompressor::compress(std::span<const std::uint8_t> indices, int symbol_bits, std::vector<std::byte>& to) {
    HACHURE_ASSERT(symbol_bits >= 2 && symbol_bits <= 8, "GIF symbols have 2 to 8 bits");
    HACHURE_ASSERT(!indices.empty(), "an image has pixels");
    const std::uint32_t clear = 1u << symbol_bits, end = clear + 1;
    to.push_back(static_cast<std::byte>(symbol_bits));
    CodeStream stream(to);
    longer_.assign(most_codes * symbols, 0);
    std::uint32_t next = end + 1, code = indices[0];
    int bits = symbol_bits + 1;
    stream.put(clear, bits);
    for (const std::uint8_t symbol : indices.subspan(1)) {
        std::uint16_t& longer = longer_[code * symbols + symbol];
        if (longer != 0) {
            code = longer;
            continue;
        }
        stream.put(code, bits);
        code = symbol;
        if (next < most_codes) {
            // The reader learns this code one code later, so the codes grow when one beyond the size is given out.
            if (next == 1u << bits) ++bits;
            longer = static_cast<std::uint16_t>(next++);
            continue;
        }
        stream.put(clear, bits);
        std::ranges::fill(longer_, std::uint16_t{0});
        next = end + 1;
        bits = symbol_bits + 1;
    }
    stream.put(code, bits);
    // The reader adds a code for this one as well, and reads the end with the size that follows from it.
    if (next == 1u << bits && next < most_codes) ++bits;
    stream.put(end, bits);
    stream.end();
}

} // namespace hachure::assets
