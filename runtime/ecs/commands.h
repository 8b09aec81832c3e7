#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/storage/entity_table.h>
#include <hachure/runtime/ecs/world.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace hachure {

/// Structural changes of a world, queued to be applied later: the way to change what a query is walking. Commands take
/// effect in the order in which they were queued. One on an entity that is dead by then is dropped.
///
/// `World::commands()` is the world's own queue. A queue keeps its memory between uses.
class Commands {
public:
    /// A queue for `world`.
    explicit Commands(World& world);
    Commands(Commands&&) noexcept = default;
    Commands& operator=(Commands&& other) noexcept;
    ~Commands();

    /// Reserves an entity, which becomes alive when the queue is applied. Until then only commands may name it.
    Entity create();

    /// As `World::destroy`.
    void destroy(Entity entity) { queue({Action::destroy, entity}); }

    /// As `World::add`.
    template <Component C> void add(Entity entity, C value = {}) {
        static_assert(!detail::managed_by_world<C>, "Parent and Children change through set_parent and clear_parent");
        auto& values = column<C>().values;
        queue({Action::add, entity, Entity::null, detail::component_id<C>(), values.size()});
        values.push_back(std::move(value));
    }

    /// As `World::remove`.
    template <Component C> void remove(Entity entity) {
        static_assert(!detail::managed_by_world<C>, "Parent and Children change through set_parent and clear_parent");
        column<C>();
        queue({Action::remove, entity, Entity::null, detail::component_id<C>()});
    }

    /// As `World::set_parent`; dropped when either entity is dead by then.
    void set_parent(Entity child, Entity parent) { queue({Action::set_parent, child, parent}); }

    /// As `World::clear_parent`.
    void clear_parent(Entity child) { queue({Action::clear_parent, child}); }

    bool empty() const { return queued_.empty(); }

    /// Carries out and forgets all commands on `world`, the one that this queue is for. Asserts while a query of it is
    /// walked. Throws HierarchyCycle for a `set_parent` that would close a cycle; the commands after it are forgotten.
    void apply(World& world);

    /// Forgets all commands; entities that they were to create are dead for good.
    void clear();

private:
    enum class Action { create, destroy, add, remove, set_parent, clear_parent };

    struct Command {
        Action action;
        Entity entity;
        Entity parent = {};
        detail::TypeId component = 0;
        std::size_t value = 0; ///< in the column of the component
    };

    /// The values of one type that are waiting to be added.
    struct ColumnBase {
        virtual ~ColumnBase() = default;
        virtual void add(World& world, Entity entity, std::size_t value) = 0;
        virtual void remove(World& world, Entity entity) = 0;
        virtual void clear() = 0;
    };

    template <class C> struct Column final : ColumnBase {
        std::vector<C> values;
        void add(World& world, Entity entity, std::size_t value) override {
            world.add<C>(entity, std::move(values[value]));
        }
        void remove(World& world, Entity entity) override { world.remove<C>(entity); }
        void clear() override { values.clear(); }
    };

    template <class C> Column<C>& column() {
        const detail::TypeId id = detail::component_id<C>();
        if (id >= columns_.size()) columns_.resize(id + 1);
        if (!columns_[id]) columns_[id] = std::make_unique<Column<C>>();
        return static_cast<Column<C>&>(*columns_[id]);
    }

    void queue(Command command) { queued_.push_back(command); }
    void execute(World& world, const Command& command);

    std::shared_ptr<detail::EntityTable> entities_;
    std::vector<Command> queued_;
    std::vector<std::unique_ptr<ColumnBase>> columns_; ///< by component; some are null
};

} // namespace hachure
