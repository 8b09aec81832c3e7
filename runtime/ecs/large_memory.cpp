#include <hachure/runtime/ecs/large_memory.h>

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hachure::detail {
namespace {

constexpr std::size_t large_page = std::size_t{2} << 20;
constexpr std::size_t cache_line = 64;

std::align_val_t alignment_of(std::size_t bytes) {
    return std::align_val_t(bytes >= large_page ? large_page : cache_line);
}

} // namespace

std::byte* allocate_large(std::size_t bytes) {
    auto* memory = static_cast<std::byte*>(::operator new(bytes, alignment_of(bytes)));
#if defined(__linux__)
    if (bytes >= large_page) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
    return memory;
}

void release_large(std::byte* memory, std::size_t bytes) { ::operator delete(memory, alignment_of(bytes)); }

} // namespace hachure::detail
