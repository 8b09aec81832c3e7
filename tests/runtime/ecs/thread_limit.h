#pragma once

#include <hachure/runtime/parallel.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace hachure::test {

/// Sets the thread limit for as long as it lives.
class ThreadLimit {
public:
    explicit ThreadLimit(int limit) : before_(thread_limit()) { set_thread_limit(limit); }
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;
    ~ThreadLimit() { set_thread_limit(before_); }

private:
    int before_;
};

/// A place where `count` threads wait for each other: all of them arrive only when they run at the same time.
class Meeting {
public:
    explicit Meeting(int count) : expected_(count) {}

    /// Whether the others came within half a minute.
    bool arrive() {
        ++arrived_;
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
        while (arrived_ < expected_ && std::chrono::steady_clock::now() < end) std::this_thread::yield();
        return arrived_ >= expected_;
    }

private:
    int expected_;
    std::atomic<int> arrived_ = 0;
};

} // namespace hachure::test
