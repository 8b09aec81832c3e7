#include <hachure/runtime/assets/frame_pattern.h>
#include <hachure/runtime/assets/frame_rate.h>

#include <gtest/gtest.h>

namespace hachure::assets {
namespace {

TEST(FramePattern, NumbersAreFilledUpWithZeros) {
    EXPECT_EQ(frame_file("out.####.png", 0), "out.0000.png");
    EXPECT_EQ(frame_file("out.####.png", 7), "out.0007.png");
    EXPECT_EQ(frame_file("out.####.png", 9999), "out.9999.png");
    EXPECT_EQ(frame_file("#.exr", 3), "3.exr");
    EXPECT_EQ(frame_file("##", 12), "12");
}

TEST(FramePattern, LongerNumbersTakeTheRoomTheyNeed) {
    EXPECT_EQ(frame_file("out.##.png", 100), "out.100.png");
    EXPECT_EQ(frame_file("#.png", 1234567), "1234567.png");
}

TEST(FramePattern, OnlyTheNameCounts) {
    EXPECT_EQ(frame_file("C#/a##/out.png", 5), "C#/a##/out.png");
    EXPECT_EQ(frame_file("C#/out#.png", 5), "C#/out5.png");
    EXPECT_EQ(count_number_fields("C#/out.png"), 0);
    EXPECT_EQ(count_number_fields("C#/out.###.png"), 1);
    EXPECT_EQ(count_number_fields("#_out.##.png"), 2);
    EXPECT_EQ(count_number_fields("out"), 0);
}

TEST(FrameRate, ReadsWholesDecimalsAndFractions) {
    EXPECT_EQ(parse_frame_rate("30"), (FrameRate{30, 1}));
    EXPECT_EQ(parse_frame_rate("1"), (FrameRate{1, 1}));
    EXPECT_EQ(parse_frame_rate("1000"), (FrameRate{1000, 1}));
    EXPECT_EQ(parse_frame_rate("29.97"), (FrameRate{2997, 100}));
    EXPECT_EQ(parse_frame_rate("12.50"), (FrameRate{25, 2}));
    EXPECT_EQ(parse_frame_rate("23.976024"), (FrameRate{2997003, 125000}));
    EXPECT_EQ(parse_frame_rate("30000/1001"), (FrameRate{30000, 1001}));
    EXPECT_EQ(parse_frame_rate("50/2"), (FrameRate{25, 1}));
}

TEST(FrameRate, RefusesTheRest) {
    for (const char* text : {"",      "0",    "0.5", "-5",  "1000.1", "1001", "fast",      "30fps",
                             " 30",   "1e2",  "30.", ".5",  "30/0",   "/2",   "30/",       "1/2",
                             "3/4/5", "30,5", "+30", "inf", "nan",    "0x1e", "1.0000001", "99999999999999999999"})
        EXPECT_EQ(parse_frame_rate(text), std::nullopt) << text;
}

TEST(FrameRate, FramesBeginWhereTheirNumberSays) {
    EXPECT_EQ((FrameRate{30, 1}.time_of(45)), 1.5);
    EXPECT_EQ((FrameRate{30000, 1001}.time_of(30000)), 1001.0);
    EXPECT_EQ((FrameRate{2997, 100}.time_of(0)), 0.0);
}

} // namespace
} // namespace hachure::assets
