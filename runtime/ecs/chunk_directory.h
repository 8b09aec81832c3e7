#pragma once

#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/chunk_pool.h>
#include <hachure/runtime/ecs/column_ticks.h>
#include <hachure/runtime/ecs/location.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace hachure::detail {

class Table;

/// The chunks of a world by number. What a look-up by entity needs stands together, so that it stays in the cache.
class ChunkDirectory {
public:
    struct Chunk {
        std::byte* data;
        Table* table;
    };

    const Chunk& operator[](std::uint32_t id) const { return chunks_[id]; }

    /// One per column of the chunk's table.
    ColumnTicks* ticks(std::uint32_t id) const { return ticks_[id].get(); }

    /// A new chunk of `bytes` for a table of `columns` columns; its number.
    std::uint32_t open(Table* table, std::size_t bytes, std::size_t columns) {
        std::uint32_t id;
        if (free_.empty()) {
            HACHURE_ASSERT(chunks_.size() < Location::max_chunks, "a world has less than 2^20 chunks");
            id = static_cast<std::uint32_t>(chunks_.size());
            chunks_.emplace_back();
            ticks_.emplace_back();
        } else {
            id = free_.back();
            free_.pop_back();
        }
        chunks_[id] = {pool_.allocate(bytes), table};
        ticks_[id] = std::make_unique<ColumnTicks[]>(columns);
        return id;
    }

    /// The chunk's rows are gone; `bytes` as in `open`.
    void close(std::uint32_t id, std::size_t bytes) {
        pool_.release(chunks_[id].data, bytes);
        chunks_[id] = {};
        ticks_[id].reset();
        free_.push_back(id);
    }

private:
    std::vector<Chunk> chunks_;
    std::vector<std::unique_ptr<ColumnTicks[]>> ticks_;
    std::vector<std::uint32_t> free_;
    ChunkPool pool_;
};

} // namespace hachure::detail
