#include <hachure/runtime/ecs/chunk_pool.h>
#include <hachure/runtime/ecs/component_info.h>

#include <algorithm>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hachure::detail {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::size_t first_slab = 4 * chunk_bytes;
constexpr std::size_t largest_slab = 8 * huge_page;

std::byte* take(std::size_t bytes, std::size_t alignment) {
    return static_cast<std::byte*>(::operator new(bytes, std::align_val_t(alignment)));
}

std::size_t slab_alignment(std::size_t bytes) { return bytes >= huge_page ? huge_page : chunk_bytes; }

} // namespace

ChunkPool::~ChunkPool() {
    // Slab sizes double until the largest, so that each one's alignment is known by its place.
    std::size_t bytes = first_slab;
    for (std::byte* slab : slabs_) {
        ::operator delete(slab, std::align_val_t(slab_alignment(bytes)));
        bytes = std::min(2 * bytes, largest_slab);
    }
}

std::byte* ChunkPool::allocate(std::size_t bytes) {
    if (bytes > chunk_bytes) return take(bytes, max_alignment);
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
        ::operator delete(memory, std::align_val_t(max_alignment));
    else
        free_.push_back(memory);
}

void ChunkPool::grow() {
    std::size_t bytes = first_slab;
    for (std::size_t i = 0; i < slabs_.size(); ++i) bytes = std::min(2 * bytes, largest_slab);
    fresh_ = take(bytes, slab_alignment(bytes));
    fresh_end_ = fresh_ + bytes;
    slabs_.push_back(fresh_);
    reserved_ += bytes;
#if defined(__linux__)
    // Large pages: a walk over a large world misses no translations, and fresh memory costs one fault for 128 chunks.
    // Where the system has none to give, this changes nothing.
    if (bytes >= huge_page) madvise(fresh_, bytes, MADV_HUGEPAGE);
#endif
}

} // namespace hachure::detail
