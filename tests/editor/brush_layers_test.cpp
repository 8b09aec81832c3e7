// Another renderer's EXR in style `brush`, on the command line: how it says that a pixel is no number.
// (tests/runtime/assets/layered_image_test.cpp has every layer and place, tests/systems/implicit_brush what such pixels
// do to features when a texture has them all the same.)

#include <hachure/tests/editor/program.h>
#include <hachure/tests/systems/picture/layered_picture.h>

#include <cmath>
#include <limits>

namespace hachure::test {
namespace {

/// A ball in front of nothing, with one pixel changed.
void write_ball(const TempFolder& folder, const std::function<void(LayeredPixel&)>& change) {
    write_layers(folder / "ball.exr", 48, 32, [&](int x, int y) {
        const float u = (float(x) - 23.5f) / 12.0f, v = (15.5f - float(y)) / 12.0f, square = u * u + v * v;
        LayeredPixel pixel;
        if (square < 1.0f) {
            const float w = std::sqrt(1.0f - square);
            pixel = {.color = {w, w, w}, .normal = {u, v, w}, .depth = 5.0f - w};
        }
        if (x == 20 && y == 9) change(pixel);
        return pixel;
    });
}

TEST(BrushLayers, APixelThatIsNoNumberIsToldOfInOneLine) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const TempFolder folder;
    const std::vector<std::string> command{"render",  "ball.exr", "-o",    "out.png",
                                           "--style", "brush",    "--set", "implicit_brush.feature=valleys"};
    write_ball(folder, [](LayeredPixel&) {});
    EXPECT_TRUE(succeeded(hachure_program(folder, command)));
    ASSERT_TRUE(std::filesystem::remove(folder / "out.png"));
    const auto expect_refused = [&](const std::string& where, const std::function<void(LayeredPixel&)>& change) {
        write_ball(folder, change);
        EXPECT_TRUE(failed(hachure_program(folder, command), 1,
                           "ball.exr: has values that are not finite (" + where + ", column 20, row 9)"));
        EXPECT_FALSE(std::filesystem::exists(folder / "out.png"));
    };
    expect_refused("normal, channel N.Y", [](LayeredPixel& pixel) { pixel.normal[1] = nan; });
    expect_refused("depth, channel Z", [](LayeredPixel& pixel) { pixel.depth = nan; });
    expect_refused("color, channel B", [](LayeredPixel& pixel) { pixel.color[2] = nan; });
}

} // namespace
} // namespace hachure::test
