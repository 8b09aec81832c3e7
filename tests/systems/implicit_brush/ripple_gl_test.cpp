// The ripple of figure 2 as an image, as a height field and as a mesh: lines, heights and curvatures against what
// double precision says of them.

#include <hachure/tests/support/brush_reference.h>
#include <hachure/tests/support/feature_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/ripple_mesh.h>
#include <hachure/tests/support/ripple_relief.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace hachure {
namespace {

using test::RippleScore;
using test::SlopeImage;
using test::TrueCircle;
namespace ripple = test::ripple;

void expect_accurate(const RippleScore& found, const char* what) {
    EXPECT_LE(found.rms(), 0.05) << what;
    EXPECT_LE(found.largest(), 0.25) << what;
    EXPECT_GE(found.recall(), 0.99) << what;
    EXPECT_GE(found.precision(), 0.99) << what;
    EXPECT_LE(found.height_error(), 0.02) << what;
    EXPECT_LE(found.height_spread(), 0.05) << what;
    EXPECT_LE(found.curvature_spread(), 0.05) << what;
}

const auto ripple_height = [](double r) { return ripple::h(r); };
const auto ripple_depth = [](double r) { return -ripple::h(r); };
const auto ripple_steepness = [](double r) { return std::abs(ripple::h(r)); };

using RippleTest = test::GlTest;

/// The radii that the readings give for the ripple's own height are those that the reference finds.
TEST(RippleReference, FindsTheKnownRadii) {
    const std::vector<double> high = test::maxima(ripple_height, 1.0, 26.0),
                              low = test::maxima(ripple_depth, 1.0, 17.0);
    const std::vector<double> known_high{6.194089, 12.509320, 18.807577, 25.099530};
    const std::vector<double> known_low{3.017506, 9.355229, 15.659597};
    ASSERT_EQ(high.size(), known_high.size());
    ASSERT_EQ(low.size(), known_low.size());
    for (std::size_t i = 0; i < high.size(); ++i) EXPECT_NEAR(high[i], known_high[i], 2e-6);
    for (std::size_t i = 0; i < low.size(); ++i) EXPECT_NEAR(low[i], known_low[i], 2e-6);
    for (const double r : high) EXPECT_NEAR(ripple::derivative(2, r), -ripple::h(r), 1e-6);
}

/// An image whose tone has the ripple for its slope: luminance edges at its highest and lowest places.
TEST_P(RippleTest, AsAnImage) {
    RenderContext render(context());
    const ripple::Integral tone(30.0);
    const test::Tones tones = test::draw_points(ripple::size, ripple::size, 1, [&](glm::dvec2 p) {
        return 0.5 + 0.4 * tone.once(std::min(glm::distance(p, ripple::middle) / ripple::scale, 30.0));
    });
    for (const float window : {4.0f, 6.0f, 8.0f}) {
        test::FeatureFinding finding(render, {.feature = BrushFeature::luminance_edges, .window = window}, ripple::size,
                                     ripple::size);
        finding.find(tones);
        const double factor = 0.4 * static_cast<double>(window) / ripple::scale;
        const RippleScore found = ripple::score(
            finding.profiles(), ripple::scaled(ripple::circles(ripple_steepness, static_cast<double>(window)), factor));
        expect_accurate(found, "luminance edges");
        EXPECT_NEAR(found.curvature_error(1), 0.0, 0.08) << window;
    }
}

/// A height field that has the ripple for its slope, and one that has it for its curvature.
TEST_P(RippleTest, AsAHeightField) {
    RenderContext render(context());
    const ripple::Integral integral(60.0);
    constexpr double slope = 0.4, curvature = 0.1;
    for (const auto storage : {gpu::Format::rgba16f, gpu::Format::rgba32f})
        for (const float window : {4.0f, 6.0f, 8.0f}) {
            const auto w = static_cast<double>(window);
            test::FeatureSettings settings{
                .feature = BrushFeature::surface_edges, .window = window, .storage = storage};
            test::FeatureFinding edges(render, settings, ripple::size, ripple::size);
            edges.find(ripple::relief([&](double r) { return slope * ripple::h(r); }));
            expect_accurate(
                ripple::score(edges.profiles(), ripple::scaled(ripple::circles(ripple_steepness, w), slope)),
                "surface edges");

            const SlopeImage curved =
                ripple::relief([&](double r) { return -curvature * ripple::scale * integral.once(r); });
            settings.feature = BrushFeature::ridges;
            test::FeatureFinding ridges(render, settings, ripple::size, ripple::size);
            ridges.find(curved);
            expect_accurate(
                ripple::score(ridges.profiles(), ripple::scaled(ripple::circles(ripple_height, w), curvature * w)),
                "ridges");
            settings.feature = BrushFeature::valleys;
            test::FeatureFinding valleys(render, settings, ripple::size, ripple::size);
            valleys.find(curved);
            expect_accurate(
                ripple::score(valleys.profiles(), ripple::scaled(ripple::circles(ripple_depth, w), curvature * w)),
                "valleys");

            if (storage == gpu::Format::rgba16f) continue; // whose steps are too coarse for third derivatives
            // Mean curvature is half of that along the radius and half of that around.
            settings.feature = BrushFeature::inflections;
            test::FeatureFinding inflections(render, settings, ripple::size, ripple::size);
            inflections.find(curved);
            const auto change = [&](double r) {
                return std::abs(0.5 * (ripple::derivative(1, r) + ripple::h(r) / r - integral.once(r) / (r * r)));
            };
            expect_accurate(ripple::score(inflections.profiles(), ripple::scaled(ripple::circles(change, w),
                                                                                 curvature * w * w / ripple::scale)),
                            "inflections");
        }
}

/// The ripple itself as a relief, of triangles, through the whole of the passes: ridges where -z'' is highest.
TEST_P(RippleTest, AsAMesh) {
    test::FeatureScene scene(context(), {ripple::size, ripple::size});
    scene.scene().add(test::ripple_mesh(448, 24.0, 0.4, ripple::h, [](double r) { return ripple::derivative(1, r); }),
                      Transform{});
    // Its middle is where the other tests have it.
    const auto offset = glm::vec2(glm::dvec2(0.5 * ripple::size) - ripple::middle) / float(ripple::scale);
    const Entity camera = scene.scene().add(
        Camera{.projection = Projection::orthographic, .ymag = float(0.5 * ripple::size / ripple::scale)},
        Transform{.translation = {offset.x, offset.y, 10.0f}});
    scene.world().add(camera,
                      FeatureImage{.quality = FeatureQuality::custom, .storage = FeatureStorage::rgba32f, .fits = 3});
    constexpr float window = 6.0f;
    for (const auto& [feature, sign] : {std::pair{BrushFeature::ridges, -1.0}, {BrushFeature::valleys, 1.0}}) {
        scene.want({.feature = feature, .window = window});
        scene.draw();
        const auto height = [sign = sign](double r) { return sign * ripple::derivative(2, r); };
        const double factor = 0.4 * static_cast<double>(window) / ripple::scale;
        expect_accurate(ripple::score(scene.profiles(), ripple::scaled(ripple::circles(height, 6.0), factor)), "mesh");
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(RippleTest);

} // namespace
} // namespace hachure
