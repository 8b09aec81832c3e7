#include <hachure/runtime/ecs/storage/large_memory.h>

#include <cstdint>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hachure::detail {
namespace {

constexpr std::size_t large_page = std::size_t{2} << 20;
constexpr std::size_t cache_line = 64;

#if defined(__linux__)

bool is_mapped(std::size_t bytes) { return bytes >= large_page; }

/// Fresh from the system: memory that malloc hands out again has its small pages already.
std::byte* map(std::size_t bytes) {
    const std::size_t wanted = bytes + large_page;
    void* memory = mmap(nullptr, wanted, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    auto* begin = static_cast<std::byte*>(memory);
    const std::size_t before = (large_page - reinterpret_cast<std::uintptr_t>(begin) % large_page) % large_page;
    if (before > 0) munmap(begin, before);
    if (before < large_page) munmap(begin + before + bytes, large_page - before);
    madvise(begin + before, bytes, MADV_HUGEPAGE);
    return begin + before;
}

void unmap(std::byte* memory, std::size_t bytes) { munmap(memory, bytes); }

#else

bool is_mapped(std::size_t) { return false; }
std::byte* map(std::size_t) { return nullptr; }
void unmap(std::byte*, std::size_t) {}

#endif

/// In whole pages, as the system gives them.
std::size_t rounded(std::size_t bytes) {
    constexpr std::size_t page = 4096;
    return (bytes + page - 1) / page * page;
}

} // namespace

std::byte* allocate_large(std::size_t bytes) {
    if (is_mapped(bytes)) return map(rounded(bytes));
    return static_cast<std::byte*>(::operator new(bytes, std::align_val_t(cache_line)));
}

void release_large(std::byte* memory, std::size_t bytes) {
    if (is_mapped(bytes)) return unmap(memory, rounded(bytes));
    ::operator delete(memory, std::align_val_t(cache_line));
}

} // namespace hachure::detail
