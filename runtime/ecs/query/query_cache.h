#pragma once

#include <hachure/runtime/ecs/storage/table.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace hachure::detail {

/// The tables that a query matches. Tables are only ever added to a world, so each is looked at once per query type: a
/// query that matches nothing costs one comparison.
class QueryCache {
public:
    using Matches = bool (*)(const Table&);

    explicit QueryCache(Matches matches) : matches_(matches) {}

    /// Up to date since the last `QueryCaches::get`.
    const std::vector<Table*>& tables() const { return tables_; }
    bool contains(const Table& table) const { return table.index() < contained_.size() && contained_[table.index()]; }

private:
    friend class QueryCaches;

    Matches matches_;
    std::atomic<std::size_t> seen_ = 0; ///< tables of the world that were looked at
    std::vector<Table*> tables_;
    std::vector<bool> contained_; ///< by number of the table
};

/// The caches of a world, by type of query. Several threads may get caches at once.
class QueryCaches {
public:
    QueryCaches() = default;
    QueryCaches(const QueryCaches&) = delete;
    QueryCaches& operator=(const QueryCaches&) = delete;
    ~QueryCaches();

    /// The cache of query type `id`, brought up to date with `tables`, all tables of the world.
    const QueryCache& get(std::uint32_t id, QueryCache::Matches matches,
                          const std::vector<std::unique_ptr<Table>>& tables) {
        HACHURE_ASSERT(id < page_size * page_count, "a program has less than 4096 types of queries");
        const Page* page = pages_[id / page_size].load(std::memory_order_acquire);
        const QueryCache* cache = page ? (*page)[id % page_size].load(std::memory_order_acquire) : nullptr;
        if (cache && cache->seen_.load(std::memory_order_acquire) == tables.size()) return *cache;
        return update(id, matches, tables);
    }

private:
    static constexpr std::size_t page_size = 64;
    static constexpr std::size_t page_count = 64;
    using Page = std::array<std::atomic<QueryCache*>, page_size>;

    const QueryCache& update(std::uint32_t id, QueryCache::Matches matches,
                             const std::vector<std::unique_ptr<Table>>& tables);

    std::array<std::atomic<Page*>, page_count> pages_{};
    std::mutex mutex_;
};

} // namespace hachure::detail
