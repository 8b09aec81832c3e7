#include <hachure/editor/play/allocation_counter.h>

#include <cstdlib>
#include <new>

// The program's operator new, which `hachure play` counts. It is no part of the library: other programs keep theirs.
// The forms that are not here call these.
namespace {

/// Before main(), so that it is known by then.
[[maybe_unused]] const bool installed = hachure::play::allocation_counter.installed = true;

void* counted(void* memory) {
    using hachure::play::allocation_counter;
    if (allocation_counter.counting.load(std::memory_order_relaxed))
        allocation_counter.count.fetch_add(1, std::memory_order_relaxed);
    if (!memory) throw std::bad_alloc();
    return memory;
}

} // namespace

void* operator new(std::size_t size) { return counted(std::malloc(size == 0 ? 1 : size)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
    const std::size_t step = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(step, size == 0 ? step : (size + step - 1) / step * step));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
