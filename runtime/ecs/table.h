#pragma once

#include <hachure/runtime/ecs/chunk_directory.h>
#include <hachure/runtime/ecs/component_record.h>
#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/location.h>
#include <hachure/runtime/ecs/tick.h>
#include <hachure/runtime/ecs/type_id.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::detail {

/// Entities with the same components. Rows are packed in chunks; a chunk holds the handles of its rows, then one packed
/// column per component. All chunks but the last are full. The values of a row begin and end with `construct`-like
/// calls of the owner: `append` and `drop_row` leave them to it.
class Table {
public:
    struct Column {
        ComponentRecord* component;
        std::uint32_t offset; ///< of the first row, from the begin of a chunk
    };

    /// Where a component is in the table's chunks.
    struct Slot {
        static constexpr std::uint32_t none = 0xffff'ffffu;
        std::uint32_t offset = none; ///< as Column::offset; none where the table lacks the component
        std::uint32_t column = 0;    ///< number of its column
    };

    /// `components` are in order of their ids.
    Table(std::uint32_t index, std::span<ComponentRecord* const> components, ChunkDirectory& directory);
    Table(const Table&) = delete;
    Table& operator=(const Table&) = delete;
    ~Table();

    /// Number of the table in its world.
    std::uint32_t index() const { return index_; }

    std::span<const Column> columns() const { return columns_; }

    Slot find(TypeId component) const { return component < slots_.size() ? slots_[component] : Slot{}; }
    bool has(TypeId component) const { return find(component).offset != Slot::none; }

    /// Rows.
    std::size_t size() const { return full_rows_ + tail_rows_; }

    /// Rows of a full chunk.
    std::uint32_t capacity() const { return capacity_; }

    /// The numbers of its chunks, in order.
    std::span<const std::uint32_t> chunks() const { return chunks_; }

    /// Rows in the chunk that is the `position`-th of this table.
    std::uint32_t rows(std::size_t position) const { return position + 1 < chunks_.size() ? capacity_ : tail_rows_; }

    /// Rows in that chunk, one of this table's.
    std::uint32_t rows_of_chunk(std::uint32_t chunk) const { return chunk == tail_ ? tail_rows_ : capacity_; }

    Entity entity(Location at) const { return entities(at.chunk())[at.row()]; }
    const Entity* entities(std::uint32_t chunk) const {
        return reinterpret_cast<const Entity*>(directory_->operator[](chunk).data);
    }

    std::byte* value(Location at, std::size_t column) const {
        return (*directory_)[at.chunk()].data + columns_[column].offset +
               std::size_t{at.row()} * columns_[column].component->info->stride;
    }

    ColumnTicks* ticks(std::uint32_t chunk) const { return directory_->ticks(chunk); }

    /// A new row at the end for `entity`; its values and ticks are the caller's to set (`set_ticks`).
    Location append(Entity entity) {
        if (tail_rows_ == capacity_ || chunks_.empty()) open_chunk();
        entities_of_tail_[tail_rows_] = entity;
        return {tail_, tail_rows_++};
    }

    /// Makes room for up to `wanted` rows at once at the end: as many as fit in one chunk, at least 1. They count as
    /// rows from now on; their handles, values and ticks are the caller's to set.
    struct Rows {
        Location first;
        std::uint32_t count;
    };
    Rows append_rows(std::size_t wanted);

    /// The ticks of a column of the row that was appended last.
    void set_ticks(Location at, std::size_t column, Tick added, Tick changed) {
        ticks(at.chunk())[column].place(at.row(), at.row(), capacity_, added, changed);
    }

    /// Drops a row whose values are gone already, by moving the last row into it. The entity that moved, or null.
    Entity drop_row(Location at);

    /// Destroys the values of a row.
    void destroy_values(Location at);

    /// Drops all rows and their values.
    void clear();

private:
    void open_chunk();
    void close_tail();

    std::uint32_t index_;
    std::uint32_t capacity_ = 0;
    std::uint32_t tail_ = 0xffff'ffffu; ///< the last chunk
    std::uint32_t tail_rows_ = 0;
    Entity* entities_of_tail_ = nullptr;
    std::size_t full_rows_ = 0; ///< in chunks before the last
    std::size_t bytes_ = 0;     ///< of a chunk
    ChunkDirectory* directory_;
    std::vector<Column> columns_;
    std::vector<Slot> slots_; ///< by component
    std::vector<std::uint32_t> chunks_;
    bool trivial_ = true; ///< no value needs to be destroyed

public:
    // Set by the owner; see EntityStore.
    std::vector<Table*> with;    ///< by component: the table that has it besides; null where not asked for yet
    std::vector<Table*> without; ///< by component: the table that lacks it
    bool observed = false;       ///< some component is observed
};

} // namespace hachure::detail
