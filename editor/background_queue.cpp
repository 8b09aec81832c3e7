#include <hachure/editor/background_queue.h>

#include <utility>

namespace hachure {

BackgroundQueue::BackgroundQueue(std::size_t limit) : limit_(limit) {
    if (limit_ > 0) thread_ = std::thread([this] { run(); });
}

BackgroundQueue::~BackgroundQueue() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        waiting_.clear();
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void BackgroundQueue::push(std::function<void()> work) {
    if (limit_ == 0) return work();
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return waiting_.size() < limit_ || fault_; });
        rethrow();
        waiting_.push_back(std::move(work));
    }
    changed_.notify_all();
}

void BackgroundQueue::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.empty() && !busy_; });
    rethrow();
}

/// With the lock held. An exception comes out once.
void BackgroundQueue::rethrow() {
    if (fault_) std::rethrow_exception(std::exchange(fault_, nullptr));
}

void BackgroundQueue::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
        if (ending_) return;
        std::function<void()> work = std::move(waiting_.front());
        waiting_.pop_front();
        busy_ = true;
        lock.unlock();
        changed_.notify_all();
        std::exception_ptr fault;
        try {
            work();
        } catch (...) {
            fault = std::current_exception();
        }
        work = nullptr;
        lock.lock();
        busy_ = false;
        if (fault) {
            fault_ = fault;
            waiting_.clear();
        }
        changed_.notify_all();
    }
}

} // namespace hachure
