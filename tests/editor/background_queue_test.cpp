#include <hachure/editor/background_queue.h>

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace hachure {
namespace {

TEST(BackgroundQueue, DoesAllInOrder) {
    for (const std::size_t limit : {0u, 1u, 3u}) {
        std::vector<int> done;
        BackgroundQueue queue(limit);
        for (int i = 0; i < 100; ++i) queue.push([&done, i] { done.push_back(i); });
        queue.finish();
        ASSERT_EQ(done.size(), 100u);
        for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i) << limit;
    }
}

TEST(BackgroundQueue, WaitsWhileThereIsNoRoom) {
    std::atomic<int> given = 0, done = 0;
    std::atomic<int> most = 0;
    BackgroundQueue queue(2);
    for (int i = 0; i < 50; ++i) {
        queue.push([&] {
            std::this_thread::sleep_for(std::chrono::microseconds(200));
            ++done;
        });
        ++given;
        most = std::max(most.load(), given - done);
    }
    queue.finish();
    EXPECT_LE(most, 4); // two wait, one is being done, one may have been counted late
}

TEST(BackgroundQueue, WorksBesideTheOneThatGives) {
    std::atomic<bool> go = false;
    BackgroundQueue queue(1);
    queue.push([&go] {
        while (!go) std::this_thread::yield();
    });
    go = true; // reached only because push did not wait for the work
    queue.finish();
}

TEST(BackgroundQueue, AFaultComesOutAndDropsTheRest) {
    for (const std::size_t limit : {0u, 1u, 3u}) {
        std::atomic<int> later = 0;
        BackgroundQueue queue(limit);
        const auto give = [&] {
            queue.push([] { throw std::runtime_error("full"); });
            for (int i = 0; i < 10; ++i) queue.push([&later] { ++later; });
            queue.finish();
        };
        EXPECT_THROW(give(), std::runtime_error) << limit;
        EXPECT_LE(later, limit == 0 ? 0 : 10);
    }
}

TEST(BackgroundQueue, EndsOnlyAfterWhatItBegan) {
    std::atomic<bool> begun = false;
    std::atomic<int> done = 0;
    {
        BackgroundQueue queue(3);
        queue.push([&] {
            begun = true;
            std::this_thread::sleep_for(std::chrono::milliseconds(20)); // while the queue is being destroyed
            ++done;
        });
        queue.push([&done] { done += 100; }); // dropped, unless the test was slow
        while (!begun) std::this_thread::yield();
    }
    EXPECT_EQ(done % 100, 1);
}

} // namespace
} // namespace hachure
