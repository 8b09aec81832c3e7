#include <hachure/runtime/ecs/snapshot/snapshot_selection.h>

#include <algorithm>

namespace hachure::detail {
namespace {

std::size_t bitmap_bytes(std::uint32_t of) { return (std::size_t{of} + 7) / 8; }

Selection read_bits(ByteReader& in, std::uint32_t of) {
    Selection result{Selection::Form::bits, of, 0, in.take(bitmap_bytes(of))};
    for (const std::byte byte : result.data)
        result.count += static_cast<std::uint32_t>(std::popcount(std::to_integer<unsigned>(byte)));
    if (of % 8 != 0 && std::to_integer<unsigned>(result.data.back()) >> of % 8 != 0)
        in.fail("selects what is not there");
    return result;
}

Selection read_list(ByteReader& in, std::uint32_t of) {
    Selection result{Selection::Form::list, of, in.number<std::uint32_t>(), {}};
    result.data = in.take(std::uint64_t{4} * result.count);
    ByteReader numbers(result.data, in.subject());
    for (std::uint64_t i = 0, next = 0; i < result.count; ++i) {
        const auto number = numbers.number<std::uint32_t>();
        if (number < next || number >= of) in.fail("selects what is not there");
        next = std::uint64_t{number} + 1;
    }
    return result;
}

} // namespace

void write_selection(ByteWriter& out, const Bits& bits) {
    std::uint32_t count = 0;
    for (const std::uint64_t word : bits.words()) count += static_cast<std::uint32_t>(std::popcount(word));
    if (count == 0) return out.number(Selection::Form::none);
    if (count == bits.of()) return out.number(Selection::Form::all);
    if (4 + std::size_t{4} * count >= bitmap_bytes(bits.of())) {
        out.number(Selection::Form::bits);
        return out.bytes(std::as_bytes(bits.words()).first(bitmap_bytes(bits.of())));
    }
    out.number(Selection::Form::list);
    out.number(count);
    for (std::size_t i = 0; i < bits.words().size(); ++i)
        for (std::uint64_t word = bits.words()[i]; word != 0; word &= word - 1)
            out.number(static_cast<std::uint32_t>(i * 64 + static_cast<std::size_t>(std::countr_zero(word))));
}

Selection read_selection(ByteReader& in, std::uint32_t of) {
    switch (in.number<std::uint8_t>()) {
    case static_cast<std::uint8_t>(Selection::Form::none):
        return {Selection::Form::none, of, 0, {}};
    case static_cast<std::uint8_t>(Selection::Form::all):
        return {Selection::Form::all, of, of, {}};
    case static_cast<std::uint8_t>(Selection::Form::bits):
        return read_bits(in, of);
    case static_cast<std::uint8_t>(Selection::Form::list):
        return read_list(in, of);
    default:
        in.fail("has a selection of no known form");
    }
}

SelectionCursor::SelectionCursor(const Selection& selection) : selection_(selection) {
    if (selection_.count == 0) {
        at_ = selection_.of;
    } else if (selection_.form == Selection::Form::list) {
        at_ = listed(0);
    } else if (selection_.form == Selection::Form::bits) {
        load_word(0);
        next_bit();
    }
}

void SelectionCursor::load_word(std::uint32_t index) {
    const std::size_t begin = std::size_t{index} * 8;
    word_ = 0;
    std::memcpy(&word_, selection_.data.data() + begin, std::min<std::size_t>(8, selection_.data.size() - begin));
}

} // namespace hachure::detail
