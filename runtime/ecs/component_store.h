#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/sparse_index.h>
#include <hachure/runtime/ecs/tick.h>
#include <hachure/runtime/ecs/type_id.h>

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace hachure::detail {

/// Every entity that has one type of component, with its ticks: all of a store that does not depend on the type.
/// Columns are packed; row r of each belongs to entity r.
class StoreBase {
public:
    virtual ~StoreBase() = default;

    /// Takes the component off `entity`; false when it has none.
    virtual bool erase(Entity entity, Tick now) = 0;

    std::span<const Entity> entities() const { return entities_; }

    /// The row of `entity`, or no_row.
    std::uint32_t row(Entity entity) const {
        const std::uint32_t found = index_.find(entity.index);
        return found != no_row && entities_[found] == entity ? found : no_row;
    }

    /// The same for the slot of an entity that is known to be alive.
    std::uint32_t row_of_live(Entity entity) const { return index_.find(entity.index); }

    Tick added(std::uint32_t row) const { return added_[row]; }
    Tick changed(std::uint32_t row) const { return changed_[row]; }

    /// When anything in this store was last added, changed or removed; 0 when nothing ever was.
    Tick last_changed() const { return last_changed_; }

    void mark_changed(std::uint32_t row, Tick now) {
        changed_[row] = now;
        last_changed_ = now;
    }

    /// Entities that lost the component after tick `since`, in order of time.
    std::span<const Entity> removed_since(Tick since) const;

    /// Forgets removals of ticks before `tick`.
    void forget_removed_before(Tick tick);

protected:
    /// Appends the row of `entity`, which has none.
    void push_row(Entity entity, Tick now);

    /// Moves the last row into `row`, drops the last, and remembers the removal.
    void erase_row(std::uint32_t row, Tick now);

private:
    SparseIndex index_;
    std::vector<Entity> entities_;
    std::vector<Tick> added_;
    std::vector<Tick> changed_;
    std::vector<Entity> removed_;
    std::vector<Tick> removed_ticks_; ///< ascending, parallel to removed_
    Tick last_changed_ = 0;
};

/// The components of type C of a world.
template <class C> class ComponentStore final : public StoreBase {
public:
    C& value(std::uint32_t row) { return values_[row]; }
    const C& value(std::uint32_t row) const { return values_[row]; }

    /// Gives `entity`, which has none, a component.
    C& insert(Entity entity, C&& value, Tick now) {
        values_.push_back(std::move(value));
        push_row(entity, now);
        return values_.back();
    }

    bool erase(Entity entity, Tick now) override {
        const std::uint32_t found = row(entity);
        if (found == no_row) return false;
        if (found + 1 != values_.size()) values_[found] = std::move(values_.back());
        values_.pop_back();
        erase_row(found, now);
        return true;
    }

private:
    std::vector<C> values_;
};

/// The stores of a world, by type of component. A store stays where it is while the world lives.
class StoreTable {
public:
    /// The store of a type, or null when no entity ever had it.
    StoreBase* find(TypeId id) { return id < stores_.size() ? stores_[id].get() : nullptr; }
    const StoreBase* find(TypeId id) const { return id < stores_.size() ? stores_[id].get() : nullptr; }

    template <class C> ComponentStore<C>* find() { return static_cast<ComponentStore<C>*>(find(component_id<C>())); }
    template <class C> const ComponentStore<C>* find() const {
        return static_cast<const ComponentStore<C>*>(find(component_id<C>()));
    }

    /// The store of a type, made when absent.
    template <class C> ComponentStore<C>& ensure() {
        const TypeId id = component_id<C>();
        if (id >= stores_.size()) stores_.resize(id + 1);
        if (!stores_[id]) stores_[id] = std::make_unique<ComponentStore<C>>();
        return static_cast<ComponentStore<C>&>(*stores_[id]);
    }

    /// Indexed by type; some are null.
    std::span<const std::unique_ptr<StoreBase>> all() { return stores_; }

private:
    std::vector<std::unique_ptr<StoreBase>> stores_;
};

} // namespace hachure::detail
