#pragma once

#include <hachure/runtime/ecs/query/query_cache.h>
#include <hachure/runtime/ecs/storage/chunk_directory.h>
#include <hachure/runtime/ecs/storage/component_record.h>
#include <hachure/runtime/ecs/storage/entity_table.h>
#include <hachure/runtime/ecs/storage/iteration_lock.h>
#include <hachure/runtime/ecs/storage/removal_log.h>
#include <hachure/runtime/ecs/storage/sparse_store.h>
#include <hachure/runtime/ecs/storage/table.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace hachure::detail {

class FilteredWalk;

/// The entities of a world with their components: rows of tables, one table per set of components, and sparse stores
/// beside them. It knows nothing of the tree, and checks nothing that `World` has checked.
class EntityStore {
public:
    EntityStore();
    ~EntityStore();
    EntityStore(const EntityStore&) = delete;
    EntityStore& operator=(const EntityStore&) = delete;

    EntityTable& ids() { return *ids_; }
    const EntityTable& ids() const { return *ids_; }

    /// Shared with queues of commands, which reserve ids.
    const std::shared_ptr<EntityTable>& shared_ids() const { return ids_; }

    IterationLock& lock() const { return lock_; }
    Tick tick() const { return tick_; }
    void advance_tick() { ++tick_; }
    const ChunkDirectory& chunks() const { return chunks_; }

    // Components.

    /// Null when no entity ever had the component.
    ComponentRecord* find_record(TypeId id) const { return id < records_.size() ? records_[id].get() : nullptr; }

    /// Made when absent.
    template <class C> ComponentRecord& record() {
        ComponentRecord* found = find_record(component_id<C>());
        return found ? *found : make_record(component_info<C>());
    }

    /// `id` where every chunk has an offset for the component, which may be 0; else 0, for which all have that. It
    /// holds until a component gets its record.
    TypeId known(TypeId id) const { return id < width_ ? id : 0; }

    /// Where the column of a component begins in a chunk; 0 where the chunk has none.
    std::uint32_t offset(std::uint32_t chunk, TypeId id) const { return id < width_ ? chunks_[chunk].offsets[id] : 0; }

    /// The value of C of an entity, or null when it is dead or has none. `at` is where it was found.
    template <class C> C* find(Entity entity, Location& at) const {
        const Location row = ids_->find(entity);
        return row ? find_at<C>(entity, row, at) : nullptr;
    }

    /// The same for a live entity with its row in the tables.
    template <class C> C* find_at(Entity entity, Location row, Location& at) const {
        if constexpr (is_sparse<C>) {
            at = locate<C>(entity, row);
            if (!at) return nullptr;
            const Table& table = find_record(component_id<C>())->sparse->table;
            return reinterpret_cast<C*>(Table::value(chunks_[at.chunk()].data, table.columns().front(), at.row()));
        }
        at = row;
        // How many look-ups are on their way from memory at once depends on how few instructions each takes: a number
        // that is not there yet is asked for only where nothing was found.
        const TypeId id = type_id_of<TypeFamily::component, C>;
        if (C* value = value_at<C>(at, id)) return value;
        return id == 0 ? find_unnumbered<C>(at) : nullptr;
    }

    /// Where the value of C of a live entity is, whose row in the tables is `row`; nowhere when it has none.
    template <class C> Location locate(Entity entity, Location row) const {
        if constexpr (is_sparse<C>) {
            const ComponentRecord* component = find_record(component_id<C>());
            return component ? component->sparse->find(entity) : Location{};
        }
        return offset(row.chunk(), component_id<C>()) != 0 ? row : Location{};
    }

    /// The ticks of a component of type `id` whose value is in row `at`.
    ColumnTicks& ticks(TypeId id, Location at) const { return chunks_.ticks(at.chunk())[table_of(at).column(id)]; }

    /// Marks the component of type `id`, in row `at`, changed in tick `now`.
    void mark(TypeId id, Entity entity, Location at, Tick now) const {
        const Table& table = table_of(at);
        const std::uint32_t column = table.column(id);
        if (chunks_.ticks(at.chunk())[column].mark(at.row(), table.capacity(), now))
            table.columns()[column].component->log.note(entity, now);
    }

    /// Marks a whole column of a chunk changed.
    void mark_chunk(const Table& table, std::uint32_t chunk, std::uint32_t column, Tick now) const;

    /// When the component of type `id` of an entity was last changed, or added; 0 when it is dead or has none.
    Tick changed(TypeId id, Entity entity) const;
    Tick added(TypeId id, Entity entity) const;

    // Tables.

    std::span<const std::unique_ptr<Table>> tables() const { return tables_; }
    Table& empty_table() const { return *tables_.front(); }
    Table& table_of(Location at) const { return chunks_.table(at.chunk()); }

    /// The way to the table that has `component` besides those of `table`, which lacks it; or is without it.
    const Transition& adding(Table& table, ComponentRecord& component) {
        const TypeId id = component.info->id;
        return id < table.adding.size() && table.adding[id] ? *table.adding[id] : find_adding(table, component);
    }
    const Transition& removing(Table& table, ComponentRecord& component) {
        const TypeId id = component.info->id;
        return id < table.removing.size() && table.removing[id] ? *table.removing[id] : find_removing(table, component);
    }

    /// The table of those of C... that are kept in tables.
    template <class... C> Table& table_for() {
        const TypeId id = type_id<TypeFamily::bundle, TypeList<C...>>();
        if (id < bundles_.size() && bundles_[id]) return *bundles_[id];
        return remember_bundle(id, {&record<C>()...});
    }

    const QueryCache& query_cache(TypeId query, QueryCache::Matches matches) {
        return query_caches_.get(query, matches, tables_);
    }

    /// Working memory of a walk, to be given back at its end.
    FilteredWalk* begin_walk();
    void end_walk(FilteredWalk* walk);

    // Rows.

    /// A new entity with a row in `table`.
    Entity create(Table& table) {
        const Entity entity = ids_->reserve();
        ids_->activate(entity, table.append(entity));
        return entity;
    }

    /// New entities with rows in one chunk of `table`, up to `wanted` of them and at least one; ticks are set. The
    /// values are the caller's to construct.
    Table::Rows create_rows(Table& table, std::size_t wanted, Tick now);

    /// Takes those of new rows back that follow the first `made`, whose values were never constructed.
    void drop_raw_rows(Table::Rows rows, std::uint32_t made);

    /// A new entity in `to` with copies of the components of `from` that `to` has, and of its sparse ones.
    Entity copy(Entity from, Table& to);

    /// Lets the components of an entity follow to copies.
    void remap(Entity entity, const EntityMap& copies);

    /// The components of an entity that have observers.
    std::vector<ComponentRecord*> observed_components(Entity entity) const;

    /// Constructs the component of an entity that has none, whose row in the tables is `row`, with a column for it.
    template <class C> C& emplace(Entity entity, Location row, ComponentRecord& component, C&& value) {
        if constexpr (is_sparse<C>)
            return construct(component.sparse->table, component.sparse->append(entity), 0, entity, std::move(value));
        Table& table = table_of(row);
        return construct(table, row, table.column(component_id<C>()), entity, std::move(value));
    }

    /// Takes the entity with the row `from` to the table that has `component` besides. Its value is the caller's to
    /// construct. The new row.
    Location move_adding(Entity entity, Location from, ComponentRecord& component) {
        return move(entity, from, adding(table_of(from), component));
    }

    /// Takes the component off an entity that has it; `at` is where its value is. The second is for sparse components.
    void remove(Entity entity, Location at, ComponentRecord& component);
    void remove_sparse(Entity entity, Location at, ComponentRecord& component);

    /// Ends a live entity with its components.
    void destroy(Entity entity);

    /// Ends entities from the last of the list on, as long as they are dead or in one table without tree and observers.
    /// How many of the list are left.
    std::size_t destroy_last(std::span<const Entity> entities);

    /// Ends every entity of a table.
    void destroy_all(Table& table);

    /// Gives the queues of changes of this tick up: handles that they list come back to life, and a queue holds an
    /// entity once per tick.
    void forget_changes();

    RemovalLog& removals() { return removals_; }
    const RemovalLog& removals() const { return removals_; }

    /// Sets `Table::observed` of every table; called when observers have come.
    void update_observed();

private:
    /// While the program starts. [[gnu::pure]]: that it may number a type is nothing a caller can see.
    template <class C> [[gnu::pure, gnu::cold, gnu::noinline]] C* find_unnumbered(Location at) const {
        return value_at<C>(at, component_id<C>());
    }
    template <class C> C* value_at(Location at, TypeId id) const {
        const std::uint32_t column = offset(at.chunk(), id);
        if (column == 0) return nullptr;
        return reinterpret_cast<C*>(chunks_[at.chunk()].data + column + std::size_t{at.row()} * stride_of<C>);
    }
    template <class C> C& construct(Table& table, Location at, std::uint32_t column, Entity entity, C&& value) {
        const Table::Column& place = table.columns()[column];
        std::byte* memory = Table::value(chunks_[at.chunk()].data, place, at.row());
        C* result = new (memory) C(std::move(value));
        note_added(table, at, column, *place.component, entity);
        return *result;
    }

    /// A column's component has been constructed in the row of `entity`, which was appended last.
    void note_added(Table& table, Location at, std::size_t column, ComponentRecord& component, Entity entity) {
        table.set_ticks(at, column, tick_, tick_);
        component.log.note_added(entity, tick_);
    }
    Location move(Entity entity, Location from, const Transition& transition);
    ComponentRecord& make_record(const ComponentInfo& info);
    Table& find_table(std::vector<ComponentRecord*> components);
    const Transition& find_adding(Table& table, ComponentRecord& component);
    const Transition& find_removing(Table& table, ComponentRecord& component);
    Table& remember_bundle(TypeId id, std::vector<ComponentRecord*> components);
    void end_row(Entity entity, Location at, Table& table);
    void erase_sparse(Entity entity);
    Location find_component(TypeId id, Entity entity) const;
    void forget_change(Entity entity, ComponentRecord& component, Tick changed);

    std::shared_ptr<EntityTable> ids_;
    ChunkDirectory chunks_; // before all tables, which give their chunks back
    std::vector<std::unique_ptr<ComponentRecord>> records_;
    std::vector<std::unique_ptr<Table>> tables_; ///< the first is that of no components
    std::vector<Table*> bundles_;                ///< by type of bundle; some are null
    std::vector<ComponentRecord*> sparse_;       ///< those with sparse storage
    static constexpr std::size_t width_step = 32;
    std::size_t width_ = width_step; ///< every table has offsets for so many components
    RemovalLog removals_;
    QueryCaches query_caches_;
    std::vector<std::unique_ptr<FilteredWalk>> walks_; ///< those not in use
    std::mutex walks_mutex_;
    mutable IterationLock lock_;
    Tick tick_ = 1;
};

} // namespace hachure::detail
