#include <hachure/editor/frame_plan.h>
#include <hachure/editor/usage_error.h>

#include <gtest/gtest.h>

namespace hachure {
namespace {

TEST(FramePlan, ReadsRangesAndSingleFrames) {
    const FramePlan range = parse_frame_plan("10..19", "", "25");
    EXPECT_EQ(range.first, 10);
    EXPECT_EQ(range.last, 19);
    EXPECT_EQ(range.count(), 10);
    EXPECT_TRUE(range.numbered);
    const FramePlan one = parse_frame_plan("7", "", "25");
    EXPECT_EQ(one.first, 7);
    EXPECT_EQ(one.count(), 1);
    EXPECT_TRUE(one.numbered);
    EXPECT_FALSE(parse_frame_plan("", "", "30").numbered);
}

TEST(FramePlan, FrameKShowsKOverTheRateWhereverItBegins) {
    EXPECT_EQ(parse_frame_plan("10..19", "", "25").seconds(15), 0.6);
    EXPECT_EQ(parse_frame_plan("15", "", "25").seconds(15), 0.6);
    EXPECT_EQ(parse_frame_plan("", "1.25", "25").seconds(0), 1.25);
    EXPECT_EQ(parse_frame_plan("", "", "25").seconds(0), 0.0);
}

TEST(FramePlan, RefusesTheRest) {
    for (const char* frames : {"..", "1..", "..1", "1...2", "-1..2", "a..b", "1.5", "1..2..3", " 1", "1,2", "2..1",
                               "0..99999999", "0..1000000", "99999999999999999999", "0x1"})
        EXPECT_THROW(static_cast<void>(parse_frame_plan(frames, "", "30")), UsageError) << frames;
    for (const char* time : {"-1", "now", "1s", "nan", "inf", "1e9", "1..2", " 1"})
        EXPECT_THROW(static_cast<void>(parse_frame_plan("", time, "30")), UsageError) << time;
    for (const char* fps : {"0", "-5", "1001", "fast", "", "30/0"})
        EXPECT_THROW(static_cast<void>(parse_frame_plan("", "", fps)), UsageError) << fps;
}

} // namespace
} // namespace hachure
