#include <hachure/runtime/ecs/hierarchy.h>
#include <hachure/runtime/ecs/query/query_filter.h>
#include <hachure/runtime/ecs/storage/entity_store.h>

#include <algorithm>

namespace hachure::detail {
namespace {

TypeId id_of(const ComponentRecord* component) { return component->info->id; }

const Transition& remember(const Table& from, std::vector<std::unique_ptr<Transition>>& transitions, Table& to,
                           const ComponentRecord& component) {
    auto transition = std::make_unique<Transition>();
    transition->to = &to;
    for (std::uint16_t i = 0; i < from.columns().size(); ++i) {
        const auto& column = from.columns()[i];
        const ComponentInfo& info = *column.component->info;
        if (!to.has(info.id)) continue;
        const auto j = static_cast<std::uint16_t>(to.column(info.id));
        transition->shared.push_back({column, to.offset(info.id), i, j});
    }
    const TypeId id = component.info->id;
    if (id >= transitions.size()) transitions.resize(id + 1);
    transitions[id] = std::move(transition);
    return *transitions[id];
}

} // namespace

EntityStore::~EntityStore() = default;

EntityStore::EntityStore() : ids_(std::make_shared<EntityTable>()) {
    records_.resize(width_);
    find_table({});
}

ComponentRecord& EntityStore::make_record(const ComponentInfo& info) {
    if (info.id >= width_) {
        width_ = (info.id / width_step + 1) * width_step;
        records_.resize(width_);
        for (const auto& table : tables_) table->widen(width_);
        for (ComponentRecord* component : sparse_) component->sparse->table.widen(width_);
    }
    auto& record = records_[info.id];
    record = std::make_unique<ComponentRecord>(info);
    if (info.storage == Storage::sparse) {
        record->sparse = std::make_unique<SparseStore>(*record, chunks_);
        record->sparse->table.widen(width_);
        sparse_.push_back(record.get());
    }
    return *record;
}

Table& EntityStore::find_table(std::vector<ComponentRecord*> components) {
    std::ranges::sort(components, {}, id_of);
    const auto same = [&components](const std::unique_ptr<Table>& table) {
        return std::ranges::equal(table->columns(), components, {}, &Table::Column::component);
    };
    if (const auto found = std::ranges::find_if(tables_, same); found != tables_.end()) return **found;
    const auto index = static_cast<std::uint32_t>(tables_.size());
    tables_.push_back(std::make_unique<Table>(index, components, chunks_, *ids_));
    tables_.back()->widen(width_);
    tables_.back()->in_tree =
        tables_.back()->has(component_id<Parent>()) || tables_.back()->has(component_id<Children>());
    update_observed();
    return *tables_.back();
}

const Transition& EntityStore::find_adding(Table& table, ComponentRecord& component) {
    std::vector<ComponentRecord*> components{&component};
    for (const auto& column : table.columns()) components.push_back(column.component);
    return remember(table, table.adding, find_table(std::move(components)), component);
}

const Transition& EntityStore::find_removing(Table& table, ComponentRecord& component) {
    std::vector<ComponentRecord*> components;
    for (const auto& column : table.columns())
        if (column.component != &component) components.push_back(column.component);
    return remember(table, table.removing, find_table(std::move(components)), component);
}

Table& EntityStore::remember_bundle(TypeId id, std::vector<ComponentRecord*> components) {
    std::erase_if(components, [](const ComponentRecord* component) { return component->sparse != nullptr; });
    if (id >= bundles_.size()) bundles_.resize(id + 1);
    bundles_[id] = &find_table(std::move(components));
    return *bundles_[id];
}

void EntityStore::mark_chunk(const Table& table, std::uint32_t chunk, std::uint32_t column, Tick now) const {
    // A table of a few entities does not make the queue of a component useless that many others have.
    constexpr std::uint32_t few = 64;
    ColumnTicks& ticks = chunks_.ticks(chunk)[column];
    ChangeLog& log = table.columns()[column].component->log;
    const auto entities = table.entities(chunk);
    if (entities.size() > few) {
        log.note_many(now);
    } else {
        for (std::uint32_t row = 0; row < entities.size(); ++row)
            if (ticks.changed(row) != now) log.note(entities[row], now);
    }
    ticks.mark_all(now);
}

Location EntityStore::find_component(TypeId id, Entity entity) const {
    const Location row = ids_->find(entity);
    const ComponentRecord* component = find_record(id);
    if (!row || !component) return {};
    if (component->sparse) return component->sparse->find(entity);
    return table_of(row).has(id) ? row : Location{};
}

Tick EntityStore::changed(TypeId id, Entity entity) const {
    const Location at = find_component(id, entity);
    return at ? ticks(id, at).changed(at.row()) : 0;
}

Tick EntityStore::added(TypeId id, Entity entity) const {
    const Location at = find_component(id, entity);
    return at ? ticks(id, at).added(at.row()) : 0;
}

FilteredWalk* EntityStore::begin_walk() {
    const std::scoped_lock lock(walks_mutex_);
    if (walks_.empty()) return std::make_unique<FilteredWalk>().release();
    FilteredWalk* walk = walks_.back().release();
    walks_.pop_back();
    return walk;
}

void EntityStore::end_walk(FilteredWalk* walk) {
    const std::scoped_lock lock(walks_mutex_);
    walks_.emplace_back(walk);
}

void EntityStore::update_observed() {
    const auto observed = [](const Table::Column& column) { return column.component->observed(); };
    for (const auto& table : tables_) table->observed = std::ranges::any_of(table->columns(), observed);
}

Table::Rows EntityStore::create_rows(Table& table, std::size_t wanted, Tick now) {
    const Table::Rows rows = table.append_rows(wanted);
    const std::uint32_t chunk = rows.first.chunk();
    const std::uint32_t first = rows.first.row();
    auto* entities = reinterpret_cast<Entity*>(chunks_[chunk].data);
    for (std::uint32_t row = first; row < first + rows.count; ++row) {
        entities[row] = ids_->reserve();
        ids_->activate(entities[row], {chunk, row});
    }
    for (std::size_t i = 0; i < table.columns().size(); ++i) {
        table.ticks(chunk)[i].place_many(first, rows.count, table.capacity(), now);
        table.columns()[i].component->log.note_many_added({entities + first, rows.count}, now);
    }
    return rows;
}

void EntityStore::drop_raw_rows(Table::Rows rows, std::uint32_t made) {
    Table& table = table_of(rows.first);
    for (const auto& column : table.columns()) column.component->log.note_removed(rows.count - made, tick_);
    for (std::uint32_t i = rows.count; i-- > made;) {
        const Location at(rows.first.chunk(), rows.first.row() + i);
        const Entity entity = table.entities(at.chunk())[at.row()];
        table.drop_row(at);
        ids_->release(entity);
    }
}

Entity EntityStore::copy(Entity from, Table& to) {
    const Entity entity = create(to);
    const Location source = ids_->find(from);
    const Location at = ids_->find(entity);
    const Table& table = table_of(source);
    for (std::size_t i = 0; i < to.columns().size(); ++i) {
        ComponentRecord& component = *to.columns()[i].component;
        component.info->copy(to.value(at, i), table.value(source, table.column(component.info->id)));
        note_added(to, at, i, component, entity);
    }
    for (ComponentRecord* component : sparse_) {
        const Location sparse_source = component->sparse->find(from);
        if (!sparse_source || !component->info->copy) continue;
        Table& values = component->sparse->table;
        const Location place = component->sparse->append(entity);
        component->info->copy(values.value(place, 0), values.value(sparse_source, 0));
        note_added(values, place, 0, *component, entity);
    }
    return entity;
}

void EntityStore::remap(Entity entity, const EntityMap& copies) {
    const Location at = ids_->find(entity);
    const Table& table = table_of(at);
    for (std::size_t i = 0; i < table.columns().size(); ++i)
        if (const auto remap = table.columns()[i].component->info->remap) remap(table.value(at, i), copies);
    for (const ComponentRecord* component : sparse_) {
        const Location place = component->sparse->find(entity);
        if (place && component->info->remap) component->info->remap(component->sparse->table.value(place, 0), copies);
    }
}

std::vector<ComponentRecord*> EntityStore::observed_components(Entity entity) const {
    std::vector<ComponentRecord*> result;
    const Table& table = table_of(ids_->find(entity));
    if (table.observed)
        for (const auto& column : table.columns())
            if (column.component->observed()) result.push_back(column.component);
    for (ComponentRecord* component : sparse_)
        if (component->observed() && component->sparse->find(entity)) result.push_back(component);
    return result;
}

Location EntityStore::move(Entity entity, Location from, const Transition& transition) {
    Table& to = *transition.to;
    const Location at = to.append(entity);
    ids_->set_row(entity, at);
    const std::uint32_t row = at.row(), from_row = from.row(), capacity = to.capacity();
    std::byte* const source = chunks_[from.chunk()].data;
    std::byte* const target = chunks_[at.chunk()].data;
    const ColumnTicks* const source_ticks = chunks_.ticks(from.chunk());
    ColumnTicks* const target_ticks = chunks_.ticks(at.chunk());
    const Transition::Shared* const end = transition.shared.data() + transition.shared.size();
    for (const Transition::Shared* column = transition.shared.data(); column != end; ++column) {
        std::byte* const new_value = target + column->to_offset + std::size_t{row} * column->from.stride;
        Table::relocate(column->from, new_value, Table::value(source, column->from, from_row));
        target_ticks[column->to_column].place(row, row, capacity, source_ticks[column->from_column], from_row);
    }
    table_of(from).drop_row(from);
    return at;
}

void EntityStore::forget_change(Entity entity, ComponentRecord& component, Tick changed) {
    if (changed == tick_) component.log.forget(entity, tick_);
}

void EntityStore::remove(Entity entity, Location at, ComponentRecord& component) {
    Table& table = table_of(at);
    const std::uint32_t column = table.column(component.info->id);
    forget_change(entity, component, table.ticks(at.chunk())[column].changed(at.row()));
    if (!component.info->trivial) component.info->destroy(table.value(at, column));
    move(entity, at, removing(table, component));
    component.log.note_removed(1, tick_);
    removals_.note_removed(entity, component.info->id, tick_);
}

void EntityStore::remove_sparse(Entity entity, Location at, ComponentRecord& component) {
    forget_change(entity, component, component.sparse->table.ticks(at.chunk())[0].changed(at.row()));
    component.sparse->erase(entity, at);
    component.log.note_removed(1, tick_);
    removals_.note_removed(entity, component.info->id, tick_);
}

void EntityStore::erase_sparse(Entity entity) {
    for (ComponentRecord* component : sparse_)
        if (const Location at = component->sparse->find(entity)) remove_sparse(entity, at, *component);
}

void EntityStore::destroy(Entity entity) {
    const Location at = ids_->find(entity);
    Table& table = table_of(at);
    for (const auto& column : table.columns()) column.component->log.note_removed(1, tick_);
    end_row(entity, at, table);
}

void EntityStore::end_row(Entity entity, Location at, Table& table) {
    if (!sparse_.empty()) erase_sparse(entity);
    if (!table.columns().empty()) removals_.note_destroyed(entity, table, tick_);
    table.destroy_values(at);
    table.drop_row(at);
    ids_->release(entity);
}

std::size_t EntityStore::destroy_last(std::span<const Entity> entities) {
    Table* table = nullptr;
    std::size_t rows = 0, left = entities.size();
    for (; left > 0; --left) {
        const Entity entity = entities[left - 1];
        const Location at = ids_->find(entity);
        if (!at) continue;
        if (table != &table_of(at)) {
            if (table || table_of(at).in_tree || table_of(at).observed) break;
            table = &table_of(at);
        }
        end_row(entity, at, *table);
        ++rows;
    }
    if (table)
        for (const auto& column : table->columns()) column.component->log.note_removed(rows, tick_);
    return left;
}

void EntityStore::forget_changes() {
    for (const auto& component : records_)
        if (component && component->log.last_changed() == tick_) component->log.note_many(tick_);
}

void EntityStore::destroy_all(Table& table) {
    for (const auto& column : table.columns()) column.component->log.note_removed(table.size(), tick_);
    for (const std::uint32_t chunk : table.chunks()) {
        const auto entities = table.entities(chunk);
        if (!sparse_.empty())
            for (const Entity entity : entities) erase_sparse(entity);
        if (!table.columns().empty()) removals_.note_destroyed(entities, table, tick_);
        for (const Entity entity : entities) ids_->release(entity);
    }
    table.clear();
}

} // namespace hachure::detail
