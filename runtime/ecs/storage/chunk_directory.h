#pragma once

#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/storage/chunk_pool.h>
#include <hachure/runtime/ecs/storage/column_ticks.h>
#include <hachure/runtime/ecs/storage/location.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace hachure::detail {

class Table;

/// The chunks of a world by number.
class ChunkDirectory {
public:
    /// What a look-up by entity needs; small, so that all of it stays in the cache.
    struct Chunk {
        std::byte* data;
        const std::uint32_t* offsets; ///< by component: of its column in `data`; 0 where the table lacks it
    };

    /// The rest.
    struct Header {
        Table* table = nullptr;
        std::unique_ptr<ColumnTicks[]> ticks; ///< one per column of the table
        std::uint32_t rows = 0;
        std::uint32_t position = 0; ///< among the chunks of the table
    };

    const Chunk& operator[](std::uint32_t id) const { return chunks_[id]; }
    const Header& header(std::uint32_t id) const { return headers_[id]; }
    Header& header(std::uint32_t id) { return headers_[id]; }
    Table& table(std::uint32_t id) const { return *headers_[id].table; }
    ColumnTicks* ticks(std::uint32_t id) const { return headers_[id].ticks.get(); }

    /// A new chunk of `bytes` for a table of `columns` columns; its number.
    std::uint32_t open(Table& table, const std::uint32_t* offsets, std::size_t bytes, std::size_t columns);

    /// The offsets of the chunk's table have moved.
    void set_offsets(std::uint32_t id, const std::uint32_t* offsets) { chunks_[id].offsets = offsets; }

    /// The chunk's rows are gone; `bytes` as in `open`.
    void close(std::uint32_t id, std::size_t bytes);

private:
    std::vector<Chunk> chunks_;
    std::vector<Header> headers_;
    std::vector<std::uint32_t> free_;
    ChunkPool pool_;
};

} // namespace hachure::detail
