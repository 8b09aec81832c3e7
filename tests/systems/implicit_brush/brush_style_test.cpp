// What the shaders know of a brush, and how far it reaches.

#include <hachure/systems/implicit_brush/brush_style.h>

#include <gtest/gtest.h>

#include <cmath>

namespace hachure {
namespace {

View view_of(int height) {
    View view;
    view.width = view.height = height;
    return view;
}

TEST(BrushStyleTest, LengthsAreInPixelsInThousandthsOfThePictureOrInMetres) {
    const View view = view_of(500);
    ImplicitBrush brush{.window = 6.0f, .spread = 1.0f, .size = 4.0f};
    EXPECT_FLOAT_EQ(brush_style(brush, view).size.y, 4.0f);
    EXPECT_FLOAT_EQ(largest_radius(brush, view, 100.0f), 4.0f);
    brush.unit = BrushUnit::picture;
    EXPECT_FLOAT_EQ(brush_style(brush, view).size.y, 2.0f);
    EXPECT_FLOAT_EQ(brush_style(brush, view).spread.y, 0.5f);
    EXPECT_FLOAT_EQ(feature_key(brush, view).window, 3.0f);
    brush.unit = BrushUnit::world;
    brush.size = 0.05f;
    EXPECT_FLOAT_EQ(brush_style(brush, view).size.y, 0.05f);
    EXPECT_FLOAT_EQ(largest_radius(brush, view, 100.0f), 5.0f);
    EXPECT_FLOAT_EQ(largest_radius(brush, view, 1e6f), largest_stamp);
    EXPECT_TRUE(feature_key(brush, view).world_window);
}

TEST(BrushStyleTest, PixelsCountUntilTheirWeightFallsToTheCutoff) {
    const View view = view_of(500);
    const ImplicitBrush brush{.window = 50.0f, .spread = 3.0f, .cutoff = 0.01f};
    const double reach = double(weight_reach(brush, view, 1.0f));
    EXPECT_NEAR(std::exp(-0.5 * reach * reach / 9.0), 0.01, 1e-5);
    EXPECT_FLOAT_EQ(weight_reach({.window = 2.0f, .spread = 30.0f}, view, 1.0f), 2.0f) << "never beyond the window";
    EXPECT_FLOAT_EQ(ink_reach(brush, view, 1.0f), weight_reach(brush, view, 1.0f) + std::sqrt(2.0f) * brush.size)
        << "and beyond that the corner of a square stamp";
}

TEST(BrushStyleTest, AFeatureIsSharedWithWhatLooksForTheSame) {
    const View view = view_of(500);
    ImplicitBrush brush{.feature = BrushFeature::contours, .source = BrushSource::luminance};
    EXPECT_EQ(feature_key(brush, view), feature_key({.feature = BrushFeature::contours, .size = 9.0f}, view))
        << "contours are those of depth whatever the source";
    brush.feature = BrushFeature::ridges;
    EXPECT_EQ(feature_key(brush, view).source, BrushSource::luminance);
    brush.feature = BrushFeature::luminance_edges, brush.source = BrushSource::surface;
    EXPECT_EQ(feature_key(brush, view).source, BrushSource::luminance);
}

TEST(BrushStyleTest, NoiseIsMadeOnlyForWhatIsNoisy) {
    const View view = view_of(500);
    EXPECT_FALSE(noise_key({}, view));
    for (const ImplicitBrush& noisy :
         {ImplicitBrush{.canvas = 0.1f}, ImplicitBrush{.interruption = 0.1f}, ImplicitBrush{.wobble = 0.1f},
          ImplicitBrush{.turn_noise = 0.1f}, ImplicitBrush{.size_noise = 0.1f}, ImplicitBrush{.color_noise = 0.1f}})
        EXPECT_TRUE(noise_key(noisy, view));
    EXPECT_EQ(noise_key({.unit = BrushUnit::picture, .canvas = 0.1f}, view)->size, 6.0f);
}

TEST(BrushStyleTest, LimitsThatAreTheWrongWayRoundAreASharpStep) {
    const BrushStyle style = brush_style({.peak_low = 0.5f, .peak_high = 0.2f}, view_of(100));
    EXPECT_GT(style.peak.w, style.peak.z);
    EXPECT_FLOAT_EQ(style.peak.z, 0.5f);
}

} // namespace
} // namespace hachure
