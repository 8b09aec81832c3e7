#include <hachure/runtime/picture/difference_picture.h>
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

/// All of a picture may be rounded the other way; twice as much is a change.
TEST(PictureCompare, RoundingIsNoDifferenceToFlip) {
    const assets::Image image = drawing(0, true);
    const auto darker_by = [&](int step) {
        assets::Image result = image;
        std::transform(image.u8(), image.u8() + 3 * std::size_t(image.width) * std::size_t(image.height), result.u8(),
                       [=](std::uint8_t value) { return static_cast<std::uint8_t>(value >= step ? value - step : 0); });
        return result;
    };
    const PictureDifference rounded = compare_pictures(image, darker_by(1)),
                            changed = compare_pictures(image, darker_by(2));
    EXPECT_EQ(rounded.flip_max, 0.0);
    EXPECT_NEAR(rounded.max_difference, 1.0, 1e-6);
    EXPECT_GT(changed.flip_p99, 0.0);
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

TEST(PictureCompare, AMaskHidesWhatItIsBlackOn) {
    const assets::Image whole = drawing(0, true), lost = drawing(0, false);
    assets::Image mask = filled({255, 255, 255});
    for (int y = 0; y < height; ++y)
        for (int x = 100; x < width; ++x) set(mask, x, y, 0);
    const PictureDifference hidden = compare_pictures(whole, lost, {.mask = &mask});
    EXPECT_EQ(hidden.max_difference, 0.0);
    EXPECT_EQ(hidden.flip_max, 0.0);
    EXPECT_EQ(hidden.line_distance, 0.0);
    for (int i = 0; i < width * height * 3; ++i) mask.u8()[i] ^= 0xff;
    const PictureDifference seen = compare_pictures(whole, lost, {.mask = &mask});
    EXPECT_GT(seen.line_distance, 20.0);
    EXPECT_GT(seen.differing_fraction, 2.0 * compare_pictures(whole, lost).differing_fraction)
        << "a share of the pixels that are seen";
}

TEST(PictureCompare, AWhollyBlackMaskHidesAll) {
    const assets::Image mask = filled({});
    const PictureDifference d = compare_pictures(drawing(0, true), filled({1, 2, 3}), {.mask = &mask});
    EXPECT_EQ(d.max_difference + d.differing_fraction + d.flip_p99 + d.line_distance, 0.0);
}

TEST(PictureCompare, GatesSayWhichOfThemFailed) {
    const PictureDifference d = compare_pictures(drawing(0, true), drawing(1, true));
    EXPECT_EQ(picture::exceeded_gates(d, {.share = 1.0, .flip_p99 = 1.0, .lines = 2.0}), "");
    const std::string reason = picture::exceeded_gates(d, {.share = 1.0, .flip_p99 = 1.0, .lines = 0.5});
    EXPECT_NE(reason.find("lines are 1 px apart, allowed are 0.5"), std::string::npos) << reason;
    EXPECT_NE(picture::exceeded_gates({.finite = false}, {}), "");
}

TEST(BufferCompare, IsInTheBuffersOwnUnit) {
    assets::Image a = assets::make_image(10, 10, 1, assets::PixelType::f32), b = a;
    b.f32()[3] = 0.25f;
    const picture::BufferDifference d = picture::compare_buffers(a, b, {.step = 0.2});
    EXPECT_EQ(d.max_difference, 0.25);
    EXPECT_EQ(d.differing_fraction, 0.01);
    EXPECT_EQ(picture::compare_buffers(a, b, {.step = 0.25}).differing_fraction, 0.0);
    b.f32()[4] = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(picture::compare_buffers(a, b, {.step = 0.2}).finite);
}

TEST(DifferencePicture, IsBrightWherePicturesDiffer) {
    const assets::Image a = drawing(0, true), b = drawing(0, false);
    const assets::Image d = picture::difference_picture(a, b);
    const auto at = [&](int x, int y) { return int(d.u8()[3 * (y * width + x)]); };
    EXPECT_EQ(at(110, 50), 255);
    EXPECT_LT(at(80, 100), 32) << "equal pixels are dim";
}

TEST(Shrunk, KeepsMeansAndProportions) {
    assets::Image image = filled({200, 100, 50});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width / 2; ++x) set(image, x, y, 0);
    const assets::Image small = picture::shrunk(image, 33);
    EXPECT_EQ(small.width, 33);
    EXPECT_EQ(small.height, 24);
    EXPECT_EQ(small.u8()[0], 0);
    EXPECT_EQ(small.u8()[3 * 32], 200);
    EXPECT_EQ(small.u8()[3 * 16], 100) << "the middle pixel covers both halves";
    EXPECT_EQ(picture::shrunk(image, 1000).width, width);
}

} // namespace
} // namespace hachure::test
