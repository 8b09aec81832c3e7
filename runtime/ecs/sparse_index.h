#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace hachure::detail {

inline constexpr std::uint32_t no_row = 0xffff'ffffu;

/// From the slot of an entity to a row. Pages exist only where slots are in use, so a rare component on a late entity
/// costs one page of 16 KiB and a pointer for every page before it.
class SparseIndex {
public:
    std::uint32_t find(std::uint32_t slot) const {
        const std::size_t page = slot / page_size;
        return page < pages_.size() && pages_[page] ? (*pages_[page])[slot % page_size] : no_row;
    }

    void set(std::uint32_t slot, std::uint32_t row) {
        const std::size_t page = slot / page_size;
        if (page >= pages_.size()) pages_.resize(page + 1);
        if (!pages_[page]) {
            pages_[page] = std::make_unique<Page>();
            pages_[page]->fill(no_row);
        }
        (*pages_[page])[slot % page_size] = row;
    }

    /// `slot` has a row.
    void clear(std::uint32_t slot) { (*pages_[slot / page_size])[slot % page_size] = no_row; }

private:
    static constexpr std::uint32_t page_size = 4096;
    using Page = std::array<std::uint32_t, page_size>;
    std::vector<std::unique_ptr<Page>> pages_;
};

} // namespace hachure::detail
