#include <hachure/runtime/assert.h>
#include <hachure/runtime/parallel.h>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>

// The thread sanitizer sees our code, but not TBB's, which hands a task from one thread to another. Every hand-over is
// therefore made visible by an atomic of our own, released before the task is spawned and acquired as it starts. Only
// the step from TBB into our code, which reads the task object before that, is kept from the sanitizer.
#define HACHURE_TASK_ENTRY __attribute__((no_sanitize("thread")))

namespace hachure {
namespace {

/// The threads of the process.
class Threads {
public:
    int limit() const { return limit_; }

    void set_limit(int limit) {
        arena_.reset();
        control_.reset();
        limit_ = limit;
    }

    tbb::task_arena& arena() {
        const std::scoped_lock lock(mutex_);
        if (!arena_) {
            control_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(limit_));
            arena_.emplace(limit_);
        }
        return *arena_;
    }

private:
    int limit_ = tbb::info::default_concurrency();
    std::mutex mutex_;
    std::optional<tbb::global_control> control_; ///< without it there are no more threads than cores
    std::optional<tbb::task_arena> arena_;
};

Threads& threads() {
    static Threads instance;
    return instance;
}

/// The exception of the smallest index. Indices below it go on, so which one that is does not depend on threads.
class FirstFailure {
public:
    bool stops(std::size_t index) const { return index > index_.load(std::memory_order_relaxed); }

    void record(std::size_t index) {
        const std::scoped_lock lock(mutex_);
        if (index >= index_.load(std::memory_order_relaxed)) return;
        index_.store(index, std::memory_order_relaxed);
        exception_ = std::current_exception();
    }

    void rethrow() const {
        if (exception_) std::rethrow_exception(exception_);
    }

private:
    std::mutex mutex_;
    std::atomic<std::size_t> index_ = std::numeric_limits<std::size_t>::max();
    std::exception_ptr exception_;
};

/// One `parallel_for`.
class Loop {
public:
    Loop(std::size_t count, const std::function<void(std::size_t)>& body) : count_(count), body_(body) {}

    void run(std::size_t workers) {
        // Several pieces per thread, so that slow ones are made up for.
        piece_ = std::max<std::size_t>(1, count_ / (workers * 8));
        tbb::task_group group;
        started_.store(true, std::memory_order_release);
        for (std::size_t i = 1; i < workers; ++i) group.run(Worker{this});
        work();
        group.wait();
        static_cast<void>(done_.load(std::memory_order_acquire));
        failure_.rethrow();
    }

private:
    struct Worker {
        Loop* loop;
        HACHURE_TASK_ENTRY void operator()() const { loop->work(); }
    };

    void work() noexcept {
        static_cast<void>(started_.load(std::memory_order_acquire));
        for (;;) {
            const std::size_t begin = next_.fetch_add(piece_, std::memory_order_relaxed);
            if (begin >= count_) break;
            for (std::size_t i = begin; i < std::min(begin + piece_, count_) && !failure_.stops(i); ++i) call(i);
        }
        done_.fetch_add(1, std::memory_order_release);
    }

    void call(std::size_t index) {
        try {
            body_(index);
        } catch (...) {
            failure_.record(index);
        }
    }

    std::size_t count_;
    const std::function<void(std::size_t)>& body_;
    std::size_t piece_ = 1;
    FirstFailure failure_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> started_ = false;
    std::atomic<std::size_t> done_ = 0;
};

/// One `parallel_graph`.
class GraphRun {
public:
    GraphRun(const TaskGraph& graph, const std::function<void(std::size_t)>& body)
        : graph_(graph), body_(body), waits_for_(graph.size()) {
        for (std::size_t i = 0; i < graph.size(); ++i)
            waits_for_[i].store(graph.waits_for[i], std::memory_order_relaxed);
    }

    void run() {
        started_.store(true, std::memory_order_release);
        std::uint32_t first = none;
        for (std::uint32_t task = 0; task < graph_.size(); ++task)
            if (graph_.waits_for[task] == 0) take_or_spawn(task, first);
        if (first != none) work(first);
        group_.wait();
        static_cast<void>(done_.load(std::memory_order_acquire));
        failure_.rethrow();
    }

private:
    static constexpr std::uint32_t none = 0xffff'ffffu;

    struct Worker {
        GraphRun* run;
        std::uint32_t task;
        HACHURE_TASK_ENTRY void operator()() const { run->work(task); }
    };

    /// The first of several tasks that are ready is for the thread that found them.
    void take_or_spawn(std::uint32_t task, std::uint32_t& taken) {
        if (taken == none)
            taken = task;
        else
            group_.run(Worker{this, task});
    }

    void work(std::uint32_t task) noexcept {
        static_cast<void>(started_.load(std::memory_order_acquire));
        while (task != none) {
            static_cast<void>(waits_for_[task].load(std::memory_order_acquire));
            if (!failure_.stops(task)) call(task);
            std::uint32_t next = none;
            for (const std::uint32_t follower : graph_.followers[task])
                if (waits_for_[follower].fetch_sub(1, std::memory_order_acq_rel) == 1) take_or_spawn(follower, next);
            task = next;
        }
        done_.fetch_add(1, std::memory_order_release);
    }

    void call(std::uint32_t task) {
        try {
            body_(task);
        } catch (...) {
            failure_.record(task);
        }
    }

    const TaskGraph& graph_;
    const std::function<void(std::size_t)>& body_;
    std::vector<std::atomic<std::uint32_t>> waits_for_;
    FirstFailure failure_;
    std::atomic<bool> started_ = false;
    std::atomic<std::size_t> done_ = 0;
    tbb::task_group group_;
};

} // namespace

void set_thread_limit(int limit) {
    HACHURE_ASSERT(limit >= 1, "work needs a thread");
    threads().set_limit(limit);
}

int thread_limit() { return threads().limit(); }

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
    const std::size_t workers = std::min(count, static_cast<std::size_t>(thread_limit()));
    if (workers <= 1) {
        for (std::size_t i = 0; i < count; ++i) body(i);
        return;
    }
    threads().arena().execute([&] {
        // While it waits, this thread must not begin work of others, such as the next system: the caller may hold
        // locks.
        tbb::this_task_arena::isolate([&] { Loop(count, body).run(workers); });
    });
}

std::uint32_t TaskGraph::add_task() {
    waits_for.push_back(0);
    followers.emplace_back();
    return static_cast<std::uint32_t>(size() - 1);
}

void TaskGraph::add_order(std::uint32_t earlier, std::uint32_t later) {
    HACHURE_ASSERT(earlier < later && later < size(), "a task waits for one of smaller number");
    followers[earlier].push_back(later);
    ++waits_for[later];
}

bool TaskGraph::is_chain() const {
    for (std::uint32_t task = 1; task < size(); ++task)
        if (std::ranges::find(followers[task - 1], task) == followers[task - 1].end()) return false;
    return true;
}

void parallel_graph(const TaskGraph& graph, const std::function<void(std::size_t)>& body) {
    if (thread_limit() == 1 || graph.is_chain()) {
        for (std::size_t i = 0; i < graph.size(); ++i) body(i);
        return;
    }
    threads().arena().execute([&] { GraphRun(graph, body).run(); });
}

} // namespace hachure
