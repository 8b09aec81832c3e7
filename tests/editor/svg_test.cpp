#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/svg_raster.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
        off += distance > 0.5 + 0.01; // the file has two decimals
        most = std::max(most, distance);
    }
};

double distance_to_piece(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
    const glm::dvec2 step = b - a;
    const double t = std::clamp(glm::dot(p - a, step) / std::max(glm::dot(step, step), 1e-12), 0.0, 1.0);
    return glm::distance(p, a + t * step);
}

/// Straight pieces, by the pixels that they pass through or near to.
class Pieces {
public:
    static constexpr double far = 4.0; ///< pixels; what is farther away is as far

    Pieces(int width, int height) : width_(width), height_(height), cells_(std::size_t(width) * std::size_t(height)) {}

    void add(glm::dvec2 a, glm::dvec2 b) {
        const int parts = std::max(1, static_cast<int>(std::ceil(glm::distance(a, b))));
        for (int i = 0; i < parts; ++i) {
            const glm::dvec2 from = glm::mix(a, b, double(i) / parts), to = glm::mix(a, b, (i + 1.0) / parts);
            cell(glm::ivec2(glm::floor(0.5 * (from + to)))).push_back({from, to});
        }
    }
    [[nodiscard]] double distance(glm::dvec2 p) {
        double least = far;
        const glm::ivec2 at(glm::floor(p));
        for (int y = -5; y <= 5; ++y)
            for (int x = -5; x <= 5; ++x)
                for (const auto& [a, b] : cell(at + glm::ivec2(x, y)))
                    least = std::min(least, distance_to_piece(a, b, p));
        return least;
    }

private:
    std::vector<std::pair<glm::dvec2, glm::dvec2>>& cell(glm::ivec2 at) {
        at = glm::clamp(at, glm::ivec2(0), glm::ivec2(width_, height_) - 1);
        return cells_[std::size_t(at.y) * std::size_t(width_) + std::size_t(at.x)];
    }

    int width_, height_;
    std::vector<std::vector<std::pair<glm::dvec2, glm::dvec2>>> cells_;
};

/// The middles that pixels claim for lines of one sign, from the upper left corner, and how much they draw of them.
struct Claims {
    int width, height;
    std::vector<glm::dvec2> middles;
    std::vector<double> opacities;

    Claims(const assets::Image& points, double sign, double line_width) : width(points.width), height(points.height) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                // Curvature, opacity, right, up: files have channels by the alphabet.
                const float* found = points.f32() + 4 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
                middles.emplace_back(x + 0.5 + double(found[2]), y + 0.5 - double(found[3]));
                // As shaders/abstracted_lines/across.glsl with the default `fade` of a half.
                const double away = std::hypot(double(found[2]), double(found[3]));
                const double ramp = std::max(0.25 * line_width, 1.0);
                const double rim = 0.5 * line_width + 0.5 * std::max(1.0 - 0.25 * line_width, 0.0);
                const double across = std::clamp((rim - away) / ramp, 0.0, 1.0);
                opacities.push_back(double(found[0]) * sign > 0.0 ? double(found[1]) * across : 0.0);
            }
    }
    /// What pixels show of lines: their middles, and what lies between those of neighbours.
    [[nodiscard]] Pieces shown() const {
        Pieces pieces(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
                if (opacities[i] < 0.02) continue;
                pieces.add(middles[i], middles[i]);
                for (const glm::ivec2 step : {glm::ivec2(1, 0), {0, 1}, {1, 1}, {-1, 1}}) {
                    const glm::ivec2 to = glm::ivec2(x, y) + step;
                    if (to.x < 0 || to.x >= width || to.y >= height) continue;
                    const std::size_t j = std::size_t(to.y) * std::size_t(width) + std::size_t(to.x);
                    if (opacities[j] >= 0.02 && glm::distance(middles[i], middles[j]) <= 1.5)
                        pieces.add(middles[i], middles[j]);
                }
            }
        return pieces;
    }
};

/// Both ways between what pixels claim strongly and the lines of a layer of the drawing.
struct Agreement {
    Distances pixels, lines;

    void add(const Claims& claims, const std::vector<SvgPath>& paths, std::string_view layer) {
        Pieces drawn(claims.width, claims.height), shown = claims.shown();
        for (const SvgPath& path : paths) {
            if (!path.layer.ends_with(layer)) continue;
            std::vector<glm::dvec2> middle = path.middle();
            if (path.closed && !path.filled) middle.push_back(middle.front());
            for (std::size_t i = 0; i + 1 < middle.size(); ++i) {
                drawn.add(middle[i], middle[i + 1]);
                if (path.opacity < 0.085) continue; // the first step of opacity: hardly to be seen
                const int steps =
                    std::max(1, static_cast<int>(std::ceil(4.0 * glm::distance(middle[i], middle[i + 1]))));
                for (int k = 0; k <= steps; ++k)
                    lines.add(shown.distance(glm::mix(middle[i], middle[i + 1], double(k) / steps)));
            }
        }
        for (std::size_t i = 0; i < claims.middles.size(); ++i)
            if (claims.opacities[i] >= 0.5) pixels.add(drawn.distance(claims.middles[i]));
    }
};

/// A torus of 64 by 32 faces.
void write_torus(const std::filesystem::path& file) {
    std::ofstream out(file);
    constexpr int around = 64, across = 32;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double u = 6.283185307 * i / around, v = 6.283185307 * j / across, r = 1.0 + 0.45 * std::cos(v);
            out << "v " << r * std::cos(u) << ' ' << r * std::sin(u) << ' ' << 0.45 * std::sin(v) << '\n';
        }
    const auto at = [](int i, int j) { return (i % around) * across + j % across + 1; };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j)
            out << "f " << at(i, j) << ' ' << at(i + 1, j) << ' ' << at(i + 1, j + 1) << ' ' << at(i, j + 1) << '\n';
}

struct SeenFrom {
    const char *model, *rotation, *width;
};

class SvgOfPixels : public ::testing::TestWithParam<SeenFrom> {};

/// Symmetric Hausdorff distance between what pixels draw and the drawing, which is read by code that shares nothing
/// with what wrote it.
TEST_P(SvgOfPixels, ShowsTheLinesOfThePixelsWithinHalfAPixel) {
    const auto [model, rotation, width] = GetParam();
    const TempFolder folder;
    std::string file = model;
    if (file == "torus") write_torus(folder / (file = "torus.obj"));
    if (file == bunny && !std::filesystem::exists(bunny)) GTEST_SKIP() << "glmark2-data is not installed";
    std::ofstream(folder / "seen.scene.json") << R"({"hachure_scene": 1, "entities": [{"name": "it", "model": ")"
                                              << file << R"(", "transform": {"rotation": )" << rotation << "}}]}";
    ASSERT_TRUE(
        succeeded(hachure_program(folder, {"render", "seen.scene.json", "-o", "b.svg", "--style", "lines", "--set",
                                           "abstracted_lines.width=" + std::string(width), "--size", "640x480", "--aov",
                                           "ridge_points=d.exr", "--aov", "specular_ridge_points=s.exr"})));
    const std::vector<SvgPath> paths = read_svg_paths(text_of(folder / "b.svg"));
    const assets::Image diffuse = assets::read_image(folder / "d.exr"), specular = assets::read_image(folder / "s.exr");
    ASSERT_EQ(diffuse.channels, 4);
    Agreement all;
    all.add(Claims(diffuse, 1.0, std::stod(width)), paths, "-dark");
    all.add(Claims(diffuse, -1.0, std::stod(width)), paths, "-highlight");
    all.add(Claims(specular, -1.0, std::stod(width)), paths, "-specular");
    RecordProperty("pixels", std::to_string(all.pixels.off) + " of " + std::to_string(all.pixels.count) + ", most " +
                                 std::to_string(all.pixels.most));
    RecordProperty("lines", std::to_string(all.lines.off) + " of " + std::to_string(all.lines.count) + ", most " +
                                std::to_string(all.lines.most));
    EXPECT_GT(all.pixels.count, 1000);
    EXPECT_GT(all.lines.count, 1000);
    EXPECT_EQ(all.pixels.off, 0) << "most " << all.pixels.most;
    EXPECT_EQ(all.lines.off, 0) << "most " << all.lines.most;
}

/// Of lines whose rims are as sharp as pixels allow, which paths' are: their ink is where the drawing's is.
TEST(Svg, InkIsWhereThatOfThePixelsIs) {
    const TempFolder folder;
    write_torus(folder / "torus.obj");
    ASSERT_TRUE(succeeded(hachure_program(folder, {"render", "torus.obj", "-o", "b.svg", "--style", "lines", "--set",
                                                   "abstracted_lines.width=4", "--set", "abstracted_lines.fade=0",
                                                   "--size", "320x240", "--aov", "line_opacity=o.exr"})));
    const std::vector<double> ink = rasterise(read_svg_paths(text_of(folder / "b.svg")), 320, 240, "-dark");
    const assets::Image opacity = assets::read_image(folder / "o.exr");
    double sum = 0.0, difference = 0.0, more = 0.0;
    for (std::size_t i = 0; i < ink.size(); ++i) {
        const double shown = double(opacity.f32()[2 * i]);
        sum += shown;
        more += ink[i] - shown;
        difference += std::abs(ink[i] - shown);
    }
    RecordProperty("difference", std::to_string(difference / sum));
    RecordProperty("more", std::to_string(more / sum));
    ASSERT_GT(sum, 500.0);
    EXPECT_LE(difference, 0.25 * sum);
    EXPECT_LE(std::abs(more), 0.15 * sum);
}

INSTANTIATE_TEST_SUITE_P(Views, SvgOfPixels,
                         ::testing::Values(SeenFrom{bunny, "[0, 0, 0, 1]", "4"},
                                           SeenFrom{bunny, "[0, 0.574, 0, 0.819]", "3"},
                                           SeenFrom{bunny, "[-0.129, 0.976, 0, -0.172]", "6"},
                                           SeenFrom{"torus", "[0.4, 0.2, 0, 0.894]", "4"}));

TEST(Svg, LinesHaveTheWidthOfTheComponent) {
    if (!std::filesystem::exists(bunny)) GTEST_SKIP() << "glmark2-data is not installed";
    const TempFolder folder;
    ASSERT_TRUE(succeeded(hachure_program(folder, {"render", bunny, "-o", "b.svg", "--style", "lines", "--set",
                                                   "abstracted_lines.width=4", "--size", "640x480"})));
    int of_one_width = 0;
    for (const SvgPath& path : read_svg_paths(text_of(folder / "b.svg"))) {
        if (path.filled) continue;
        of_one_width += path.width == 4.0;
        EXPECT_LE(path.width, 4.0);
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
