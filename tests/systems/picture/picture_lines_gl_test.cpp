// Abstracted lines of pictures: found in their tones, whatever stands before them.

#include <hachure/components/abstracted_lines.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "picture_scene.h"

namespace hachure::test {
namespace {

constexpr Canvas line_canvas{96, 64};

/// Dark discs and a bar on light grey, moved by whole pixels.
assets::Image drawing(int width, int height, int right, int down) {
    assets::Image image = assets::make_image(width, height, 1, assets::PixelType::u8);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double u = x - right - 40, v = y - down - 30;
            const double ring = std::abs(std::hypot(u, v) - 14.0), bar = std::abs(0.6 * u + 0.8 * v - 3.0);
            const double ink = std::max(1.0 - ring / 3.0, std::abs(0.8 * u - 0.6 * v) < 20.0 ? 1.0 - bar / 3.0 : 0.0);
            image.u8()[y * width + x] = static_cast<std::uint8_t>(210.0 - 180.0 * std::clamp(ink, 0.0, 1.0));
        }
    return image;
}

class PictureLinesTest : public GlTest {
protected:
    /// The opacity of dark lines.
    std::vector<float> dark_lines(const assets::Image& image, const std::function<void(PictureScene&, Entity)>& more) {
        assets::write_png(folder_ / "i.png", image);
        PictureScene scene(context(), line_canvas);
        const Entity picture = scene.show({.file = (folder_ / "i.png").string()});
        more(scene, picture);
        scene.renderer().request_aov("line_opacity");
        scene.renderer().render_frame();
        const assets::Image drawn = scene.renderer().read_aov("line_opacity");
        std::vector<float> result;
        for (int i = 0; i < line_canvas.width * line_canvas.height; ++i) result.push_back(drawn.f32()[2 * i]);
        return result;
    }

    static void add_lines(PictureScene& scene, Entity picture) { scene.world().add(picture, AbstractedLines{}); }

    static float at(const std::vector<float>& values, int x, int y) {
        return values[static_cast<std::size_t>(y * line_canvas.width + x)];
    }

    TempFolder folder_;
};

TEST_P(PictureLinesTest, LieAlongThinDarkTones) {
    const std::vector<float> lines = dark_lines(drawing(line_canvas.width, line_canvas.height, 0, 0), add_lines);
    for (int i = 0; i < 24; ++i) {
        const double angle = 0.2618 * i;
        const auto around = [&](double radius) {
            return at(lines, static_cast<int>(std::floor(40.5 + radius * std::cos(angle))),
                      static_cast<int>(std::floor(30.5 + radius * std::sin(angle))));
        };
        const double from_bar = 0.6 * 14.0 * std::cos(angle) + 0.8 * 14.0 * std::sin(angle) - 3.0;
        if (std::abs(from_bar) > 7.0) {
            EXPECT_GT(around(14.0), 0.5f) << i;
        }
        EXPECT_LT(around(22.0), 0.05f) << i;
    }
    EXPECT_TRUE(std::ranges::all_of(lines, [](float value) { return value >= 0.0f && value <= 1.0f; }));
}

TEST_P(PictureLinesTest, MoveWithThePicture) {
    const std::vector<float> here = dark_lines(drawing(line_canvas.width, line_canvas.height, 0, 0), add_lines);
    const std::vector<float> there = dark_lines(drawing(line_canvas.width, line_canvas.height, 9, 4), add_lines);
    int lit = 0;
    for (int y = 10; y < 50; ++y)
        for (int x = 10; x < 76; ++x) {
            ASSERT_NEAR(at(here, x, y), at(there, x + 9, y + 4), 1e-4) << x << " " << y;
            lit += at(here, x, y) > 0.5f;
        }
    EXPECT_GT(lit, 200);
}

TEST_P(PictureLinesTest, AreDrawnWhereThePictureIsSeenAlone) {
    const assets::Image image = drawing(line_canvas.width, line_canvas.height, 0, 0);
    const std::vector<float> none = dark_lines(image, [](PictureScene&, Entity) {});
    EXPECT_TRUE(std::ranges::all_of(none, [](float value) { return value == 0.0f; })) << "no component, no line";
    const std::vector<float> whole = dark_lines(image, add_lines);
    const std::vector<float> covered = dark_lines(image, [](PictureScene& scene, Entity picture) {
        add_lines(scene, picture);
        scene.add(surface_mesh(geometry::cube(1.0)), {.translation = {0.6f, 0.0f, -4.0f}}); // without lines
    });
    EXPECT_EQ(at(covered, 63, 32), 0.0f) << "the cube";
    double left = 0.0, right = 0.0;
    for (int y = 0; y < line_canvas.height; ++y)
        for (int x = 0; x < 40; ++x) {
            left += double(at(whole, x, y));
            right += double(std::abs(at(whole, x, y) - at(covered, x, y)));
        }
    EXPECT_GT(left, 50.0);
    EXPECT_LT(right, 0.1 * left) << "beside the cube they stay";
}

TEST_P(PictureLinesTest, VaryingWidthsOfSurfacesLeaveThemAlone) {
    const assets::Image image = drawing(line_canvas.width, line_canvas.height, 0, 0);
    const std::vector<float> alone = dark_lines(image, add_lines);
    const std::vector<float> beside = dark_lines(image, [](PictureScene& scene, Entity picture) {
        scene.world().add(picture, AbstractedLines{.width_by = LineAbstraction::depth});
        const Entity cube = scene.add(surface_mesh(geometry::cube(0.4)), {.translation = {1.8f, 1.1f, -4.0f}});
        scene.world().add(cube, AbstractedLines{.width_by = LineAbstraction::depth, .min_width = 2.0f});
    });
    double apart = 0.0, all = 0.0;
    for (int y = 0; y < line_canvas.height; ++y)
        for (int x = 0; x < 60; ++x) {
            apart += double(std::abs(at(alone, x, y) - at(beside, x, y)));
            all += double(at(alone, x, y));
        }
    EXPECT_LT(apart, 0.1 * all);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(PictureLinesTest);

} // namespace
} // namespace hachure::test
