#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace hachure {

/// Lets parallel work use at most `limit` threads (1 or more; it may exceed the number of cores), the calling one
/// included; 1 keeps everything on the calling thread. Not while such work is under way. Results never depend on it.
void set_thread_limit(int limit);

/// How many threads parallel work uses at most; as many as the hardware runs at once until `set_thread_limit`.
int thread_limit();

/// Calls `body(i)` for each i below `count`, on several threads at once and in no order; returns when all are done.
/// Calls must not touch what another one writes. Where some throw, none with a greater i begins any more, and the
/// exception of the smallest i is rethrown. May be called from within a body.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// Tasks 0, 1, ... of which some wait for others, always for ones of smaller number.
struct TaskGraph {
    std::vector<std::uint32_t> waits_for;              ///< by task: how many tasks have it among their followers
    std::vector<std::vector<std::uint32_t>> followers; ///< by task: those that wait for it, each once

    std::size_t size() const { return waits_for.size(); }

    /// Appends a task without followers that waits for nothing; returns its number.
    std::uint32_t add_task();

    /// Makes `later` wait for `earlier`, a smaller number; once per pair.
    void add_order(std::uint32_t earlier, std::uint32_t later);

    /// Whether the order of the tasks is given completely, so that threads cannot help.
    bool is_chain() const;
};

/// Calls `body(task)` for each task of the graph after those that it waits for; tasks that do not wait for each other
/// run at the same time. Exceptions as in `parallel_for`.
void parallel_graph(const TaskGraph& graph, const std::function<void(std::size_t)>& body);

} // namespace hachure
