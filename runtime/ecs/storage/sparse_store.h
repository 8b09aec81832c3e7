#pragma once

#include <hachure/runtime/ecs/storage/component_record.h>
#include <hachure/runtime/ecs/storage/sparse_index.h>
#include <hachure/runtime/ecs/storage/table.h>

#include <array>

namespace hachure::detail {

/// Every entity that has one component with sparse storage: a table with that one column, and an index into it.
struct SparseStore final : RowIndex {
    SparseIndex index;
    Table table;

    SparseStore(ComponentRecord& component, ChunkDirectory& directory)
        : table(0, std::array{&component}, directory, *this) {}

    void set_row(Entity entity, Location at) override { index.set(entity.index, at); }

    /// The row of an entity that is alive, or nowhere.
    Location find(Entity entity) const { return index.find(entity.index); }

    /// A new row for `entity`, which has none. The value is the caller's to construct.
    Location append(Entity entity) {
        const Location at = table.append(entity);
        index.set(entity.index, at);
        return at;
    }

    /// Destroys the value of `entity` at `at` and drops the row.
    void erase(Entity entity, Location at) {
        index.clear(entity.index);
        table.destroy_values(at);
        table.drop_row(at);
    }
};

} // namespace hachure::detail
