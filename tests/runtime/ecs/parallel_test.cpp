#include <hachure/runtime/parallel.h>
#include <hachure/tests/runtime/ecs/thread_limit.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace hachure {
namespace {

using test::Meeting;
using test::ThreadLimit;

class ParallelTest : public testing::TestWithParam<int> {
    ThreadLimit limit_{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Threads, ParallelTest, testing::Values(1, 2, 4));

TEST_P(ParallelTest, CallsEachIndexOnce) {
    EXPECT_EQ(thread_limit(), GetParam());
    for (const std::size_t count : {0u, 1u, 2u, 3u, 1000u}) {
        std::vector<int> calls(count);
        parallel_for(count, [&](std::size_t i) { ++calls[i]; });
        EXPECT_EQ(calls, std::vector<int>(count, 1));
    }
}

TEST_P(ParallelTest, ThrowsTheExceptionOfTheSmallestIndex) {
    for (int repeat = 0; repeat < 20; ++repeat) {
        std::vector<int> calls(200);
        try {
            parallel_for(calls.size(), [&](std::size_t i) {
                ++calls[i];
                if (i % 50 == 49) throw std::runtime_error(std::to_string(i));
            });
            FAIL() << "nothing thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "49");
        }
        EXPECT_EQ(std::accumulate(calls.begin(), calls.begin() + 50, 0), 50) << "what came before it was done";
    }
}

TEST_P(ParallelTest, Nests) {
    std::vector<int> sums(20);
    parallel_for(sums.size(), [&](std::size_t i) {
        std::vector<int> parts(50);
        parallel_for(parts.size(), [&](std::size_t j) { parts[j] = static_cast<int>(i + j); });
        sums[i] = std::accumulate(parts.begin(), parts.end(), 0);
    });
    for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_EQ(sums[i], static_cast<int>(50 * i + 1225));
}

/// A grid of tasks, where each waits for those above and to the left.
TaskGraph grid(std::uint32_t side) {
    TaskGraph graph;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        graph.add_task();
        if (i % side > 0) graph.add_order(i - 1, i);
        if (i >= side) graph.add_order(i - side, i);
    }
    return graph;
}

TEST_P(ParallelTest, RunsAGraphInItsOrder) {
    constexpr std::uint32_t side = 8;
    const TaskGraph graph = grid(side);
    for (int repeat = 0; repeat < 20; ++repeat) {
        std::vector<long> paths(side * side); // to the task from the first; plain memory, written by one and read later
        parallel_graph(graph, [&](std::size_t i) {
            paths[i] = i == 0 ? 1 : (i % side > 0 ? paths[i - 1] : 0) + (i >= side ? paths[i - side] : 0);
        });
        EXPECT_EQ(paths.back(), 3432) << "14 choose 7";
    }
}

TEST_P(ParallelTest, AGraphThrowsTheExceptionOfTheSmallestTask) {
    const TaskGraph graph = grid(6);
    for (int repeat = 0; repeat < 20; ++repeat) {
        std::vector<int> calls(36);
        try {
            parallel_graph(graph, [&](std::size_t i) {
                calls[i] = 1;
                if (i == 10 || i == 15 || i == 20) throw std::runtime_error(std::to_string(i)); // one diagonal
            });
            FAIL() << "nothing thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "10");
        }
        EXPECT_EQ(calls[35], 0) << "nothing that waits for a failed task begins";
    }
}

TEST(ParallelThreadsTest, WorkRunsAtTheSameTime) {
    const ThreadLimit limit(4);
    Meeting loop(4);
    parallel_for(4, [&](std::size_t) { EXPECT_TRUE(loop.arrive()); });
    TaskGraph graph;
    for (int i = 0; i < 4; ++i) graph.add_task();
    Meeting tasks(4);
    parallel_graph(graph, [&](std::size_t) { EXPECT_TRUE(tasks.arrive()); });
}

TEST(ParallelThreadsTest, OneThreadIsTheCallingOne) {
    const ThreadLimit limit(1);
    const auto here = std::this_thread::get_id();
    parallel_for(100, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), here); });
    parallel_graph(grid(3), [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), here); });
}

TEST(ParallelThreadsTest, AChainStaysOnTheCallingThread) {
    const ThreadLimit limit(4);
    TaskGraph graph;
    EXPECT_TRUE(graph.is_chain());
    for (std::uint32_t i = 0; i < 5; ++i) {
        graph.add_task();
        if (i > 0) graph.add_order(i - 1, i);
    }
    EXPECT_TRUE(graph.is_chain());
    const auto here = std::this_thread::get_id();
    parallel_graph(graph, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), here); });
    graph.add_task();
    EXPECT_FALSE(graph.is_chain());
}

TEST(ParallelDeathTest, ChecksItsInput) {
    EXPECT_DEATH(set_thread_limit(0), "needs a thread");
    TaskGraph graph;
    graph.add_task();
    EXPECT_DEATH(graph.add_order(0, 0), "smaller number");
}

} // namespace
} // namespace hachure
