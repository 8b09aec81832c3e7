#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/commands.h>

namespace hachure {

Commands::Commands(World& world) : entities_(world.store_->shared_ids()) {}

Commands& Commands::operator=(Commands&& other) noexcept {
    if (this != &other) {
        clear();
        entities_ = std::move(other.entities_);
        queued_ = std::move(other.queued_);
        columns_ = std::move(other.columns_);
    }
    return *this;
}

Commands::~Commands() { clear(); }

Entity Commands::create() {
    const Entity entity = entities_->promise();
    queue({Action::create, entity});
    return entity;
}

void Commands::apply(World& world) {
    HACHURE_ASSERT(entities_ == world.store_->shared_ids(), "commands are applied to the world they were made for");
    if (queued_.empty()) return;
    world.store_->lock().assert_idle();

    struct ClearAtEnd {
        Commands& commands;
        ~ClearAtEnd() { commands.clear(); }
    } const clear_at_end{*this};
    // By number, and copied: an observer may queue more.
    for (std::size_t i = 0; i < queued_.size(); ++i) execute(world, Command(queued_[i]));
}

void Commands::execute(World& world, const Command& command) {
    if (command.action == Action::create) return world.revive(command.entity);
    if (!world.alive(command.entity)) return;
    switch (command.action) {
    case Action::create:
        break;
    case Action::destroy:
        world.destroy(command.entity);
        break;
    case Action::add:
        columns_[command.component]->add(world, command.entity, command.value);
        break;
    case Action::remove:
        columns_[command.component]->remove(world, command.entity);
        break;
    case Action::set_parent:
        if (world.alive(command.parent)) world.set_parent(command.entity, command.parent);
        break;
    case Action::clear_parent:
        world.clear_parent(command.entity);
        break;
    }
}

void Commands::clear() {
    // After `apply` the created ones are alive, or destroyed and so of an older generation; neither is reserved.
    for (const Command& command : queued_)
        if (command.action == Action::create && entities_->reserved(command.entity)) entities_->release(command.entity);
    queued_.clear();
    for (const auto& column : columns_)
        if (column) column->clear();
}

} // namespace hachure
