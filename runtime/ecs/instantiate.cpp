#include <hachure/runtime/ecs/world.h>

#include <utility>

namespace hachure {

Entity World::copy_entity(Entity from, bool with_tree) {
    detail::Table* table = &store_->table_of(store_->ids().find(from));
    const auto drop = [&](detail::TypeId id) {
        if (table->has(id)) table = store_->removing(*table, *store_->find_record(id)).to;
    };
    for (const auto& column : store_->table_of(store_->ids().find(from)).columns())
        if (!column.component->info->copy) drop(column.component->info->id);
    if (!with_tree) drop(detail::component_id<Parent>());
    return store_->copy(from, *table);
}

std::vector<Entity> World::instantiate_many(Entity prefab, std::size_t count) {
    require_alive(prefab);
    store_->lock().assert_idle();
    std::vector<Entity> originals = descendants(prefab);
    originals.insert(originals.begin(), prefab);
    std::vector<Entity> result;
    result.reserve(count);
    EntityMap map;
    std::vector<Entity> copies;
    for (std::size_t i = 0; i < count; ++i) {
        map.clear();
        copies.clear();
        for (const Entity original : originals) {
            copies.push_back(copy_entity(original, original != prefab));
            map.insert(original, copies.back());
        }
        for (const Entity copy : copies) store_->remap(copy, map);
        for (const Entity copy : copies)
            if (observed_) notify_added(copy);
        result.push_back(copies.front());
    }
    return result;
}

Entity World::instantiate(Entity prefab) { return instantiate_many(prefab, 1).front(); }

} // namespace hachure
