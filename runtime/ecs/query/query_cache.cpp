#include <hachure/runtime/ecs/query/query_cache.h>

namespace hachure::detail {

QueryCaches::~QueryCaches() {
    for (auto& page : pages_) {
        Page* caches = page.load();
        if (!caches) continue;
        for (auto& cache : *caches) delete cache.load();
        delete caches;
    }
}

const QueryCache& QueryCaches::update(std::uint32_t id, QueryCache::Matches matches,
                                      const std::vector<std::unique_ptr<Table>>& tables) {
    const std::scoped_lock lock(mutex_);
    auto& page = pages_[id / page_size];
    if (!page.load()) page.store(std::make_unique<Page>().release());
    auto& place = (*page.load())[id % page_size];
    if (!place.load()) place.store(std::make_unique<QueryCache>(matches).release());

    QueryCache& cache = *place.load();
    cache.contained_.resize(tables.size());
    for (std::size_t i = cache.seen_; i < tables.size(); ++i) {
        if (!cache.matches_(*tables[i])) continue;
        cache.tables_.push_back(tables[i].get());
        cache.contained_[i] = true;
    }
    cache.seen_.store(tables.size(), std::memory_order_release);
    return cache;
}

} // namespace hachure::detail
