#include <hachure/runtime/ecs/storage/chunk_pool.h>
#include <hachure/runtime/ecs/storage/large_memory.h>

#include <algorithm>

namespace hachure::detail {
namespace {

constexpr std::size_t first_slab = 4 * chunk_bytes;
constexpr std::size_t largest_slab = std::size_t{16} << 20;

/// Slabs double until the largest, so that a slab's place says its size.
std::size_t slab_bytes(std::size_t place) {
    constexpr std::size_t doublings = 8;
    static_assert(first_slab << doublings == largest_slab);
    return first_slab << std::min(place, doublings);
}

} // namespace

ChunkPool::~ChunkPool() {
    for (std::size_t i = 0; i < slabs_.size(); ++i) release_large(slabs_[i], slab_bytes(i));
}

std::byte* ChunkPool::allocate(std::size_t bytes) {
    if (bytes > chunk_bytes) return allocate_large(bytes);
    if (!free_.empty()) {
        std::byte* memory = free_.back();
        free_.pop_back();
        return memory;
    }
    if (fresh_ == fresh_end_) grow();
    std::byte* memory = fresh_;
    fresh_ += chunk_bytes;
    return memory;
}

void ChunkPool::release(std::byte* memory, std::size_t bytes) {
    if (bytes > chunk_bytes)
        release_large(memory, bytes);
    else
        free_.push_back(memory);
}

void ChunkPool::grow() {
    const std::size_t bytes = slab_bytes(slabs_.size());
    fresh_ = allocate_large(bytes);
    fresh_end_ = fresh_ + bytes;
    slabs_.push_back(fresh_);
}

} // namespace hachure::detail
