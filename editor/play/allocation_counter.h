#pragma once

#include <hachure/runtime/app/app.h>

#include <atomic>
#include <cstdint>
#include <optional>

namespace hachure::play {

/// How often operator new was called while somebody counts. The program's own operator new (editor/counting_new.cpp)
/// writes it; a program without that one counts nothing.
struct AllocationCounter {
    std::atomic<bool> installed{false}; ///< the program has such an operator new
    std::atomic<bool> counting{false};
    std::atomic<std::uint64_t> count{0};
};

/// The process's own.
extern AllocationCounter allocation_counter;

/// From now on, counts what the systems of each frame allocate before stage render: there the driver begins, whose
/// allocations are not ours. To be called before any capability is registered.
void count_allocations(App& app);

/// Of the last frame; nothing when the program does not count.
[[nodiscard]] std::optional<std::uint64_t> allocations_of_frame(const World& world);

} // namespace hachure::play
