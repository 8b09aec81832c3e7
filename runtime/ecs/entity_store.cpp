#include <hachure/runtime/ecs/entity_store.h>
#include <hachure/runtime/ecs/query_filter.h>

#include <algorithm>

namespace hachure::detail {
namespace {

TypeId id_of(const ComponentRecord* component) { return component->info->id; }

} // namespace

ComponentRecord::ComponentRecord(const ComponentInfo& of) : info(&of) {}
ComponentRecord::~ComponentRecord() = default;

EntityStore::~EntityStore() = default;

EntityStore::EntityStore() : ids_(std::make_shared<EntityTable>()) { find_table({}); }

ComponentRecord& EntityStore::make_record(const ComponentInfo& info) {
    if (info.id >= records_.size()) records_.resize(info.id + 1);
    auto& record = records_[info.id];
    record = std::make_unique<ComponentRecord>(info);
    if (info.storage == Storage::sparse) {
        record->sparse = std::make_unique<SparseStore>(*record, chunks_);
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
    tables_.push_back(std::make_unique<Table>(index, components, chunks_));
    update_observed();
    return *tables_.back();
}

Table& EntityStore::link(Table& table, ComponentRecord& component) {
    std::vector<ComponentRecord*> components{&component};
    for (const auto& column : table.columns()) components.push_back(column.component);
    Table& result = find_table(std::move(components));
    const TypeId id = component.info->id;
    if (table.with.size() <= id) table.with.resize(id + 1);
    if (result.without.size() <= id) result.without.resize(id + 1);
    table.with[id] = &result;
    result.without[id] = &table;
    return result;
}

Table& EntityStore::unlink(Table& table, ComponentRecord& component) {
    std::vector<ComponentRecord*> components;
    for (const auto& column : table.columns())
        if (column.component != &component) components.push_back(column.component);
    Table& result = find_table(std::move(components));
    link(result, component);
    return result;
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
    const std::uint32_t rows = table.rows_of_chunk(chunk);
    if (rows > few) {
        log.note_many(now);
    } else {
        for (std::uint32_t row = 0; row < rows; ++row)
            if (ticks.changed(row) != now) log.note(table.entities(chunk)[row], now);
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
    const auto observed = [](const Table::Column& column) {
        return !column.component->added.empty() || !column.component->removed.empty();
    };
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

Entity EntityStore::copy(Entity from, Table& to) {
    const Entity entity = create(to);
    const Location source = ids_->find(from);
    const Location at = ids_->find(entity);
    const Table& table = table_of(source);
    for (std::size_t i = 0; i < to.columns().size(); ++i) {
        ComponentRecord& component = *to.columns()[i].component;
        component.info->copy(to.value(at, i), table.value(source, table.find(component.info->id).column));
        to.set_ticks(at, i, tick_, tick_);
        component.log.note_added(entity, tick_);
    }
    for (ComponentRecord* component : sparse_) {
        const Location sparse_source = component->sparse->find(from);
        if (!sparse_source || !component->info->copy) continue;
        Table& values = component->sparse->table;
        const Location place = component->sparse->append(entity);
        component->info->copy(values.value(place, 0), values.value(sparse_source, 0));
        values.set_ticks(place, 0, tick_, tick_);
        component->log.note_added(entity, tick_);
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
    const auto observed = [](const ComponentRecord& component) {
        return !component.added.empty() || !component.removed.empty();
    };
    std::vector<ComponentRecord*> result;
    const Table& table = table_of(ids_->find(entity));
    if (table.observed)
        for (const auto& column : table.columns())
            if (observed(*column.component)) result.push_back(column.component);
    for (ComponentRecord* component : sparse_)
        if (observed(*component) && component->sparse->find(entity)) result.push_back(component);
    return result;
}

Location EntityStore::move(Entity entity, Location from, Table& to) {
    Table& old = table_of(from);
    const Location at = to.append(entity);
    ids_->move(entity, at);
    const ColumnTicks* old_ticks = old.ticks(from.chunk());
    const auto new_columns = to.columns();
    std::size_t j = 0;
    for (std::size_t i = 0; i < old.columns().size(); ++i) {
        ComponentRecord& component = *old.columns()[i].component;
        const ComponentInfo& info = *component.info;
        while (j < new_columns.size() && id_of(new_columns[j].component) < info.id) ++j;
        if (j < new_columns.size() && new_columns[j].component == &component) {
            relocate(info, to.value(at, j), old.value(from, i));
            to.set_ticks(at, j, old_ticks[i].added(from.row()), old_ticks[i].changed(from.row()));
        } else if (!info.trivial) {
            info.destroy(old.value(from, i));
        }
    }
    if (const Entity moved = old.drop_row(from)) ids_->move(moved, from);
    return at;
}

void EntityStore::forget_change(Entity entity, ComponentRecord& component, Tick changed) {
    if (changed == tick_) component.log.forget(entity, tick_);
}

void EntityStore::remove(Entity entity, Location row, ComponentRecord& component) {
    if (component.sparse) return erase_sparse(entity, component.sparse->find(entity), component);
    Table& table = table_of(row);
    const std::uint32_t column = table.find(component.info->id).column;
    forget_change(entity, component, table.ticks(row.chunk())[column].changed(row.row()));
    move(entity, row, without(table, component));
    component.log.note_removed(1, tick_);
    removals_.note_removed(entity, component.info->id, tick_);
}

void EntityStore::erase_sparse(Entity entity, Location at, ComponentRecord& component) {
    forget_change(entity, component, component.sparse->table.ticks(at.chunk())[0].changed(at.row()));
    component.sparse->erase(entity, at);
    component.log.note_removed(1, tick_);
    removals_.note_removed(entity, component.info->id, tick_);
}

void EntityStore::erase_sparse(Entity entity) {
    for (ComponentRecord* component : sparse_)
        if (const Location at = component->sparse->find(entity)) erase_sparse(entity, at, *component);
}

void EntityStore::destroy(Entity entity) {
    if (!sparse_.empty()) erase_sparse(entity);
    const Location at = ids_->find(entity);
    Table& table = table_of(at);
    table.destroy_values(at);
    if (const auto columns = table.columns(); !columns.empty()) {
        for (const auto& column : columns) column.component->log.note_removed(1, tick_);
        removals_.note_destroyed(entity, table, tick_);
    }
    if (const Entity moved = table.drop_row(at)) ids_->move(moved, at);
    ids_->release(entity);
}

void EntityStore::destroy_all(Table& table) {
    for (const auto& column : table.columns()) column.component->log.note_removed(table.size(), tick_);
    for (std::size_t position = 0; position < table.chunks().size(); ++position) {
        const std::span entities(table.entities(table.chunks()[position]), table.rows(position));
        if (!sparse_.empty())
            for (const Entity entity : entities) erase_sparse(entity);
        if (!table.columns().empty()) removals_.note_destroyed(entities, table, tick_);
        for (const Entity entity : entities) ids_->release(entity);
    }
    table.clear();
}

} // namespace hachure::detail
