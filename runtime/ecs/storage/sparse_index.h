#pragma once

#include <hachure/runtime/ecs/storage/location.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace hachure::detail {

/// From the slot of an entity to a row of a table. Pages exist only where slots are in use, so a rare component on a
/// late entity costs one page of 16 KiB and a pointer for every page before it.
class SparseIndex {
public:
    Location find(std::uint32_t slot) const {
        const std::size_t page = slot / page_size;
        return page < pages_.size() && pages_[page] ? (*pages_[page])[slot % page_size] : Location{};
    }

    void set(std::uint32_t slot, Location at) {
        const std::size_t page = slot / page_size;
        if (page >= pages_.size()) pages_.resize(page + 1);
        if (!pages_[page]) pages_[page] = std::make_unique<Page>();
        (*pages_[page])[slot % page_size] = at;
    }

    /// `slot` was set.
    void clear(std::uint32_t slot) { (*pages_[slot / page_size])[slot % page_size] = Location{}; }

private:
    static constexpr std::uint32_t page_size = 4096;
    using Page = std::array<Location, page_size>;
    std::vector<std::unique_ptr<Page>> pages_;
};

} // namespace hachure::detail
