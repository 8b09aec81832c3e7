#include <hachure/runtime/ecs/storage/column_ticks.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace hachure {
namespace {

using detail::ColumnTicks;

constexpr std::uint32_t row_capacity = 40;

TEST(ColumnTicksTest, OneTickForAll) {
    ColumnTicks ticks;
    ticks.place_many(0, 10, row_capacity, 5);
    for (std::uint32_t row = 0; row < 10; ++row) {
        EXPECT_EQ(ticks.changed(row), 5u);
        EXPECT_EQ(ticks.added(row), 5u);
    }
    EXPECT_EQ(ticks.latest(), 5u);
    ticks.mark_all(7);
    EXPECT_EQ(ticks.changed(9), 7u);
    EXPECT_EQ(ticks.added(9), 5u);
    EXPECT_EQ(ticks.latest(), 7u);
}

TEST(ColumnTicksTest, MarksOneRowOnce) {
    ColumnTicks ticks;
    ticks.place_many(0, 3, row_capacity, 1);
    EXPECT_FALSE(ticks.mark(1, row_capacity, 1)) << "placed in this tick already";
    EXPECT_TRUE(ticks.mark(1, row_capacity, 2));
    EXPECT_FALSE(ticks.mark(1, row_capacity, 2));
    EXPECT_EQ(ticks.changed(0), 1u);
    EXPECT_EQ(ticks.changed(1), 2u);
    ticks.mark_all(3);
    EXPECT_FALSE(ticks.mark(1, row_capacity, 3));
    EXPECT_EQ(ticks.changed(2), 3u);
}

TEST(ColumnTicksTest, ARowOfAnOlderTickComesIn) {
    // As when an entity moves in from another table.
    ColumnTicks ticks;
    ticks.place_many(0, 3, row_capacity, 4);
    ticks.mark(1, row_capacity, 6);
    ticks.mark_all(8);
    ticks.place(3, 3, row_capacity, 2, 5);
    EXPECT_EQ(ticks.changed(0), 8u);
    EXPECT_EQ(ticks.changed(1), 8u);
    EXPECT_EQ(ticks.changed(3), 5u);
    EXPECT_EQ(ticks.added(0), 4u);
    EXPECT_EQ(ticks.added(3), 2u);
    EXPECT_EQ(ticks.latest(), 8u);
}

TEST(ColumnTicksTest, TheFirstRowForgetsWhatWasBefore) {
    ColumnTicks ticks;
    ticks.place_many(0, 3, row_capacity, 4);
    ticks.mark(2, row_capacity, 9);
    ticks.place(0, 0, row_capacity, 1, 2);
    EXPECT_EQ(ticks.changed(0), 2u);
    EXPECT_EQ(ticks.added(0), 1u);
    EXPECT_EQ(ticks.latest(), 2u);
}

TEST(ColumnTicksTest, FindsTheNext) {
    ColumnTicks ticks;
    ticks.place_many(0, 10, row_capacity, 1);
    EXPECT_EQ(ticks.next_changed(0, 10, 0), 0u);
    EXPECT_EQ(ticks.next_added(4, 10, 0), 4u);
    EXPECT_EQ(ticks.next_changed(0, 10, 1), 10u);
    EXPECT_EQ(ticks.next_added(0, 10, 1), 10u);
    ticks.mark(3, row_capacity, 2);
    ticks.mark(8, row_capacity, 4);
    EXPECT_EQ(ticks.next_changed(0, 10, 1), 3u);
    EXPECT_EQ(ticks.next_changed(4, 10, 1), 8u);
    EXPECT_EQ(ticks.next_changed(0, 10, 2), 8u);
    EXPECT_EQ(ticks.next_changed(9, 10, 1), 10u);
    EXPECT_EQ(ticks.next_changed(0, 8, 2), 8u) << "rows beyond are none";
    ticks.place(10, 10, row_capacity, 5, 5);
    EXPECT_EQ(ticks.next_added(0, 11, 1), 10u);
}

/// The ticks of the rows of a chunk, one by one.
using Plain = std::vector<std::pair<Tick, Tick>>; // added, changed

void expect_equal(const ColumnTicks& ticks, const Plain& plain) {
    const auto rows = static_cast<std::uint32_t>(plain.size());
    Tick latest = 0;
    for (std::uint32_t row = 0; row < rows; ++row) {
        ASSERT_EQ(ticks.added(row), plain[row].first);
        ASSERT_EQ(ticks.changed(row), plain[row].second);
        latest = std::max(latest, plain[row].second);
    }
    ASSERT_GE(ticks.latest(), latest);
    for (Tick since = latest > 4 ? latest - 4 : 0; since <= latest; ++since) {
        std::uint32_t changed = 0, added = 0;
        while (changed < rows && plain[changed].second <= since) ++changed;
        while (added < rows && plain[added].first <= since) ++added;
        if (rows == 0) continue;
        ASSERT_EQ(ticks.next_changed(0, rows, since), changed);
        ASSERT_EQ(ticks.next_added(0, rows, since), added);
    }
}

class ColumnTicksRandomTest : public testing::TestWithParam<unsigned> {
protected:
    std::mt19937 random{GetParam()};
    ColumnTicks ticks;
    Plain plain;
    Tick now = 1;

    std::uint32_t rows() const { return static_cast<std::uint32_t>(plain.size()); }
    std::uint32_t pick(std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); }

    void place() {
        if (rows() == row_capacity) return;
        const Tick changed = now - pick(static_cast<std::uint32_t>(std::min<Tick>(now, 4)));
        const Tick added = changed - pick(static_cast<std::uint32_t>(std::min<Tick>(changed, 4)));
        ticks.place(rows(), rows(), row_capacity, added, changed);
        plain.emplace_back(added, changed);
    }
    void place_many() {
        const std::uint32_t count = std::min(pick(8), row_capacity - rows());
        if (count == 0) return;
        ticks.place_many(rows(), count, row_capacity, now);
        plain.resize(plain.size() + count, {now, now});
    }
    void place_from_another() {
        if (rows() == row_capacity) return;
        ColumnTicks other;
        other.place_many(0, 3, row_capacity, std::max<Tick>(now, 3) - 2);
        if (pick(2)) other.mark(1, row_capacity, now);
        const std::uint32_t from = pick(3);
        ticks.place(rows(), rows(), row_capacity, other, from);
        plain.emplace_back(other.added(from), other.changed(from));
    }
    void mark() {
        if (plain.empty()) return;
        const std::uint32_t row = pick(rows());
        ASSERT_EQ(ticks.mark(row, row_capacity, now), plain[row].second != now);
        plain[row].second = now;
    }
    void mark_all() {
        if (plain.empty()) return;
        ticks.mark_all(now);
        for (auto& [added, changed] : plain) changed = now;
    }
    void drop() {
        if (plain.empty()) return;
        const std::uint32_t row = pick(rows());
        if (row + 1 < rows()) ticks.move(row, rows() - 1);
        plain[row] = plain.back();
        plain.pop_back();
    }
};
INSTANTIATE_TEST_SUITE_P(Seeds, ColumnTicksRandomTest, testing::Range(0u, 20u));

TEST_P(ColumnTicksRandomTest, BehaveAsATickPerRow) {
    now = 3;
    for (int step = 0; step < 3000; ++step) {
        switch (pick(8)) {
        case 0:
        case 1:
            place();
            break;
        case 2:
            place_many();
            break;
        case 3:
            place_from_another();
            break;
        case 4:
            mark();
            break;
        case 5:
            if (pick(4) == 0) mark_all();
            break;
        case 6:
            for (std::uint32_t i = pick(pick(10) == 0 ? row_capacity : 6); i > 0; --i) drop();
            break;
        default:
            now += pick(2);
        }
        expect_equal(ticks, plain);
        if (HasFatalFailure()) FAIL() << "step " << step;
    }
}

} // namespace
} // namespace hachure
