#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/world.h>

#include <algorithm>

namespace hachure {

World::World() : store_(std::make_unique<detail::EntityStore>()), commands_(std::make_unique<Commands>(*this)) {}
World::World(World&& other) noexcept
    : store_((other.store_->lock().assert_idle(), std::move(other.store_))), resources_(std::move(other.resources_)),
      commands_(std::move(other.commands_)), observed_(other.observed_) {}
World& World::operator=(World&& other) noexcept {
    if (store_) store_->lock().assert_idle();
    if (other.store_) other.store_->lock().assert_idle();
    store_ = std::move(other.store_);
    resources_ = std::move(other.resources_);
    commands_ = std::move(other.commands_);
    observed_ = other.observed_;
    return *this;
}
World::~World() = default;

Entity World::create() {
    store_->lock().assert_idle();
    return store_->create(store_->empty_table());
}

void World::revive(Entity reserved) { store_->ids().activate(reserved, store_->empty_table().append(reserved)); }

bool World::destroy(Entity entity) {
    const detail::Location at = store_->ids().find(entity);
    if (!at) return false;
    store_->lock().assert_idle();
    if (!store_->table_of(at).in_tree) {
        if (observed_) notify_removed(entity);
        store_->destroy(entity);
        return true;
    }
    detach(entity);
    const std::vector<Entity> below = descendants(entity);
    if (observed_) {
        // Before any of them goes, so that observers find the parents alive.
        notify_removed(entity);
        for (const Entity descendant : below) notify_removed(descendant);
    }
    store_->destroy(entity);
    for (const Entity descendant : below) store_->destroy(descendant);
    return true;
}

void World::destroy_many(std::span<const Entity> entities) {
    store_->lock().assert_idle();
    // From the last on: entities that stand in order of creation then go without moving others.
    while (!entities.empty()) {
        if (!observed_) entities = entities.first(store_->destroy_last(entities));
        if (entities.empty()) return;
        destroy(entities.back());
        entities = entities.first(entities.size() - 1);
    }
}

void World::destroy_tables(const std::vector<detail::Table*>& tables) {
    store_->lock().assert_idle();
    // Collected first: a parent moves to another table when its last child goes.
    std::vector<Entity> one_by_one;
    for (detail::Table* table : tables) {
        if (!observed_ && !table->in_tree) {
            store_->destroy_all(*table);
            continue;
        }
        for (const std::uint32_t chunk : table->chunks()) {
            const auto rows = table->entities(chunk);
            one_by_one.insert(one_by_one.end(), rows.begin(), rows.end());
        }
    }
    destroy_many(one_by_one);
}

void World::clear() {
    store_->lock().assert_idle();
    if (observed_)
        for (const auto& table : store_->tables())
            for (const std::uint32_t chunk : table->chunks())
                for (const Entity entity : table->entities(chunk)) notify_removed(entity);
    for (const auto& table : store_->tables()) store_->destroy_all(*table);
}

EntityIds World::entity_ids() const { return store_->ids().ids(); }

void World::restore_entities(const EntityIds& ids) {
    HACHURE_ASSERT(commands_->empty(), "commands that wait are applied before handles are restored");
    clear();
    store_->forget_changes();
    store_->ids().restore(ids, [this](Entity entity) { revive(entity); });
}

void World::notify(const std::deque<detail::Observer>& observers, Entity entity) {
    const detail::IterationLock::Guard guard(store_->lock());
    // By number: an observer may add observers.
    for (std::size_t i = 0; i < observers.size(); ++i) observers[i](*this, entity);
}

void World::notify_added(Entity entity) {
    for (detail::ComponentRecord* component : store_->observed_components(entity)) notify(component->added, entity);
}

void World::notify_added(std::span<const Entity> entities) {
    for (const Entity entity : entities) notify_added(entity);
}

void World::notify_removed(Entity entity) {
    for (detail::ComponentRecord* component : store_->observed_components(entity)) notify(component->removed, entity);
}

Tick World::advance_tick() {
    store_->lock().assert_idle();
    store_->advance_tick();
    return tick();
}

void World::forget_removed_before(Tick tick) { store_->removals().forget_before(tick); }

void World::apply_commands() { commands_->apply(*this); }

void World::require_alive(Entity entity) const {
    if (!alive(entity)) throw DeadEntity(entity);
}

void World::throw_missing(Entity entity, std::string_view component) const {
    require_alive(entity);
    throw MissingComponent(entity, component);
}

} // namespace hachure
