#include <hachure/runtime/ecs/commands.h>
#include <hachure/runtime/ecs/world.h>

namespace hachure {

World::World() : entities_(std::make_shared<detail::EntityTable>()), commands_(std::make_unique<Commands>(*this)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Entity World::create() {
    lock_.assert_idle();
    const Entity entity = entities_->reserve();
    entities_->activate(entity);
    return entity;
}

bool World::destroy(Entity entity) {
    if (!alive(entity)) return false;
    lock_.assert_idle();
    detach(entity);
    const std::vector<Entity> below = descendants(entity);
    erase_components(entity);
    entities_->release(entity);
    for (const Entity descendant : below) {
        erase_components(descendant);
        entities_->release(descendant);
    }
    return true;
}

void World::destroy_many(std::span<const Entity> entities) {
    for (const Entity entity : entities) destroy(entity);
}

void World::clear() {
    const auto live = entities_->entities();
    destroy_many(std::vector<Entity>(live.begin(), live.end()));
}

EntityIds World::entity_ids() const { return entities_->ids(); }

void World::restore_entities(const EntityIds& ids) {
    clear();
    entities_->restore(ids);
}

void World::erase_components(Entity entity) {
    for (const auto& store : stores_.all())
        if (store) store->erase(entity, tick_);
}

Tick World::advance_tick() {
    lock_.assert_idle();
    return ++tick_;
}

void World::forget_removed_before(Tick tick) {
    for (const auto& store : stores_.all())
        if (store) store->forget_removed_before(tick);
}

void World::apply_commands() { commands_->apply(*this); }

void World::require_alive(Entity entity) const {
    if (!alive(entity)) throw DeadEntity(entity);
}

void World::throw_missing(Entity entity, std::string_view component) const {
    require_alive(entity);
    throw MissingComponent(entity, component);
}

} // namespace hachure
