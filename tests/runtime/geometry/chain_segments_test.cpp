#include <hachure/runtime/geometry/chain_segments.h>
#include <hachure/runtime/geometry/surface_segment.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

namespace hachure::geometry {
namespace {

struct Chained {
    std::vector<SegmentEnds> ends;
    std::vector<float> lengths;
    std::vector<ChainedSegment> order;
    ChainSegmentsJob job;

    explicit Chained(std::vector<SegmentEnds> given)
        : ends(std::move(given)), lengths(ends.size()), order(ends.size()) {
        std::iota(lengths.begin(), lengths.end(), 1.0f); // segment i is i + 1 long
        run();
    }
    Chained(const Chained&) = delete;
    Chained& operator=(const Chained&) = delete;

    void run() {
        job.ends = ends;
        job.lengths = lengths;
        job.order = order;
        job.validate();
        job.run();
    }
    std::vector<int> segments(std::size_t chain) const { // ~segment where it is reversed
        std::vector<int> result;
        for (std::uint32_t i = 0; i < job.chains[chain].count; ++i) {
            const ChainedSegment& s = order[job.chains[chain].first + i];
            result.push_back(s.reversed ? ~static_cast<int>(s.segment) : static_cast<int>(s.segment));
        }
        return result;
    }
};

TEST(ChainSegments, NothingGivesNothing) { EXPECT_TRUE(Chained({}).job.chains.empty()); }

TEST(ChainSegments, PiecesInAnyOrderAndDirectionAreOneChain) {
    const Chained c({{2, 3}, {1, 0}, {2, 1}, {4, 3}}); // 0 - 1 - 2 - 3 - 4
    ASSERT_EQ(c.job.chains.size(), 1u);
    EXPECT_EQ(c.segments(0), (std::vector<int>{~1, ~2, 0, ~3})) << "in the direction of the first segment given";
    EXPECT_EQ(c.order[0].arc, 0.0f);
    EXPECT_EQ(c.order[1].arc, 2.0f);
    EXPECT_EQ(c.order[2].arc, 5.0f);
    EXPECT_EQ(c.order[3].arc, 6.0f);
    EXPECT_EQ(c.job.chains[0].length, 10.0f);
    EXPECT_EQ(c.job.chains[0].closed, 0u);
}

TEST(ChainSegments, ALoopBeginsWithItsFirstSegment) {
    const Chained c({{7, 8}, {9, 7}, {9, 8}});
    ASSERT_EQ(c.job.chains.size(), 1u);
    EXPECT_EQ(c.segments(0), (std::vector<int>{0, ~2, 1}));
    EXPECT_EQ(c.job.chains[0].closed, 1u);
}

TEST(ChainSegments, JunctionsEndAllChains) {
    const Chained c({{0, 5}, {5, 1}, {2, 5}, {2, 3}}); // three meet at 5
    ASSERT_EQ(c.job.chains.size(), 3u);
    EXPECT_EQ(c.segments(0), std::vector<int>{0});
    EXPECT_EQ(c.segments(1), std::vector<int>{1});
    EXPECT_EQ(c.segments(2), (std::vector<int>{~3, 2}));
}

TEST(ChainSegments, ALoopFromAJunctionIsClosed) {
    const Chained c({{0, 5}, {5, 1}, {1, 2}, {2, 5}});
    ASSERT_EQ(c.job.chains.size(), 2u);
    EXPECT_EQ(c.job.chains[0].closed, 0u);
    EXPECT_EQ(c.segments(1), (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(c.job.chains[1].closed, 1u);
}

TEST(ChainSegments, FreeEndsMeetNothing) {
    const Chained c({{free_end, free_end}, {free_end, 4}, {4, free_end}});
    ASSERT_EQ(c.job.chains.size(), 2u);
    EXPECT_EQ(c.job.chains[0].count, 1u);
    EXPECT_EQ(c.job.chains[0].closed, 0u);
    EXPECT_EQ(c.job.chains[1].count, 2u);
}

TEST(ChainSegments, ASegmentFromAPlaceToItselfIsALoop) {
    const Chained c({{3, 3}, {1, 2}});
    ASSERT_EQ(c.job.chains.size(), 2u);
    EXPECT_EQ(c.job.chains[0].closed, 1u);
    EXPECT_EQ(c.job.chains[0].count, 1u);
}

TEST(ChainSegments, EverySegmentIsInOneChainAndNeighboursMeet) {
    std::mt19937 random(4);
    for (int round = 0; round < 300; ++round) {
        std::vector<SegmentEnds> ends;
        const std::size_t count = 1 + random() % 60;
        const auto any = [&] { return (random() % (count + 2)) * 0x100000001u; };
        for (std::size_t i = 0; i < count; ++i) ends.push_back({any(), any()});
        std::map<std::uint64_t, int> degree;
        for (const SegmentEnds& e : ends) {
            ++degree[e.start];
            ++degree[e.end];
        }
        Chained c(ends);
        std::vector<int> seen(count, 0);
        std::uint32_t next = 0;
        for (const Chain& chain : c.job.chains) {
            ASSERT_EQ(chain.first, next);
            next += chain.count;
            const auto end_of = [&](std::uint32_t i, bool last) {
                const ChainedSegment& s = c.order[chain.first + i];
                return (s.reversed != 0) != last ? ends[s.segment].end : ends[s.segment].start;
            };
            float arc = 0.0f;
            for (std::uint32_t i = 0; i < chain.count; ++i) {
                const ChainedSegment& s = c.order[chain.first + i];
                ++seen[s.segment];
                ASSERT_EQ(s.arc, arc);
                arc += c.lengths[s.segment];
                if (i == 0) continue;
                ASSERT_EQ(end_of(i, false), end_of(i - 1, true));
                ASSERT_EQ(degree[end_of(i, false)], 2);
            }
            ASSERT_EQ(chain.length, arc);
            const std::uint64_t first = end_of(0, false), last = end_of(chain.count - 1, true);
            ASSERT_EQ(chain.closed != 0, first == last);
            if (first == last) continue;
            ASSERT_NE(degree[first], 2) << "it could go on";
            ASSERT_NE(degree[last], 2);
        }
        ASSERT_EQ(next, count);
        ASSERT_TRUE(std::ranges::all_of(seen, [](int n) { return n == 1; }));
        const std::vector<Chain> before = c.job.chains;
        c.run(); // again, with what scratch is left
        ASSERT_EQ(c.job.chains.size(), before.size());
    }
}

} // namespace
} // namespace hachure::geometry
