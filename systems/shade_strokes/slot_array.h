#pragma once

#include <hachure/runtime/assert.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace hachure {

/// No slot, segment, chain or cell.
inline constexpr std::uint32_t no_slot = std::numeric_limits<std::uint32_t>::max();

/// Values with stable indices, and what of them changed: a copy on the GPU is patched, never rebuilt. Slots that were
/// given back are used again, the last one first, so that equal histories give equal arrays.
template <class T> class SlotArray {
public:
    /// A slot that holds `value`.
    std::uint32_t take(const T& value) {
        std::uint32_t slot = static_cast<std::uint32_t>(values_.size());
        if (free_.empty()) {
            values_.push_back(value);
        } else {
            slot = free_.back();
            free_.pop_back();
            values_[slot] = value;
        }
        mark(slot);
        return slot;
    }

    /// Frees a slot, which holds `dead` from now on.
    void give_back(std::uint32_t slot, const T& dead) {
        values_[slot] = dead;
        free_.push_back(slot);
        mark(slot);
    }

    [[nodiscard]] const T& operator[](std::uint32_t slot) const { return values_[slot]; }
    /// To be written to: marks the slot as changed.
    [[nodiscard]] T& edit(std::uint32_t slot) {
        mark(slot);
        return values_[slot];
    }

    /// All slots, dead ones included.
    [[nodiscard]] std::span<const T> all() const { return values_; }
    [[nodiscard]] std::size_t live() const { return values_.size() - free_.size(); }

    /// Frees all slots; there are none then.
    void clear() {
        values_.clear();
        free_.clear();
        dirty_.clear();
        changed_ = true;
    }

    [[nodiscard]] bool changed() const { return changed_; }
    /// Calls `visit(first slot, count)` for every run of blocks that changed since `forget_changes`.
    template <class Visit> void each_change(Visit&& visit) const {
        for (std::size_t b = 0; changed_ && b < dirty_.size();) {
            std::size_t end = b;
            while (end < dirty_.size() && dirty_[end] != 0) ++end;
            if (end > b) {
                const std::size_t first = b * block, last = end * block < values_.size() ? end * block : values_.size();
                visit(first, last - first);
            }
            b = end > b ? end : b + 1;
        }
    }
    void forget_changes() {
        if (changed_) dirty_.assign(dirty_.size(), 0);
        changed_ = false;
    }

private:
    static constexpr std::size_t block = 32; ///< slots that one flag stands for

    void mark(std::uint32_t slot) {
        HACHURE_ASSERT(slot < values_.size(), "slots are in range");
        const std::size_t b = slot / block;
        if (b >= dirty_.size()) dirty_.resize(b + 1, 0);
        dirty_[b] = 1;
        changed_ = true;
    }

    std::vector<T> values_;
    std::vector<std::uint32_t> free_;
    std::vector<std::uint8_t> dirty_; ///< per block
    bool changed_ = false;
};

} // namespace hachure
