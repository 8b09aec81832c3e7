#pragma once

#include <hachure/runtime/ecs/snapshot/snapshot_bytes.h>

#include <bit>
#include <cstdint>
#include <vector>

namespace hachure::detail {

/// A subset of the numbers 0 to `of`, to be written.
class Bits {
public:
    explicit Bits(std::uint32_t of) : of_(of), words_((std::size_t{of} + 63) / 64) {}

    void set(std::uint32_t i, bool value = true) { words_[i / 64] |= std::uint64_t{value} << i % 64; }
    std::uint32_t of() const { return of_; }
    std::span<const std::uint64_t> words() const { return words_; }

private:
    std::uint32_t of_;
    std::vector<std::uint64_t> words_;
};

/// A subset of the numbers 0 to `of` as it lies in a snapshot: in the smallest of four forms.
struct Selection {
    enum class Form : std::uint8_t { none, all, bits, list };

    Form form = Form::none;
    std::uint32_t of = 0;
    std::uint32_t count = 0; ///< how many are selected
    Bytes data;              ///< bits: one per number, the low ones first; list: ascending 32-bit numbers
};

void write_selection(ByteWriter& out, const Bits& bits);

/// Throws Error when what it reads is no subset of the numbers 0 to `of`.
Selection read_selection(ByteReader& in, std::uint32_t of);

/// Walks the selected numbers in order.
class SelectionCursor {
public:
    explicit SelectionCursor(const Selection& selection);

    /// The current number; `Selection::of` at the end.
    std::uint32_t at() const { return at_; }
    bool done() const { return at_ == selection_.of; }

    void next() {
        if (++step_ >= selection_.count)
            at_ = selection_.of;
        else if (selection_.form == Selection::Form::all)
            ++at_;
        else if (selection_.form == Selection::Form::list)
            at_ = listed(step_);
        else
            next_bit();
    }

private:
    std::uint32_t listed(std::uint32_t i) const {
        std::uint32_t value;
        std::memcpy(&value, selection_.data.data() + std::size_t{i} * sizeof value, sizeof value);
        return value;
    }

    /// Moves to the next bit that is set; there is one.
    void next_bit() {
        while (word_ == 0) load_word(++word_index_);
        at_ = word_index_ * 64 + static_cast<std::uint32_t>(std::countr_zero(word_));
        word_ &= word_ - 1;
    }

    void load_word(std::uint32_t index);

    Selection selection_;
    std::uint32_t at_ = 0;
    std::uint32_t step_ = 0; ///< how many were passed
    std::uint32_t word_index_ = 0;
    std::uint64_t word_ = 0; ///< what is left of the current 64 bits
};

} // namespace hachure::detail
