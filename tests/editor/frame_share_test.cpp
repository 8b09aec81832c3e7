#include <hachure/editor/frame_share.h>
#include <hachure/editor/usage_error.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace hachure {
namespace {

TEST(FrameShare, ReadsItsText) {
    const FrameShare share = parse_frame_share("2/7");
    EXPECT_EQ(share.index, 2);
    EXPECT_EQ(share.count, 7);
    for (const char* text : {"", "1", "/", "1/", "/2", "0/2", "3/2", "-1/2", "1/2/3", " 1/2", "1/2 ", "1.5/2", "a/b",
                             "1/1000001", "1/99999999999999999999"})
        EXPECT_THROW(static_cast<void>(parse_frame_share(text)), UsageError) << text;
}

TEST(FrameShare, SharesAreAllFramesOnceInOrderAndAlikeInSize) {
    for (const std::int64_t frames : {1, 2, 7, 100, 101})
        for (const std::int64_t count : {1, 2, 3, 7, 100, 150}) {
            FramePlan plan;
            plan.first = 5;
            plan.last = 5 + frames - 1;
            std::int64_t next = plan.first, smallest = frames, largest = 0;
            for (std::int64_t index = 1; index <= count; ++index) {
                const std::optional<FramePlan> share = share_of(plan, {index, count});
                const std::int64_t size = share ? share->count() : 0;
                EXPECT_EQ(share ? share->first : next, next);
                smallest = std::min(smallest, size);
                largest = std::max(largest, size);
                next += size;
            }
            EXPECT_EQ(next, plan.last + 1) << frames << " in " << count;
            EXPECT_LE(largest - smallest, 1) << frames << " in " << count;
        }
}

} // namespace
} // namespace hachure
