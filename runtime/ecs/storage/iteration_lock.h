#pragma once

#include <hachure/runtime/assert.h>

#include <atomic>
#include <cstdint>
#include <utility>

namespace hachure::detail {

/// How many queries of a world are being walked; while it is not zero, entities and components stay where they are.
/// Atomic, because several threads may read one constant world.
class IterationLock {
public:
    IterationLock() = default;
    IterationLock(IterationLock&& other) noexcept { other.assert_idle(); }
    IterationLock& operator=(IterationLock&& other) noexcept {
        assert_idle();
        other.assert_idle();
        return *this;
    }

    void assert_idle() const {
        HACHURE_ASSERT(count_.load(std::memory_order_relaxed) == 0,
                       "a world keeps its structure while a query is walked; use Commands");
    }

    /// Holds the lock for as long as it lives.
    class Guard {
    public:
        explicit Guard(IterationLock& lock) : lock_(&lock) { lock.count_.fetch_add(1, std::memory_order_relaxed); }
        Guard(Guard&& other) noexcept : lock_(std::exchange(other.lock_, nullptr)) {}
        Guard& operator=(Guard&& other) noexcept {
            std::swap(lock_, other.lock_);
            return *this;
        }
        ~Guard() {
            if (lock_) lock_->count_.fetch_sub(1, std::memory_order_relaxed);
        }

    private:
        IterationLock* lock_;
    };

private:
    std::atomic<std::uint32_t> count_ = 0;
};

} // namespace hachure::detail
