#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace hachure {

/// Does work in the order in which it is given, on a thread of its own, beside the one that gives it. When some of it
/// throws, the rest is dropped and the exception comes out of the next `push` or of `finish`.
class BackgroundQueue {
public:
    /// At most `limit` pieces of work wait; with 0 there is no thread, and `push` does the work itself.
    explicit BackgroundQueue(std::size_t limit);

    /// Waits for the piece of work that is being done and drops those that wait.
    ~BackgroundQueue();
    BackgroundQueue(const BackgroundQueue&) = delete;
    BackgroundQueue& operator=(const BackgroundQueue&) = delete;

    /// Adds `work`; waits while there is no room for it. Throws what earlier work threw.
    void push(std::function<void()> work);

    /// Waits until all is done. Throws what the work threw.
    void finish();

private:
    void run();
    void rethrow();

    std::size_t limit_;
    std::mutex mutex_;
    std::condition_variable changed_; // any of what follows
    std::deque<std::function<void()>> waiting_;
    std::exception_ptr fault_;
    bool busy_ = false;
    bool ending_ = false;
    std::thread thread_;
};

} // namespace hachure
