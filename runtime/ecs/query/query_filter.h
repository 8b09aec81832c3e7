#pragma once

#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/storage/entity_store.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace hachure::detail {

/// Keeps the entities of which one of a few components was changed (or added) after a tick.
struct ChangeFilter {
    static constexpr std::size_t max_components = 6;
    enum class Event { changed, added };

    Event event = Event::changed;
    Tick since = 0;
    std::size_t count = 0;
    std::array<TypeId, max_components> ids{};

    std::span<const TypeId> components() const { return {ids.data(), count}; }

    /// Whether one entity passes.
    bool passes(const EntityStore& store, Entity entity) const;
};

/// The filters of a query; all of them must agree.
class ChangeFilters {
public:
    static constexpr std::size_t max_filters = 4;

    bool empty() const { return count_ == 0; }
    std::span<const ChangeFilter> all() const { return {filters_.data(), count_}; }

    template <std::size_t n> void add(ChangeFilter::Event event, Tick since, const std::array<TypeId, n>& components) {
        static_assert(n >= 1 && n <= ChangeFilter::max_components, "a filter names 1 to 6 components");
        HACHURE_ASSERT(count_ < max_filters, "a query has at most 4 change filters");
        ChangeFilter& filter = filters_[count_++];
        filter.event = event;
        filter.since = since;
        filter.count = n;
        for (std::size_t i = 0; i < n; ++i) filter.ids[i] = components[i];
    }

private:
    std::size_t count_ = 0;
    std::array<ChangeFilter, max_filters> filters_{};
};

/// How a walk finds changed entities. `automatic` takes the cheaper way; the others are for measuring and testing.
enum class ChangeWalk { automatic, queue, sweep };

/// The part of a walk that has a list of candidates or filters; kept by the world from one walk to the next, so that
/// walking allocates nothing in the long run.
class FilteredWalk {
public:
    /// Begins a walk over `rows` rows in all. False when no entity can have passed the filters.
    bool begin(EntityStore& store, const ChangeFilters& filters, std::size_t rows, ChangeWalk how);

    /// Walks only the entities of a sparse store, unless there is a shorter list already.
    void restrict_to(const SparseStore& store);

    /// Whether only `candidates` are walked.
    bool listed() const { return listed_; }
    std::span<const Entity> candidates() const { return candidates_; }

    bool filtered() const { return count_ > 0; }

    /// Goes to a chunk; false when no row of it can pass.
    bool enter(const Table& table, std::uint32_t chunk, const ChunkDirectory& chunks);

    /// The first row of the chunk from `row` on, below `rows`, that passes all filters; `rows` when there is none.
    std::uint32_t next(const Entity* entities, std::uint32_t row, std::uint32_t rows) const;

    /// The first from `row` on that does not pass; `rows` when there is none.
    std::uint32_t end_of_run(const Entity* entities, std::uint32_t row, std::uint32_t rows) const;

private:
    /// One component of a filter in the chunk.
    struct Watched {
        TypeId id;
        const SparseStore* sparse; ///< of a sparse component
        const ColumnTicks* ticks;  ///< of one in tables; null where the table lacks it or nothing is new
    };
    struct Filter {
        ChangeFilter::Event event;
        Tick since;
        std::size_t count;
        std::array<Watched, ChangeFilter::max_components> watched;
    };

    static bool passes(const Filter& filter, Entity entity, std::uint32_t row);
    bool passes(Entity entity, std::uint32_t row) const;
    void list_changes(EntityStore& store, const ChangeFilter& filter);

    bool listed_ = false;
    std::vector<Entity> candidates_;
    std::size_t count_ = 0;
    std::array<Filter, ChangeFilters::max_filters> filters_;
};

} // namespace hachure::detail
