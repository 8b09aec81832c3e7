#pragma once

#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/query_terms.h>

#include <array>
#include <cstddef>

namespace hachure::detail {

/// Keeps the entities of which one of a few components was changed (or added) after a tick.
class ChangeFilter {
public:
    static constexpr std::size_t max_components = 6;
    enum class Event { changed, added };

    /// For `components.size() <= max_components`.
    template <std::size_t n> void set(Event event, Tick since, const std::array<TypeId, n>& components) {
        static_assert(n >= 1 && n <= max_components, "a filter names 1 to 6 components");
        event_ = event;
        since_ = since;
        ids_count_ = n;
        for (std::size_t i = 0; i < n; ++i) ids_[i] = components[i];
    }

    /// Looks the stores up. Those without news are left out, which often leaves nothing to walk at all.
    void choose(const StoreTable& stores, DriverChoice& choice) {
        stores_count_ = 0;
        for (std::size_t i = 0; i < ids_count_; ++i) {
            const StoreBase* store = stores.find(ids_[i]);
            if (store && store->last_changed() > since_) stores_[stores_count_++] = store;
        }
        if (stores_count_ == 0) choice.impossible = true;
        if (stores_count_ == 1) choice.require(stores_[0]);
    }

    bool match(const Visit& visit) const {
        for (std::size_t i = 0; i < stores_count_; ++i) {
            const std::uint32_t row = visit.row_in(*stores_[i]);
            if (row == no_row) continue;
            const Tick tick = event_ == Event::changed ? stores_[i]->changed(row) : stores_[i]->added(row);
            if (tick > since_) return true;
        }
        return false;
    }

private:
    Event event_ = Event::changed;
    Tick since_ = 0;
    std::size_t ids_count_ = 0;
    std::size_t stores_count_ = 0;
    std::array<TypeId, max_components> ids_{};
    std::array<const StoreBase*, max_components> stores_{};
};

/// The filters of a query; all of them must agree.
class ChangeFilters {
public:
    static constexpr std::size_t max_filters = 4;

    ChangeFilter& append() {
        HACHURE_ASSERT(count_ < max_filters, "a query has at most 4 change filters");
        return filters_[count_++];
    }

    void choose(const StoreTable& stores, DriverChoice& choice) {
        for (std::size_t i = 0; i < count_; ++i) filters_[i].choose(stores, choice);
    }

    bool match(const Visit& visit) const {
        for (std::size_t i = 0; i < count_; ++i)
            if (!filters_[i].match(visit)) return false;
        return true;
    }

private:
    std::size_t count_ = 0;
    std::array<ChangeFilter, max_filters> filters_;
};

} // namespace hachure::detail
