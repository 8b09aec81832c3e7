#include <hachure/runtime/assets/svg_file.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/svg_raster.h>
#include <hachure/tests/support/temp_folder.h>

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>
#include <numeric>

namespace hachure::assets {
namespace {

using test::rasterise;
using test::read_svg_paths;
using test::SvgPath;

SvgDrawing drawing_of(const SvgLine& line, const std::string& label = "lines") {
    return {.width = 100,
            .height = 80,
            .layers = {{.label = label, .id = "l", .color = {1.0f, 0.0f, 0.2159f}, .lines = {line}, .layers = {}}}};
}

double painted(const std::vector<SvgPath>& paths) {
    const std::vector<double> pixels = rasterise(paths, 100, 80);
    return std::accumulate(pixels.begin(), pixels.end(), 0.0);
}

TEST(SvgFile, ALineOfOneWidthIsAPath) {
    const std::string text = svg_text(drawing_of({{{{10, 20}, 4, 1}, {{50, 20}, 4, 1}, {{50, 60.256f}, 4, 1}}}));
    EXPECT_NE(text.find("<svg xmlns=\"http://www.w3.org/2000/svg\""), text.npos);
    EXPECT_NE(text.find("viewBox=\"0 0 100 80\""), text.npos);
    EXPECT_NE(text.find("<rect id=\"background\" width=\"100\" height=\"80\" fill=\"#ffffff\"/>"), text.npos);
    EXPECT_NE(
        text.find("d=\"M10.00 20.00L50.00 20.00L50.00 60.26\" fill=\"none\" stroke=\"#ff0080\" stroke-width=\"4.00\""),
        text.npos)
        << text;
    EXPECT_EQ(text.find("opacity"), text.npos);
    const SvgLine loop{{{{10, 20}, 4, .5f}, {{50, 20}, 4, .5f}, {{30, 60}, 4, .5f}, {{10, 20}, 4, .5f}}, true};
    EXPECT_NE(svg_text(drawing_of(loop)).find("L30.00 60.00Z\""), text.npos);
    EXPECT_NE(svg_text(drawing_of(loop)).find("stroke-opacity=\"0.500\""), text.npos);
}

/// Widths are kept: the outline has the area of the line.
TEST(SvgFile, ALineWhoseWidthVariesIsItsOutline) {
    const auto paths = read_svg_paths(svg_text(drawing_of({{{{20, 40}, 4, 1}, {{50, 40}, 12, 1}, {{80, 40}, 4, 1}}})));
    ASSERT_EQ(paths.size(), 1u);
    EXPECT_TRUE(paths[0].filled);
    EXPECT_NEAR(painted(paths), 60 * 8 + std::numbers::pi * 4, 2.0); // round ends of radius 2
    const std::vector<glm::dvec2> middle = paths[0].middle();
    ASSERT_EQ(middle.size(), 3u);
    EXPECT_NEAR(glm::distance(middle[1], glm::dvec2(50, 40)), 0.0, 0.01);
}

TEST(SvgFile, OpacityThatVariesIsLaidOnInSteps) {
    const auto paths = read_svg_paths(svg_text(drawing_of({{{{10, 40}, 6, 1}, {{40, 40}, 6, 1}, {{90, 40}, 6, 0}}})));
    EXPECT_EQ(paths.size(), 12u);
    const std::vector<double> pixels = rasterise(paths, 100, 80);
    for (int x = 10; x < 90; ++x) {
        const double wanted = x < 40 ? 1.0 : 1.0 - (x + 0.5 - 40) / 50.0;
        EXPECT_NEAR(pixels[static_cast<std::size_t>(40 * 100 + x)], wanted, 0.55 / 12.0) << x;
    }
    EXPECT_EQ(svg_text(drawing_of({{{{10, 40}, 6, 0}, {{40, 40}, 6, 0}}})).find("<path"), std::string::npos);
}

TEST(SvgFile, LabelsAreEscaped) {
    const SvgLine line{{{{1, 1}, 1, 1}, {{2, 2}, 1, 1}}};
    const std::string text = svg_text(drawing_of(line, "a<b>&\"c\"\n\x01\xff \xc3\xa9\xed\xa0\x80"));
    EXPECT_NE(text.find("inkscape:label=\"a&lt;b&gt;&amp;&quot;c&quot;??? \xc3\xa9???\""), text.npos) << text;
}

TEST(SvgFile, IsWrittenWholeAndKnownAsSuch) {
    const test::TempFolder folder;
    const SvgDrawing drawing = drawing_of({{{{1, 1}, 1, 1}, {{2, 2}, 1, 1}}});
    write_svg(folder / "a.svg", drawing);
    EXPECT_TRUE(is_whole_svg(folder / "a.svg", 100, 80));
    EXPECT_FALSE(is_whole_svg(folder / "a.svg", 100, 81));
    EXPECT_FALSE(is_whole_svg(folder / "b.svg", 100, 80));
    const std::string text = svg_text(drawing);
    std::ofstream(folder / "b.svg") << text.substr(0, text.size() - 3);
    EXPECT_FALSE(is_whole_svg(folder / "b.svg", 100, 80));
    EXPECT_THROW(write_svg(folder / "none" / "a.svg", drawing), Error);
}

} // namespace
} // namespace hachure::assets
