#include <hachure/editor/frame_walk.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hachure {
namespace {

/// The walk in words: "2" for a frame that is drawn, "(1)" for one that is only lived through.
std::string walk(const FramePlan& plan, const std::vector<std::int64_t>& wanted, FrameHistory history) {
    std::string text;
    double last = -1.0;
    walk_frames(plan, wanted, history, [&](const FrameStep& step) {
        EXPECT_GT(step.seconds, last) << "time goes forward";
        last = step.seconds;
        const std::string number = std::to_string(step.number);
        text += (text.empty() ? "" : " ") + (step.drawn ? number : "(" + number + ")");
    });
    return text;
}

TEST(FrameWalk, JumpsWhereNothingBuildsUp) {
    EXPECT_EQ(walk(parse_frame_plan("3..6", "", "30"), {3, 4, 6}, FrameHistory::none), "3 4 6");
}

TEST(FrameWalk, MotionNeedsTheFrameBefore) {
    EXPECT_EQ(walk(parse_frame_plan("0..2", "", "30"), {0, 1, 2}, FrameHistory::motion), "0 1 2");
    EXPECT_EQ(walk(parse_frame_plan("3..8", "", "30"), {3, 4, 8}, FrameHistory::motion), "(2) 3 4 (7) 8");
}

TEST(FrameWalk, WhatBuildsUpIsSteppedFromTheBeginning) {
    EXPECT_EQ(walk(parse_frame_plan("3..8", "", "30"), {3, 6}, FrameHistory::whole), "(0) (1) (2) 3 (4) (5) 6");
    EXPECT_EQ(walk(parse_frame_plan("0..1", "", "30"), {0, 1}, FrameHistory::whole), "0 1");
}

TEST(FrameWalk, AMomentIsReachedByTheFramesBeforeIt) {
    EXPECT_EQ(walk(parse_frame_plan("", "0.5", "4"), {0}, FrameHistory::whole), "(0) (1) 0");
    EXPECT_EQ(walk(parse_frame_plan("", "0.6", "4"), {0}, FrameHistory::whole), "(0) (1) (2) 0");
    EXPECT_EQ(walk(parse_frame_plan("", "0.6", "4"), {0}, FrameHistory::none), "0");
}

} // namespace
} // namespace hachure
