#include <hachure/runtime/ecs/storage/table.h>

#include <algorithm>

namespace hachure::detail {
namespace {

constexpr std::size_t column_alignment = max_alignment;

std::size_t aligned(std::size_t offset) {
    return (offset + column_alignment - 1) / column_alignment * column_alignment;
}

/// Holes at the front are filled from the back: that goes up and down at once, which prefetchers don't follow.
void prefetch(const std::byte* data, std::size_t bytes) {
    constexpr int write = 1, second_level = 2;
    for (std::size_t line = 0; line < bytes; line += 64) __builtin_prefetch(data + line, write, second_level);
}

} // namespace

Table::Table(std::uint32_t index, std::span<ComponentRecord* const> components, ChunkDirectory& directory,
             RowIndex& rows)
    : index_(index), directory_(&directory), rows_(&rows) {
    std::size_t row_bytes = sizeof(Entity);
    for (const ComponentRecord* component : components) row_bytes += component->info->stride;
    // For aligning each column, and for the address that an empty type's values share.
    const std::size_t padding = 2 * column_alignment * (components.size() + 1);
    bytes_ = std::max(chunk_bytes, aligned(row_bytes) + padding);
    capacity_ = static_cast<std::uint32_t>(std::min<std::size_t>((bytes_ - padding) / row_bytes, Location::max_rows));

    constexpr std::uint32_t share = 8;
    few_rows_ = std::max(capacity_ / share, 1u);

    std::size_t offset = aligned(sizeof(Entity) * capacity_);
    for (ComponentRecord* component : components) {
        const ComponentInfo& info = *component->info;
        if (info.id >= offsets_.size()) offsets_.resize(info.id + 1);
        column_numbers_.resize(offsets_.size());
        offsets_[info.id] = static_cast<std::uint32_t>(offset);
        column_numbers_[info.id] = static_cast<std::uint32_t>(columns_.size());
        columns_.push_back({component, offsets_[info.id], info.stride, info.trivial});
        offset = aligned(offset + std::max<std::size_t>(std::size_t{info.stride} * capacity_, 1));
        trivial_ = trivial_ && info.trivial;
    }
    HACHURE_ASSERT(offset <= bytes_, "a chunk holds its columns");
}

Table::~Table() { clear(); }

void Table::widen(std::size_t count) {
    if (count <= offsets_.size()) return;
    offsets_.resize(count);
    for (const std::uint32_t chunk : chunks_) directory_->set_offsets(chunk, offsets_.data());
}

void Table::set_tail(std::uint32_t chunk) {
    tail_ = chunk;
    tail_rows_ = directory_->header(chunk).rows;
    tail_capacity_ = capacity_;
    tail_data_ = (*directory_)[chunk].data;
}

void Table::open_chunk() {
    const std::uint32_t chunk = directory_->open(*this, offsets_.data(), bytes_, columns_.size());
    directory_->header(chunk).position = static_cast<std::uint32_t>(chunks_.size());
    chunks_.push_back(chunk);
    set_tail(chunk);
}

void Table::close_chunk(std::uint32_t chunk) {
    const std::uint32_t position = directory_->header(chunk).position;
    chunks_[position] = chunks_.back();
    directory_->header(chunks_[position]).position = position;
    chunks_.pop_back();
    directory_->close(chunk, bytes_);
    if (chunk != tail_) return;
    tail_ = no_chunk;
    tail_rows_ = tail_capacity_ = 0;
    if (!chunks_.empty()) set_tail(chunks_.back());
}

Table::Rows Table::append_rows(std::size_t wanted) {
    if (tail_rows_ == tail_capacity_) open_chunk();
    const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(wanted, capacity_ - tail_rows_));
    const Location first(tail_, tail_rows_);
    directory_->header(tail_).rows = tail_rows_ += count;
    size_ += count;
    return {first, count};
}

void Table::move_values(Location to, Location from) {
    std::byte* target = (*directory_)[to.chunk()].data;
    std::byte* source = (*directory_)[from.chunk()].data;
    for (const Column& column : columns_)
        relocate(column, value(target, column, to.row()), value(source, column, from.row()));
}

void Table::fill_hole(Location at, std::uint32_t last) {
    std::byte* data = (*directory_)[at.chunk()].data;
    if (last + 1 == capacity_) prefetch(data, bytes_);
    auto* entities = reinterpret_cast<Entity*>(data);
    entities[at.row()] = entities[last];
    ColumnTicks* each_ticks = ticks(at.chunk());
    for (const Column& column : columns_) {
        relocate(column, value(data, column, at.row()), value(data, column, last));
        each_ticks++->move(at.row(), last);
    }
    rows_->set_row(entities[last], at);
}

void Table::tidy(std::uint32_t chunk, std::uint32_t rows) {
    // What is moved here was paid for by the many that went.
    if (tail_rows_ == 0) {
        close_chunk(tail_);
        set_tail(chunk);
    } else if (rows == 0) {
        close_chunk(chunk);
    } else {
        merge(chunk);
    }
}

void Table::merge(std::uint32_t chunk) {
    const std::uint32_t rows = directory_->header(chunk).rows;
    for (std::uint32_t row = 0; row < rows; ++row) {
        const Location from(chunk, row);
        const Entity entity = entities(chunk)[row];
        const Location to = append(entity);
        move_values(to, from);
        for (std::size_t i = 0; i < columns_.size(); ++i)
            ticks(to.chunk())[i].place(to.row(), to.row(), capacity_, ticks(chunk)[i], row);
        rows_->set_row(entity, to);
    }
    size_ -= rows; // they were counted again as they were appended
    close_chunk(chunk);
}

void Table::call_destructors(Location at) {
    for (std::size_t i = 0; i < columns_.size(); ++i)
        if (!columns_[i].trivial) columns_[i].component->info->destroy(value(at, i));
}

void Table::clear() {
    while (!chunks_.empty()) {
        const std::uint32_t chunk = chunks_.back();
        const std::uint32_t rows = directory_->header(chunk).rows;
        for (std::uint32_t row = 0; !trivial_ && row < rows; ++row) destroy_values({chunk, row});
        close_chunk(chunk);
    }
    size_ = 0;
}

} // namespace hachure::detail
