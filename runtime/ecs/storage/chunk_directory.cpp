#include <hachure/runtime/ecs/storage/chunk_directory.h>

namespace hachure::detail {

std::uint32_t ChunkDirectory::open(Table& table, const std::uint32_t* offsets, std::size_t bytes, std::size_t columns) {
    std::uint32_t id;
    if (free_.empty()) {
        HACHURE_ASSERT(chunks_.size() < Location::max_chunks, "a world has less than 2^20 chunks");
        id = static_cast<std::uint32_t>(chunks_.size());
        chunks_.emplace_back();
        headers_.emplace_back();
    } else {
        id = free_.back();
        free_.pop_back();
    }
    chunks_[id] = {pool_.allocate(bytes), offsets};
    headers_[id].table = &table;
    headers_[id].ticks = std::make_unique<ColumnTicks[]>(columns);
    headers_[id].rows = 0;
    return id;
}

void ChunkDirectory::close(std::uint32_t id, std::size_t bytes) {
    pool_.release(chunks_[id].data, bytes);
    chunks_[id] = {};
    headers_[id] = {};
    free_.push_back(id);
}

} // namespace hachure::detail
