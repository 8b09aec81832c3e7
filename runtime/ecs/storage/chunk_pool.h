#pragma once

#include <cstddef>
#include <vector>

namespace hachure::detail {

/// The memory of a chunk of the usual size: it fits the first cache level, and few entities don't waste much of it.
inline constexpr std::size_t chunk_bytes = 16 * 1024;

/// Hands out chunks' memory. What comes back is handed out again first, while it is still in the cache: an entity that
/// moves from table to table needs no fresh memory. Memory goes back to the system with the pool.
class ChunkPool {
public:
    ChunkPool() = default;
    ChunkPool(const ChunkPool&) = delete;
    ChunkPool& operator=(const ChunkPool&) = delete;
    ~ChunkPool();

    /// Raw memory of at least `bytes`, aligned to a cache line.
    std::byte* allocate(std::size_t bytes);

    /// `bytes` as in `allocate`.
    void release(std::byte* memory, std::size_t bytes);

private:
    void grow();

    std::vector<std::byte*> free_;
    std::vector<std::byte*> slabs_;
    std::byte* fresh_ = nullptr; ///< the part of the newest slab that was never handed out
    std::byte* fresh_end_ = nullptr;
};

} // namespace hachure::detail
