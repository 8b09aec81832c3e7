#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/picture/line_distance.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/svg_raster.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace hachure::test {
namespace {

constexpr const char* bunny = "/usr/share/glmark2/models/bunny.obj";

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// How many of so many are farther than half a pixel, and the farthest.
struct Distances {
    int count = 0, off = 0;
    double most = 0.0;

    void add(double distance) {
        ++count;
        off += distance > 0.5;
        most = std::max(most, distance);
    }
};

/// From pixels that draw a line to the nearest that the drawing draws.
Distances from_pixels(const assets::Image& opacity, int channel, const std::vector<double>& drawing) {
    std::vector<bool> drawn;
    for (const double value : drawing) drawn.push_back(value >= 0.1);
    const std::vector<double> squared = picture::squared_distances(drawn, opacity.width, opacity.height);
    Distances result;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (opacity.f32()[2 * i + static_cast<std::size_t>(channel)] >= 0.5f) result.add(std::sqrt(squared[i]));
    return result;
}

double distance_to_drawn(const assets::Image& opacity, glm::dvec2 p) {
    constexpr int reach = 6;
    double least = reach;
    const glm::ivec2 pixel(p);
    for (int y = std::max(0, pixel.y - reach); y <= std::min(opacity.height - 1, pixel.y + reach); ++y)
        for (int x = std::max(0, pixel.x - reach); x <= std::min(opacity.width - 1, pixel.x + reach); ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(opacity.width) + static_cast<std::size_t>(x);
            if (std::max(opacity.f32()[2 * i], opacity.f32()[2 * i + 1]) < 0.02f) continue;
            least = std::min(least, std::hypot(std::max(0.0, std::abs(p.x - x - 0.5) - 0.5),
                                               std::max(0.0, std::abs(p.y - y - 0.5) - 0.5)));
        }
    return least;
}

/// From the middles of the drawing's lines to the nearest pixel that draws one.
Distances from_middles(const std::vector<SvgPath>& paths, const assets::Image& opacity) {
    Distances result;
    for (const SvgPath& path : paths) {
        if (path.opacity < 0.085) continue; // the first step of opacity: hardly to be seen
        const std::vector<glm::dvec2> middle = path.middle();
        for (std::size_t i = 0; i + 1 < middle.size(); ++i) {
            const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * glm::distance(middle[i], middle[i + 1]))));
            for (int k = 0; k < steps; ++k)
                result.add(distance_to_drawn(opacity, glm::mix(middle[i], middle[i + 1], double(k) / steps)));
        }
    }
    return result;
}

/// The drawing is read and painted by code that shares nothing with what wrote it.
TEST(Svg, LinesAreThoseOfThePixels) {
    if (!std::filesystem::exists(bunny)) GTEST_SKIP() << "glmark2-data is not installed";
    const TempFolder folder;
    ASSERT_TRUE(succeeded(
        hachure_program(folder, {"render", bunny, "-o", "b.svg", "--style", "lines", "--set",
                                 "abstracted_lines.width=4", "--size", "640x480", "--aov", "line_opacity=b.exr"})));
    const std::vector<SvgPath> paths = read_svg_paths(text_of(folder / "b.svg"));
    const assets::Image opacity = assets::read_image(folder / "b.exr");
    ASSERT_GT(paths.size(), 20u);
    std::vector<double> light = rasterise(paths, 640, 480, "-highlight");
    const std::vector<double> specular = rasterise(paths, 640, 480, "-specular");
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = std::max(light[i], specular[i]);
    for (const auto& [channel, drawing] : {std::pair(0, rasterise(paths, 640, 480, "-dark")), {1, light}}) {
        const Distances pixels = from_pixels(opacity, channel, drawing);
        EXPECT_GT(pixels.count, 100) << channel;
        EXPECT_LE(pixels.off, pixels.count / 150) << channel;
        EXPECT_LE(pixels.most, 4.0) << channel << ": the width of a line";
    }
    // Gaps that links close are where no pixel is drawn.
    const Distances middles = from_middles(paths, opacity);
    EXPECT_GT(middles.count, 1000);
    EXPECT_LE(middles.off, middles.count / 100);
    EXPECT_LE(middles.most, 4.0);
    RecordProperty("middles", std::to_string(middles.off) + " of " + std::to_string(middles.count) + ", most " +
                                  std::to_string(middles.most));
    int of_one_width = 0;
    for (const SvgPath& path : paths) {
        if (path.filled) continue;
        of_one_width += path.width == 4.0; // that of the component; what few pixels show is narrower
        ASSERT_LE(path.width, 4.0);
    }
    EXPECT_GT(of_one_width, 5);
}

/// Two bodies with names that XML must not take as they are.
class SvgScene : public ::testing::Test {
protected:
    void SetUp() override {
        std::ofstream(folder / "body.obj") << tetrahedron_obj;
        std::ofstream(folder / "two.scene.json") << R"({
  "hachure_scene": 1,
  "entities": [
    {"name": "a <b> & \"c\"", "model": "body.obj", "transform": {"translation": [-1.4, 0, 0]}},
    {"name": "plain", "model": "body.obj", "transform": {"translation": [1.4, 0, 0], "rotation": [0, 0.28, 0, 0.96]}}
  ]
})";
    }
    ProcessResult render(std::vector<std::string> arguments) const {
        std::vector<std::string> all{"render", "two.scene.json", "--style", "lines", "--size", "200x150"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return hachure_program(folder, all);
    }

    TempFolder folder;
};

TEST_F(SvgScene, HasALayerPerEntityAndKind) {
    ASSERT_TRUE(succeeded(render({"-o", "two.svg"})));
    const std::string text = text_of(folder / "two.svg");
    EXPECT_TRUE(text.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns="));
    EXPECT_TRUE(text.ends_with("</svg>\n"));
    EXPECT_NE(text.find("inkscape:groupmode=\"layer\" inkscape:label=\"a &lt;b&gt; &amp; &quot;c&quot;/body\""),
              text.npos)
        << text.substr(0, 600);
    EXPECT_NE(text.find("inkscape:label=\"plain/body\""), text.npos);
    EXPECT_NE(text.find("inkscape:label=\"dark\""), text.npos);
    std::set<std::string> layers;
    for (const SvgPath& path : read_svg_paths(text)) layers.insert(path.layer);
    EXPECT_GE(layers.size(), 2u);
    for (const std::string& layer : layers)
        EXPECT_TRUE(layer.starts_with("entity-") && layer.find('-', 7) != layer.npos) << layer;
}

TEST_F(SvgScene, StrokesThinOutTowardsTheirEnds) {
    if (!std::filesystem::exists(bunny)) GTEST_SKIP() << "glmark2-data is not installed";
    const auto draw = [&](const char* file, const std::string& taper) { // a scene whose lines have free ends
        return hachure_program(folder, {"render", bunny, "-o", file, "--style", "lines", "--size", "200x150", "--set",
                                        "abstracted_lines.method=strokes", "--set", "abstracted_lines.taper=" + taper});
    };
    ASSERT_TRUE(succeeded(draw("even.svg", "0")));
    ASSERT_TRUE(succeeded(draw("strokes.svg", "6")));
    const auto ink = [&](const char* file) {
        double sum = 0.0;
        for (const double value : rasterise(read_svg_paths(text_of(folder / file)), 200, 150)) sum += value;
        return sum;
    };
    EXPECT_LT(ink("strokes.svg"), 0.95 * ink("even.svg"));
    EXPECT_GT(ink("strokes.svg"), 0.3 * ink("even.svg"));
}

TEST_F(SvgScene, SequencesAreNumberedGoOnAndDoNotDependOnThreads) {
    ASSERT_TRUE(succeeded(render({"-o", "f.##.svg", "--frames", "0..2", "--threads", "1"})));
    const std::string first = text_of(folder / "f.01.svg");
    std::ofstream(folder / "f.01.svg") << first.substr(0, first.size() / 2);
    std::ofstream(folder / "f.02.svg") << "<svg/>\n";
    ASSERT_TRUE(succeeded(render({"-o", "f.##.svg", "--frames", "0..2", "--threads", "4", "--resume"})));
    EXPECT_EQ(text_of(folder / "f.01.svg"), first);
    EXPECT_EQ(text_of(folder / "f.02.svg"), first) << "nothing moves";
    const ProcessResult again = render({"-o", "f.##.svg", "--frames", "0..2", "--resume"});
    EXPECT_NE(again.out.find("nothing to do"), again.out.npos);
}

TEST_F(SvgScene, WithoutAbstractedLinesThereIsNoFile) {
    EXPECT_TRUE(failed(hachure_program(folder, {"render", "two.scene.json", "-o", "none.svg", "--style", "gooch"}), 1,
                       "none.svg: nothing to draw has abstracted_lines"));
    EXPECT_FALSE(std::filesystem::exists(folder / "none.svg"));
    EXPECT_TRUE(failed(render({"-o", "f.svg", "--frames", "0..2"}), 2, "f.####.svg"));
}

/// A browser paints the file as the painter of these tests does.
TEST_F(SvgScene, OpensInABrowser) {
    std::string chromium = run_process({"/bin/sh", "-c", "command -v chromium"}).out;
    if (chromium.empty()) GTEST_SKIP() << "chromium is not installed: NO BROWSER HAS OPENED THE SVG FILE";
    chromium.pop_back();
    ASSERT_TRUE(succeeded(render({"-o", "two.svg", "--set", "abstracted_lines.color=0,0,0", "--set",
                                  "abstracted_lines.highlight=false", "--set", "abstracted_lines.specular=false"})));
    const std::filesystem::path shot = folder / "shot.png";
    const ProcessResult result = run_process(
        {chromium, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
         "--hide-scrollbars", "--user-data-dir=" + (folder / "profile").string(), "--window-size=200,150",
         "--screenshot=" + shot.string(), "file://" + (folder / "two.svg").string()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const assets::Image image = assets::read_image(shot);
    ASSERT_EQ(image.width, 200);
    ASSERT_EQ(image.height, 150);
    const std::vector<double> expected = rasterise(read_svg_paths(text_of(folder / "two.svg")), 200, 150);
    double sum = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const double painted = 1.0 - image.u8()[i * static_cast<std::size_t>(image.channels)] / 255.0;
        sum += expected[i];
        difference += std::abs(painted - expected[i]);
    }
    ASSERT_GT(sum, 50.0);
    EXPECT_LE(difference, 0.05 * sum);
}

} // namespace
} // namespace hachure::test
