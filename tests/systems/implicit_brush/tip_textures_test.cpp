#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/implicit_brush/tip_textures.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/temp_folder.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace hachure {
namespace {

std::string message_of(const auto& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(TipTextures, DarknessIsOpacityWhereThereIsNoAlpha) {
    assets::Image image = assets::make_image(2, 1, 3, assets::PixelType::u8);
    for (int c = 0; c < 3; ++c) image.u8()[3 + c] = 255;
    const TipImage tip = tip_of(image, "tip.png");
    EXPECT_FLOAT_EQ(tip.pixels[3], 1.0f);
    EXPECT_FLOAT_EQ(tip.pixels[7], 0.0f);
    EXPECT_FALSE(tip.colored);
    EXPECT_FLOAT_EQ(tip.mean(), 0.5f);
}

TEST(TipTextures, ColorsCountWhereAlphaSaysWhereThereIsInk) {
    assets::Image image = assets::make_image(2, 1, 4, assets::PixelType::f32);
    image.f32()[0] = 0.8f;
    image.f32()[3] = 0.5f;
    TipImage tip = tip_of(image, "tip.exr");
    EXPECT_TRUE(tip.colored);
    EXPECT_FLOAT_EQ(tip.pixels[0], 0.4f); // premultiplied
    EXPECT_FLOAT_EQ(tip.pixels[3], 0.5f);
    image.f32()[1] = image.f32()[2] = 0.8f;
    EXPECT_FALSE(tip_of(image, "tip.exr").colored) << "grey has no colour of its own";
}

TEST(TipTextures, WhatIsNoTipIsSaidWithItsFile) {
    assets::Image image = assets::make_image(1, 1, 4, assets::PixelType::f32);
    EXPECT_THAT(message_of([&] { (void)tip_of(image, "clear.exr"); }),
                testing::AllOf(testing::HasSubstr("clear.exr"), testing::HasSubstr("clear all over")));
    image.f32()[3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(message_of([&] { (void)tip_of(image, "nan.exr"); }),
                testing::AllOf(testing::HasSubstr("nan.exr"), testing::HasSubstr("not finite")));
}

using TipTexturesGlTest = test::GlTest;

TEST_P(TipTexturesGlTest, AFileIsReadOnceAndItsFaultsAreNamed) {
    const test::TempFolder folder;
    assets::Image image = assets::make_image(8, 4, 1, assets::PixelType::u8);
    assets::write_png(folder / "tip.png", image);
    assets::write_png(folder / "large.png", assets::make_image(max_tip_size + 1, 1, 1, assets::PixelType::u8));
    TipTextures textures;
    const TipBitmap& tip = textures.get((folder / "tip.png").string());
    EXPECT_FLOAT_EQ(tip.mean, 1.0f);
    EXPECT_EQ(&tip, &textures.get((folder / "tip.png").string()));
    EXPECT_THAT(message_of([&] { (void)textures.get((folder / "large.png").string()); }),
                testing::AllOf(testing::HasSubstr("large.png"), testing::HasSubstr("too large")));
    EXPECT_THAT(message_of([&] { (void)textures.get((folder / "none.png").string()); }),
                testing::HasSubstr("none.png"));
    EXPECT_THAT(message_of([&] { (void)textures.get(""); }), testing::HasSubstr("tip_file"));
}

HACHURE_INSTANTIATE_GL_TESTS(TipTexturesGlTest);

} // namespace
} // namespace hachure
