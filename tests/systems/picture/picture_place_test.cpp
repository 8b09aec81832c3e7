#include <hachure/systems/picture/picture_place.h>

#include <gtest/gtest.h>

namespace hachure {
namespace {

using gpu::Rect;

TEST(PicturePlace, APictureOfTheViewsSizeLiesPixelForPixelOnIt) {
    for (const PictureFit fit : {PictureFit::stretch, PictureFit::contain, PictureFit::cover})
        EXPECT_EQ(picture_place(fit, 63, 48, 63, 48), (Rect{0, 0, 63, 48}));
}

TEST(PicturePlace, ContainShowsAllOfThePicture) {
    EXPECT_EQ(picture_place(PictureFit::contain, 200, 100, 100, 100), (Rect{0, 25, 100, 50}));
    EXPECT_EQ(picture_place(PictureFit::contain, 10, 20, 90, 40), (Rect{35, 0, 20, 40}));
    EXPECT_EQ(picture_place(PictureFit::contain, 100, 41, 100, 44), (Rect{0, 1, 100, 41})) << "at its own size";
}

TEST(PicturePlace, CoverFillsTheView) {
    EXPECT_EQ(picture_place(PictureFit::cover, 200, 100, 100, 100), (Rect{-50, 0, 200, 100}));
    EXPECT_EQ(picture_place(PictureFit::cover, 10, 20, 90, 40), (Rect{0, -70, 90, 180}));
    EXPECT_EQ(picture_place(PictureFit::cover, 45, 40, 40, 40), (Rect{-3, 0, 45, 40})) << "at its own size";
}

TEST(PicturePlace, StretchForgetsProportions) {
    EXPECT_EQ(picture_place(PictureFit::stretch, 10, 20, 90, 40), (Rect{0, 0, 90, 40}));
}

TEST(PicturePlace, AThinPictureIsNotLost) {
    EXPECT_EQ(picture_place(PictureFit::contain, 10000, 1, 100, 100), (Rect{0, 49, 100, 1}));
}

TEST(PicturePlace, IsCutToTheView) {
    EXPECT_EQ(cut_to_view({-50, 10, 200, 100}, 100, 80), (Rect{0, 10, 100, 70}));
    EXPECT_EQ(cut_to_view({5, 6, 7, 8}, 100, 80), (Rect{5, 6, 7, 8}));
    EXPECT_EQ(cut_to_view({100, 0, 10, 10}, 100, 80), Rect{});
}

} // namespace
} // namespace hachure
