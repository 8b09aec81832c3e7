#include <hachure/systems/picture/tone.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hachure {
namespace {

using assets::Image;
using assets::PixelType;

Image bytes(int channels, const std::vector<std::uint8_t>& values) {
    Image image = assets::make_image(static_cast<int>(values.size()) / channels, 1, channels, PixelType::u8);
    std::copy(values.begin(), values.end(), image.u8());
    return image;
}

Image floats(int channels, const std::vector<float>& values) {
    Image image = assets::make_image(static_cast<int>(values.size()) / channels, 1, channels, PixelType::f32);
    std::copy(values.begin(), values.end(), image.f32());
    return image;
}

TEST(PictureTone, OfGreyBytesIsTheirValue) {
    std::vector<std::uint8_t> grey, rgb;
    for (int v = 0; v < 256; ++v) {
        grey.push_back(static_cast<std::uint8_t>(v));
        rgb.insert(rgb.end(), 3, static_cast<std::uint8_t>(v));
    }
    for (const Image& image : {bytes(1, grey), bytes(3, rgb)}) {
        const std::vector<float> tones = picture_tones(image);
        ASSERT_EQ(tones.size(), 256u);
        for (int v = 0; v < 256; ++v) EXPECT_EQ(tones[static_cast<std::size_t>(v)], float(v) / 255.0f) << v;
    }
}

/// Rec. 709's luminance through sRGB's curve, from tables of colours: 255, 0, 0 is .2126, whose code is .49844.
TEST(PictureTone, OfColoursIsThatOfTheirLuminance) {
    const std::vector<float> tones = picture_tones(bytes(3, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0}));
    EXPECT_NEAR(tones[0], 0.498440, 2e-6);
    EXPECT_NEAR(tones[1], 0.862481, 2e-6);
    EXPECT_NEAR(tones[2], 0.297893, 2e-6);
    EXPECT_NEAR(tones[3], 0.967567, 2e-6);
}

TEST(PictureTone, OfFloatsIsThatOfLinearLightCutToTheScale) {
    const std::vector<float> tones = picture_tones(floats(1, {0.0f, 0.001f, 0.21404114f, 1.0f, 20.0f, -3.0f}));
    EXPECT_EQ(tones[0], 0.0f);
    EXPECT_NEAR(tones[1], 0.01292, 1e-7);
    EXPECT_NEAR(tones[2], 0.5, 1e-7);
    EXPECT_EQ(tones[3], 1.0f);
    EXPECT_EQ(tones[4], 1.0f);
    EXPECT_EQ(tones[5], 0.0f);
    EXPECT_NEAR(picture_tones(floats(3, {1, 0, 0}))[0], 0.498440, 2e-6);
}

TEST(PictureTone, WhatIsTransparentLiesOnWhite) {
    const std::vector<float> tones = picture_tones(bytes(4, {0, 0, 0, 0, 0, 0, 0, 255, 9, 9, 9, 0, 0, 0, 0, 51}));
    EXPECT_EQ(tones[0], 1.0f);
    EXPECT_EQ(tones[1], 0.0f);
    EXPECT_EQ(tones[2], 1.0f);
    EXPECT_NEAR(tones[3], 1.055 * std::pow(0.8, 1 / 2.4) - 0.055, 1e-6);
    EXPECT_NEAR(picture_tones(bytes(2, {0, 51}))[0], tones[3], 1e-6);
    EXPECT_NEAR(picture_tones(floats(4, {0.1f, 0.1f, 0.1f, 0.2f}))[0], 1.055 * std::pow(0.9, 1 / 2.4) - 0.055, 1e-6)
        << "colours of float images are multiplied by alpha";
}

TEST(PictureColors, AreLinearAndPremultiplied) {
    const std::vector<float> some = premultiplied_colors(bytes(4, {255, 188, 0, 51}));
    EXPECT_NEAR(some[0], 0.2, 1e-6);
    EXPECT_NEAR(some[1], 0.2 * std::pow((188 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_EQ(some[2], 0.0f);
    EXPECT_NEAR(some[3], 0.2, 1e-6);
    const std::vector<float> bright = premultiplied_colors(floats(3, {1e9f, -1e9f, 3.0f}));
    EXPECT_EQ(bright, (std::vector<float>{65504.0f, -65504.0f, 3.0f, 1.0f})) << "half floats have no more";
}

} // namespace
} // namespace hachure
