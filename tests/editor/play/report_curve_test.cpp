#include <hachure/editor/play/report_curve.h>

#include <gtest/gtest.h>

#include <limits>
#include <regex>

namespace hachure::play {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// What the line goes through: pairs of numbers after M and L.
std::vector<std::pair<double, double>> points(const std::string& html) {
    std::vector<std::pair<double, double>> result;
    const std::regex pattern("[ML]([0-9.]+) ([0-9.]+)");
    for (auto i = std::sregex_iterator(html.begin(), html.end(), pattern); i != std::sregex_iterator(); ++i)
        result.emplace_back(std::stod((*i)[1]), std::stod((*i)[2]));
    return result;
}

TEST(ReportCurve, TheLineGoesThroughTheValues) {
    const auto line = points(html_curve({.name = "c", .values = {0, 1, 2, 4}}));
    ASSERT_EQ(line.size(), 4u);
    EXPECT_EQ(line[0], std::pair(0.0, 200.0)); // 0 is the ground
    EXPECT_EQ(line[3], std::pair(1000.0, 0.0));
    EXPECT_EQ(line[2], std::pair(666.67, 100.0));
}

TEST(ReportCurve, FramesOutsideTheLimitsAreShaded) {
    const Curve curve{.name = "c", .values = {1, 9, 9, 1, -3, 1, 1, 1, 1, 1, 1}, .at_least = 0.0, .at_most = 8.0};
    const std::string html = html_curve(curve);
    EXPECT_EQ(frames_outside(curve), (std::vector<std::int64_t>{1, 2, 4}));
    EXPECT_EQ(occurrences(html, "class=\"band\""), 2u);
    EXPECT_NE(html.find("left:5.000%;width:20.000%"), std::string::npos) << html; // frames 1 and 2, half way around
    EXPECT_NE(html.find("left:35.000%;width:10.000%"), std::string::npos) << html;
    EXPECT_NE(html.find("at most 8"), std::string::npos);
    EXPECT_NE(html.find("at least 0"), std::string::npos);
    EXPECT_NE(html.find("3 of 11 outside"), std::string::npos);
}

TEST(ReportCurve, WithoutLimitsNothingIsWrong) {
    const std::string html = html_curve({.name = "c", .values = {1, 900, nan}});
    EXPECT_EQ(occurrences(html, "class=\"band\"") + occurrences(html, "class=\"zone\"") +
                  occurrences(html, "class=\"limit"),
              0u);
}

TEST(ReportCurve, WhatIsNoNumberInterruptsTheLine) {
    const std::string html = html_curve({.name = "c", .values = {1, nan, 2, 3, infinite, 1}, .at_most = 5.0});
    EXPECT_EQ(occurrences(html, "M"), 3u);
    EXPECT_EQ(occurrences(html, "class=\"band\""), 2u) << "neither is at most 5";
    EXPECT_NE(html.find("data-values=\"1 x 2 3 x 1\""), std::string::npos);
}

TEST(ReportCurve, DrawsWhateverItIsGiven) {
    for (const std::vector<double>& values :
         {std::vector<double>{}, {5}, {nan}, {0, 0, 0}, {7, 7}, {1e300, -1e300}, {1e-300, 2e-300}, {-5, -4.999999}})
        for (const std::optional<double> limit :
             {std::optional<double>(), std::optional(0.0), std::optional(infinite)}) {
            const std::string html =
                html_curve({.name = "<c>", .unit = "\"", .first_frame = 7, .values = values, .at_most = limit});
            EXPECT_EQ(html.find("nan"), std::string::npos) << html;
            EXPECT_EQ(html.find("inf"), std::string::npos) << html;
            EXPECT_EQ(html.find("<c>"), std::string::npos) << html;
            EXPECT_LE(occurrences(html, "class=\"grid\""), 12u) << html;
        }
}

} // namespace
} // namespace hachure::play
