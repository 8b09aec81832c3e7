#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/ecs/storage/chunk_directory.h>
#include <hachure/runtime/ecs/storage/component_record.h>
#include <hachure/runtime/ecs/storage/location.h>
#include <hachure/runtime/ecs/storage/row_index.h>
#include <hachure/runtime/ecs/tick.h>
#include <hachure/runtime/ecs/type_id.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hachure::detail {

struct Transition;

/// Entities with the same components. Rows stand in chunks; a chunk holds the handles of its rows, then one packed
/// column per component. A row that goes is filled by the last one of its chunk, which is near; a chunk that is nearly
/// empty moves into another. The values of a row begin and end with the caller: `append` and `drop_row` leave them raw.
class Table {
public:
    struct Column {
        ComponentRecord* component;
        std::uint32_t offset; ///< of the first row, from the begin of a chunk
        std::uint32_t stride; ///< as ComponentInfo::stride
        bool trivial;         ///< as ComponentInfo::trivial
    };

    /// `components` are in order of their ids. Rows that the table itself moves are told to `rows`.
    Table(std::uint32_t index, std::span<ComponentRecord* const> components, ChunkDirectory& directory, RowIndex& rows);
    Table(const Table&) = delete;
    Table& operator=(const Table&) = delete;
    ~Table();

    /// Number of the table in its world.
    std::uint32_t index() const { return index_; }

    std::span<const Column> columns() const { return columns_; }

    /// Where the component's column begins in a chunk; 0 where the table lacks it.
    std::uint32_t offset(TypeId component) const { return component < offsets_.size() ? offsets_[component] : 0; }
    bool has(TypeId component) const { return offset(component) != 0; }

    /// The number of the column of a component that it has.
    std::uint32_t column(TypeId component) const { return column_numbers_[component]; }

    /// Makes offsets known for components up to `count`.
    void widen(std::size_t count);

    /// Rows.
    std::size_t size() const { return size_; }

    /// Rows of a full chunk.
    std::uint32_t capacity() const { return capacity_; }

    /// The numbers of its chunks; one of them may be empty.
    std::span<const std::uint32_t> chunks() const { return chunks_; }

    /// The handles of the rows of one of its chunks.
    std::span<const Entity> entities(std::uint32_t chunk) const {
        return {reinterpret_cast<const Entity*>((*directory_)[chunk].data), directory_->header(chunk).rows};
    }

    std::byte* value(Location at, std::size_t column) const {
        return value((*directory_)[at.chunk()].data, columns_[column], at.row());
    }

    /// The same for the data of a chunk.
    static std::byte* value(std::byte* data, const Column& column, std::uint32_t row) {
        return data + column.offset + std::size_t{row} * column.stride;
    }

    /// Moves the value at `from`, of a column, to the raw memory at `to`, and leaves raw memory behind.
    static void relocate(const Column& column, std::byte* to, std::byte* from) {
        if (column.trivial)
            copy_bytes(to, from, column.stride);
        else
            column.component->info->relocate(to, from);
    }

    ColumnTicks* ticks(std::uint32_t chunk) const { return directory_->ticks(chunk); }

    /// A new row for `entity`; its values and ticks are the caller's to set (`set_ticks`).
    Location append(Entity entity) {
        if (tail_rows_ == tail_capacity_) open_chunk();
        reinterpret_cast<Entity*>(tail_data_)[tail_rows_] = entity;
        const Location at(tail_, tail_rows_);
        directory_->header(tail_).rows = ++tail_rows_;
        ++size_;
        return at;
    }

    /// Makes room for up to `wanted` rows at once: as many as fit in one chunk, at least 1. They count as rows from now
    /// on; their handles, values and ticks are the caller's to set.
    struct Rows {
        Location first;
        std::uint32_t count;
    };
    Rows append_rows(std::size_t wanted);

    /// The ticks of a column of the row that was appended last.
    void set_ticks(Location at, std::size_t column, Tick added, Tick changed) {
        ticks(at.chunk())[column].place(at.row(), at.row(), capacity_, added, changed);
    }

    /// Drops a row whose values are gone already.
    void drop_row(Location at) {
        const std::uint32_t last = --directory_->header(at.chunk()).rows;
        --size_;
        if (at.row() != last) fill_hole(at, last);
        if (at.chunk() == tail_)
            tail_rows_ = last; // it stays, even empty: entities come and go
        else if (last < few_rows_ || tail_rows_ == 0)
            tidy(at.chunk(), last);
    }

    /// Destroys the values of a row.
    void destroy_values(Location at) {
        if (!trivial_) call_destructors(at);
    }

    /// Drops all rows and their values.
    void clear();

    // Where an entity goes that gets or loses a component, by component; see EntityStore.
    std::vector<std::unique_ptr<Transition>> adding;
    std::vector<std::unique_ptr<Transition>> removing;

    bool observed = false; ///< some component has observers
    bool in_tree = false;  ///< the entities have parents or children

private:
    void open_chunk();
    void close_chunk(std::uint32_t chunk);
    void set_tail(std::uint32_t chunk);
    void fill_hole(Location at, std::uint32_t last);
    void tidy(std::uint32_t chunk, std::uint32_t rows);
    void merge(std::uint32_t chunk);
    void move_values(Location to, Location from);
    void call_destructors(Location at);

    static constexpr std::uint32_t no_chunk = 0xffff'ffffu;

    std::uint32_t index_;
    std::uint32_t capacity_ = 0;
    std::uint32_t few_rows_ = 0;    ///< so few that they are not worth a chunk
    std::uint32_t tail_ = no_chunk; ///< the chunk that new rows go to
    std::uint32_t tail_rows_ = 0;
    std::uint32_t tail_capacity_ = 0; ///< 0 while there is no such chunk
    std::byte* tail_data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t bytes_ = 0; ///< of a chunk
    ChunkDirectory* directory_;
    RowIndex* rows_;
    std::vector<Column> columns_;
    std::vector<std::uint32_t> offsets_;        ///< by component
    std::vector<std::uint32_t> column_numbers_; ///< by component
    std::vector<std::uint32_t> chunks_;
    bool trivial_ = true; ///< no value needs to be destroyed
};

/// The way from one table to another that has one component more, or less: the columns that both have.
struct Transition {
    struct Shared {
        Table::Column from;
        std::uint32_t to_offset;
        std::uint16_t from_column;
        std::uint16_t to_column;
    };

    Table* to;
    std::vector<Shared> shared;
};

} // namespace hachure::detail
