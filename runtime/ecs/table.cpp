#include <hachure/runtime/ecs/table.h>

#include <algorithm>
#include <numeric>

namespace hachure::detail {
namespace {

constexpr std::size_t column_alignment = max_alignment;

std::size_t aligned(std::size_t offset) {
    return (offset + column_alignment - 1) / column_alignment * column_alignment;
}

} // namespace

Table::Table(std::uint32_t index, std::span<ComponentRecord* const> components, ChunkDirectory& directory)
    : index_(index), directory_(&directory) {
    std::size_t row_bytes = sizeof(Entity);
    for (const ComponentRecord* component : components) row_bytes += component->info->stride;
    // For aligning each column, and for the address that an empty type's values share.
    const std::size_t padding = 2 * column_alignment * (components.size() + 1);
    bytes_ = std::max(chunk_bytes, aligned(row_bytes) + padding);
    capacity_ = static_cast<std::uint32_t>(std::min<std::size_t>((bytes_ - padding) / row_bytes, Location::max_rows));

    std::size_t offset = aligned(sizeof(Entity) * capacity_);
    for (ComponentRecord* component : components) {
        const TypeId id = component->info->id;
        if (id >= slots_.size()) slots_.resize(id + 1);
        slots_[id] = {static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(columns_.size())};
        columns_.push_back({component, static_cast<std::uint32_t>(offset)});
        offset = aligned(offset + std::max<std::size_t>(std::size_t{component->info->stride} * capacity_, 1));
        trivial_ = trivial_ && component->info->trivial;
    }
    HACHURE_ASSERT(offset <= bytes_, "a chunk holds its columns");
}

Table::~Table() { clear(); }

void Table::open_chunk() {
    full_rows_ += tail_rows_;
    tail_ = directory_->open(this, bytes_, columns_.size());
    tail_rows_ = 0;
    entities_of_tail_ = reinterpret_cast<Entity*>((*directory_)[tail_].data);
    chunks_.push_back(tail_);
}

void Table::close_tail() {
    directory_->close(tail_, bytes_);
    chunks_.pop_back();
    tail_ = chunks_.empty() ? 0xffff'ffffu : chunks_.back();
    tail_rows_ = chunks_.empty() ? 0 : capacity_;
    entities_of_tail_ = chunks_.empty() ? nullptr : reinterpret_cast<Entity*>((*directory_)[tail_].data);
    full_rows_ -= tail_rows_;
}

Table::Rows Table::append_rows(std::size_t wanted) {
    if (tail_rows_ == capacity_ || chunks_.empty()) open_chunk();
    const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(wanted, capacity_ - tail_rows_));
    const Location first(tail_, tail_rows_);
    tail_rows_ += count;
    return {first, count};
}

Entity Table::drop_row(Location at) {
    const Location last(tail_, tail_rows_ - 1);
    Entity moved = Entity::null;
    if (at != last) {
        moved = entities_of_tail_[last.row()];
        const auto& to = (*directory_)[at.chunk()];
        const auto& from = (*directory_)[last.chunk()];
        ColumnTicks* to_ticks = ticks(at.chunk());
        const ColumnTicks* from_ticks = ticks(last.chunk());
        reinterpret_cast<Entity*>(to.data)[at.row()] = moved;
        const std::uint32_t rows = rows_of_chunk(at.chunk());
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const Column& column = columns_[i];
            const ComponentInfo& info = *column.component->info;
            relocate(info, to.data + column.offset + std::size_t{at.row()} * info.stride,
                     from.data + column.offset + std::size_t{last.row()} * info.stride);
            if (from_ticks != to_ticks || !to_ticks[i].uniform())
                to_ticks[i].place(at.row(), rows, capacity_, from_ticks[i].added(last.row()),
                                  from_ticks[i].changed(last.row()));
        }
    }
    if (--tail_rows_ == 0) close_tail();
    return moved;
}

void Table::destroy_values(Location at) {
    if (trivial_) return;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const ComponentInfo& info = *columns_[i].component->info;
        if (!info.trivial) info.destroy(value(at, i));
    }
}

void Table::clear() {
    while (!chunks_.empty()) {
        for (std::uint32_t row = 0; !trivial_ && row < tail_rows_; ++row) destroy_values({tail_, row});
        close_tail();
    }
}

} // namespace hachure::detail
