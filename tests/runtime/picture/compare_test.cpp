#include <hachure/runtime/picture/line_distance.h>
#include <hachure/tests/runtime/picture/drawing.h>
#include <hachure/tests/support/picture_compare.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace hachure::test {
namespace {

TEST(PictureCompare, APictureIsLikeItself) {
    const assets::Image image = drawing(0, true);
    const PictureDifference d = compare_pictures(image, image);
    EXPECT_EQ(d.max_difference, 0.0);
    EXPECT_EQ(d.flip_max, 0.0);
    EXPECT_EQ(d.line_distance, 0.0);
    EXPECT_TRUE(same_driver_gate(image, image));
}

TEST(PictureCompare, CatchesALostLine) {
    const assets::Image whole = drawing(0, true), lost = drawing(0, false);
    EXPECT_FALSE(same_driver_gate(whole, lost));
    EXPECT_GT(picture::line_distance(whole, lost), 20.0);
    EXPECT_EQ(picture::line_distance(whole, lost), picture::line_distance(lost, whole));
    EXPECT_GT(compare_pictures(whole, lost).flip_max, 0.5);
}

TEST(PictureCompare, CatchesAShiftOfThreePixelsByDistance) {
    const double distance = picture::line_distance(drawing(0, true), drawing(3, true));
    EXPECT_GT(distance, 2.0);
    EXPECT_LE(distance, 3.0);
    EXPECT_FALSE(same_driver_gate(drawing(0, true), drawing(3, true)));
}

TEST(PictureCompare, CatchesTwoTurnedPixelsInAThousand) {
    const assets::Image image = drawing(0, true);
    assets::Image turned = image;
    for (int i = 0; i < width * height; i += 500) turned.u8()[3 * i] ^= 0x20;
    EXPECT_FALSE(same_driver_gate(image, turned));
}

TEST(PictureCompare, LetsNoiseOfOneStepPass) {
    const assets::Image image = drawing(0, true);
    assets::Image noisy = image;
    std::mt19937 random(7);
    for (int i = 0; i < width * height * 3; ++i) {
        const int value = noisy.u8()[i] + static_cast<int>(random() % 3) - 1;
        noisy.u8()[i] = static_cast<std::uint8_t>(std::clamp(value, 0, 255));
    }
    EXPECT_GT(compare_pictures(image, noisy).max_difference, 0.0);
    EXPECT_TRUE(same_driver_gate(image, noisy));
}

TEST(PictureCompare, CatchesNaNAndOtherSizes) {
    assets::Image a = assets::make_image(8, 8, 3, assets::PixelType::f32);
    assets::Image b = a;
    EXPECT_TRUE(same_driver_gate(a, b));
    b.f32()[40] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(same_driver_gate(a, b));
    EXPECT_FALSE(same_driver_gate(b, b));
    EXPECT_FALSE(same_driver_gate(a, assets::make_image(8, 9, 3, assets::PixelType::f32)));
}

TEST(PictureCompare, AWhollyLostDrawingIsInfinitelyFar) {
    EXPECT_TRUE(std::isinf(picture::line_distance(drawing(0, true), filled({255, 255, 255}))));
    EXPECT_EQ(picture::line_distance(filled({255, 255, 255}), filled({200, 255, 255})), 0.0);
}

} // namespace
} // namespace hachure::test
