#include <hachure/runtime/ecs/storage/change_log.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hachure {
namespace {

using detail::ChangeLog;
using testing::ElementsAre;
using testing::IsEmpty;

Entity number(std::size_t i) { return {static_cast<std::uint32_t>(i), 1}; }

std::vector<std::uint32_t> numbers_since(const ChangeLog& log, Tick since) {
    EXPECT_TRUE(log.complete_since(since));
    std::vector<std::uint32_t> result;
    for (const auto& [entity, tick] : log.since(since)) {
        EXPECT_GT(tick, since);
        result.push_back(entity.index);
    }
    return result;
}

TEST(ChangeLogTest, BeginsEmpty) {
    const ChangeLog log;
    EXPECT_EQ(log.last_changed(), 0u);
    EXPECT_EQ(log.population(), 0u);
    EXPECT_THAT(numbers_since(log, 0), IsEmpty());
}

TEST(ChangeLogTest, ListsChangesInOrder) {
    ChangeLog log;
    log.note_added(number(1), 1);
    log.note(number(2), 2);
    log.note(number(1), 2);
    log.note(number(3), 4);
    EXPECT_THAT(numbers_since(log, 0), ElementsAre(1, 2, 1, 3));
    EXPECT_THAT(numbers_since(log, 1), ElementsAre(2, 1, 3));
    EXPECT_THAT(numbers_since(log, 3), ElementsAre(3));
    EXPECT_THAT(numbers_since(log, 4), IsEmpty());
    EXPECT_EQ(log.last_changed(), 4u);
}

TEST(ChangeLogTest, RemovalsAreNotListed) {
    ChangeLog log;
    log.note_added(number(1), 1);
    log.note_removed(1, 3);
    EXPECT_EQ(log.population(), 0u);
    EXPECT_EQ(log.last_changed(), 3u);
    EXPECT_THAT(numbers_since(log, 1), IsEmpty());
}

TEST(ChangeLogTest, ManyAreCountedAndNotListed) {
    ChangeLog log;
    log.note(number(1), 1);
    log.note_many(2);
    log.note(number(2), 2);
    EXPECT_FALSE(log.complete_since(1));
    EXPECT_THAT(numbers_since(log, 2), IsEmpty());
    log.note(number(3), 3);
    EXPECT_THAT(numbers_since(log, 2), ElementsAre(3));
    EXPECT_FALSE(log.complete_since(0));
}

TEST(ChangeLogTest, ManyAddedAtOnce) {
    ChangeLog log;
    std::vector<Entity> some;
    for (std::size_t i = 0; i < 256; ++i) some.push_back(number(i));
    log.note_many_added(some, 1);
    EXPECT_EQ(numbers_since(log, 0).size(), 256u);
    some.push_back(number(256));
    log.note_many_added(some, 2);
    EXPECT_FALSE(log.complete_since(1));
    EXPECT_TRUE(log.complete_since(2));
    EXPECT_EQ(log.population(), 513u);
}

TEST(ChangeLogTest, OverflowForgetsTheOlderHalf) {
    ChangeLog log;
    const std::size_t limit = log.limit();
    for (std::size_t i = 0; i < limit; ++i) log.note(number(i), 1 + i);
    EXPECT_EQ(numbers_since(log, 0).size(), limit);
    log.note(number(limit), limit + 1);
    EXPECT_FALSE(log.complete_since(0));
    EXPECT_FALSE(log.complete_since(limit / 2));
    EXPECT_THAT(numbers_since(log, limit), ElementsAre(limit));
    EXPECT_GT(numbers_since(log, limit / 2 + 1).size(), limit / 2 - 2);
}

TEST(ChangeLogTest, OverflowWithinOneTickGivesItUp) {
    ChangeLog log;
    log.note(number(999), 1);
    for (std::size_t i = 0; i < 3 * log.limit(); ++i) log.note(number(i), 2);
    EXPECT_FALSE(log.complete_since(1));
    EXPECT_THAT(numbers_since(log, 2), IsEmpty());
    log.note(number(5), 3);
    EXPECT_THAT(numbers_since(log, 2), ElementsAre(5));
}

TEST(ChangeLogTest, NeverLosesAChangeThatItClaimsToList) {
    // Bursts of every size, one per tick; what it lists since any tick is compared with all that there was.
    ChangeLog log;
    std::vector<ChangeLog::Entry> all;
    Tick now = 1;
    for (std::size_t burst = 1; burst < 400; burst = burst * 7 / 5 + 1) {
        for (int repeat = 0; repeat < 5; ++repeat, ++now) {
            for (std::size_t i = 0; i < burst; ++i) {
                log.note(number(i), now);
                all.push_back({number(i), now});
            }
            for (Tick since = 0; since <= now; ++since) {
                if (!log.complete_since(since)) continue;
                const auto changed = std::ranges::count_if(all, [&](const auto& entry) { return entry.tick > since; });
                ASSERT_EQ(log.since(since).size(), changed) << "tick " << now << " since " << since;
            }
        }
    }
}

TEST(ChangeLogTest, MoreEntitiesMakeALongerQueue) {
    ChangeLog log;
    std::vector<Entity> some(16 * 1000, number(1));
    log.note_many_added(some, 1);
    EXPECT_EQ(log.limit(), 1000u);
    for (std::size_t i = 0; i < 1000; ++i) log.note(number(i), 2);
    EXPECT_EQ(numbers_since(log, 1).size(), 1000u);
    log.note_removed(some.size(), 2);
    EXPECT_EQ(log.limit(), 256u);
    log.note(number(1), 3);
    EXPECT_THAT(numbers_since(log, 2), ElementsAre(1));
}

TEST(ChangeLogTest, ForgetsOneOfThisTick) {
    ChangeLog log;
    log.note(number(1), 1);
    log.note(number(1), 2);
    log.note(number(2), 2);
    log.forget(number(1), 2);
    EXPECT_THAT(numbers_since(log, 0), ElementsAre(1, 2));
    log.forget(number(9), 2);
    EXPECT_THAT(numbers_since(log, 0), ElementsAre(1, 2));
    log.forget(number(2), 3);
    EXPECT_THAT(numbers_since(log, 1), ElementsAre(2));
}

TEST(ChangeLogTest, ForgettingOneOfManyGivesTheTickUp) {
    ChangeLog log;
    for (std::size_t i = 0; i < 100; ++i) log.note(number(i), 1);
    log.forget(number(99), 1);
    EXPECT_EQ(numbers_since(log, 0).size(), 99u);
    log.forget(number(0), 1);
    EXPECT_FALSE(log.complete_since(0)) << "a long search is not worth it";
    EXPECT_THAT(numbers_since(log, 1), IsEmpty());
}

} // namespace
} // namespace hachure
