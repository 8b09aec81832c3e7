// Where finding features fails or nearly does (readings of Vergne 2011): what must not happen there, and what it still
// reaches.

#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/tests/support/brush_reference.h>
#include <hachure/tests/support/feature_finding.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/systems/implicit_brush/line_energy.h>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace hachure {
namespace {

using test::FeatureFinding;
using test::FeatureSettings;
using test::PixelProfile;
using test::SlopeImage;

constexpr int features_size = 96;
const glm::dvec2 features_middle(48.3, 47.6);

using FeatureFailuresTest = test::GlTest;

/// About a generic umbilic curvature is the mean and a cone upside down: it has no maximum, however theta turns.
TEST_P(FeatureFailuresTest, UmbilicsHaveNoLines) {
    RenderContext render(context());
    for (const double around : {-1.0, 0.3}) // star and lemon: index -1/2 and 1/2
        for (const double turn : {0.0, 0.4})
            for (const BrushFeature feature : {BrushFeature::ridges, BrushFeature::valleys}) {
                FeatureFinding finding(render, {.feature = feature}, features_size, features_size);
                // z = -(x^2 + y^2) / 80 + (x^3 + 3 `around` x y^2) / 1200
                finding.find(SlopeImage::of(features_size, features_size, [&](glm::dvec2 p) {
                    const glm::dvec2 x(std::cos(turn), std::sin(turn)), y(-x.y, x.x), q = p - features_middle;
                    const double u = glm::dot(q, x), v = glm::dot(q, y);
                    const double du = -u / 40.0 + (u * u + around * v * v) / 400.0;
                    const double dv = -v / 40.0 + around * u * v / 200.0;
                    return du * x + dv * y;
                }));
                EXPECT_TRUE(finding.all_finite());
                const std::vector<PixelProfile> found = finding.profiles();
                for (int y = 30; y < 66; ++y)
                    for (int x = 30; x < 66; ++x)
                        ASSERT_LE(found[std::size_t(y * features_size + x)].height, 0.02)
                            << around << " " << x << " " << y;
            }
}

/// Planes, cylinders' flanks, spheres and ramps of curvature: profiles without a top.
TEST_P(FeatureFailuresTest, DegenerateProfilesHaveNoLines) {
    RenderContext render(context());
    const auto none = [&](BrushFeature feature, const auto& gradient) {
        FeatureFinding finding(render, {.feature = feature}, features_size, features_size);
        finding.find(SlopeImage::of(features_size, features_size, gradient));
        EXPECT_TRUE(finding.all_finite());
        const std::vector<PixelProfile> found = finding.profiles();
        for (int y = 8; y < features_size - 8; ++y) // at the border of the picture what rises ends
            for (int x = 8; x < features_size - 8; ++x)
                ASSERT_LE(found[std::size_t(y * features_size + x)].height, 0.01)
                    << int(feature) << " " << x << " " << y;
    };
    for (const BrushFeature feature : {BrushFeature::surface_edges, BrushFeature::ridges, BrushFeature::valleys}) {
        none(feature, [](glm::dvec2) { return glm::dvec2(0.0); });
        none(feature, [](glm::dvec2) { return glm::dvec2(0.4, -0.3); });
    }
    for (const BrushFeature feature : {BrushFeature::ridges, BrushFeature::valleys}) {
        none(feature, [](glm::dvec2 p) { return (p - features_middle) / 100.0; });      // paraboloid
        none(feature, [](glm::dvec2 p) { return glm::dvec2((p.x - 48.0) / 50.0, 0); }); // its profile
        none(feature, [](glm::dvec2 p) { return glm::dvec2((p.x - 48.0) * (p.x - 48.0) / 4000.0, 0); });
    }
}

/// Curvature like a Gaussian hill across a straight ridge, in px.
double ridge_slope(double across, double deviation, double curvature) {
    return -curvature * deviation * std::sqrt(std::numbers::pi / 2.0) *
           std::erf(across / (std::numbers::sqrt2 * deviation));
}

/// Where ridges cross both are drawn through. Where they cross aslant and are less than two deviations apart, curvature
/// has one maximum, between them: that is their line.
TEST_P(FeatureFailuresTest, JunctionsAreWhole) {
    RenderContext render(context());
    constexpr double deviation = 2.5;
    for (const double angle : {0.2, 0.5, 0.9})
        for (const double between : {90.0, 75.0, 60.0}) {
            const glm::dvec2 a(-std::sin(angle), std::cos(angle));
            const double turned = angle + glm::radians(between);
            const glm::dvec2 b(-std::sin(turned), std::cos(turned));
            FeatureFinding finding(render, {.feature = BrushFeature::ridges, .diffusion = 1, .fits = 3}, features_size,
                                   features_size);
            finding.find(SlopeImage::of(features_size, features_size, [&](glm::dvec2 p) {
                return ridge_slope(glm::dot(p - features_middle, a), deviation, 0.1) * a +
                       ridge_slope(glm::dot(p - features_middle, b), deviation, 0.1) * b;
            }));
            const std::vector<PixelProfile> found = finding.profiles();
            int wanted = 0, drawn = 0;
            for (int y = 0; y < features_size; ++y)
                for (int x = 0; x < features_size; ++x) {
                    const glm::dvec2 p = test::pixel_center(x, y) - features_middle;
                    const double nearest = std::min(std::abs(glm::dot(p, a)), std::abs(glm::dot(p, b)));
                    if (nearest > 0.71 || glm::length(p) > 12.0) continue;
                    const PixelProfile& profile = found[std::size_t(y * features_size + x)];
                    ++wanted;
                    drawn += profile.found() && glm::length(profile.offset) < (between == 90.0 ? 1.6 : 2.2) ? 1 : 0;
                }
            EXPECT_GE(drawn, 0.98 * wanted - 1) << angle << " " << between;
        }
}

/// Waves and grids moved by a tenth of a pixel: their lines move along, and nothing comes or goes.
TEST_P(FeatureFailuresTest, WavesAndGridsFollowSmallChanges) {
    RenderContext render(context());
    for (const bool grid : {false, true})
        for (const double length : {9.0, 14.0, 24.0}) {
            const glm::dvec2 along(std::cos(0.3), std::sin(0.3)), across(-along.y, along.x);
            FeatureFinding finding(render, {.feature = BrushFeature::ridges, .diffusion = 2, .window = 4.0f, .fits = 3},
                                   features_size, features_size);
            const double k = 2.0 * std::numbers::pi / length;
            double before = -1.0;
            for (const double shift : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}) {
                finding.find(SlopeImage::of(features_size, features_size, [&](glm::dvec2 p) {
                    const double u = glm::dot(p - features_middle, along) - shift,
                                 v = glm::dot(p - features_middle, across);
                    return -0.5 * (std::sin(k * u) * along + (grid ? std::sin(k * v) : 0.0) * across);
                }));
                const double now = test::line_energy(finding.profiles(), 0.1, 0.2);
                EXPECT_GT(now, 0.0);
                if (before < 0.0) before = now;
                EXPECT_NEAR(now / before, 1.0, 0.03) << grid << " " << length << " " << shift;
                before = now;
            }
        }
}

/// A model that moves away to a 32nd of its size: its lines fade, per length that is left of them, and don't flicker.
TEST_P(FeatureFailuresTest, LinesFadeWhenTheyMoveAway) {
    RenderContext render(context());
    for (const int samples : {1, 2}) { // of a pixel, to a side
        FeatureFinding finding(render, {.feature = BrushFeature::ridges, .diffusion = 4, .window = 4.0f, .fits = 3},
                               features_size, features_size);
        std::vector<double> energies;
        for (int step = 0; step <= 30; ++step) {
            const double scale = 16.0 * std::exp2(-step / 6.0); // px of a unit of the ripple: 100 px a wave, to 3
            finding.find(SlopeImage::of(features_size, features_size, [&](glm::dvec2 p) {
                glm::dvec2 sum(0.0);
                for (int j = 0; j < samples; ++j)
                    for (int i = 0; i < samples; ++i) {
                        const glm::dvec2 q = p - 0.5 + glm::dvec2(i + 0.5, j + 0.5) / double(samples) - features_middle;
                        const double r = std::max(glm::length(q) / scale, 1e-6);
                        if (r < 26.7) sum += 0.5 * test::ripple::derivative(1, r) / r * q / scale;
                    }
                return sum / double(samples * samples);
            }));
            EXPECT_TRUE(finding.all_finite());
            energies.push_back(test::line_energy(finding.profiles(), 0.05, 0.1));
        }
        const double most = *std::ranges::max_element(energies);
        for (std::size_t i = 1; i < energies.size(); ++i)
            EXPECT_NEAR(energies[i], energies[i - 1], (samples == 1 ? 0.3 : 0.25) * most) << samples << " " << i;
        EXPECT_LE(energies.back(), 0.1 * most) << samples;
    }
}

/// What is no number in a picture of another renderer counts as nothing, and spreads nowhere.
TEST_P(FeatureFailuresTest, WhatIsNoNumberSpreadsNowhere) {
    RenderContext render(context());
    render.view_uniforms.bind({.view_from_world = glm::mat4(1.0f), .width = features_size, .height = features_size},
                              LightList{});
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const std::vector<float> bad{nan, inf, -inf, 1e38f, -1e38f, 0.0f};
    const auto texture = [&](gpu::Format format) {
        return render.backend->create_texture({features_size, features_size, format}, "picture");
    };
    const std::uint32_t none = texture(gpu::Format::depth32f), depth = texture(gpu::Format::r32f);
    const std::uint32_t normal = texture(gpu::Format::rgba32f);
    std::vector<float> depths, normals;
    for (int i = 0; i < features_size * features_size; ++i) {
        depths.push_back(5.0f + 0.01f * std::sin(0.3f * float(i % features_size)));
        normals.insert(normals.end(), {0.0f, 0.0f, 1.0f, 0.0f});
        if (i % 7 == 0) depths.back() = bad[std::size_t(i / 7) % bad.size()];
        if (i % 11 == 0) normals[std::size_t(4 * i + i % 3)] = bad[std::size_t(i / 11) % bad.size()];
    }
    render.backend->texture(none).clear(std::array{0.0f, 0.0f, 0.0f, 0.0f});
    render.backend->texture(depth).upload(std::span<const float>(depths));
    render.backend->texture(normal).upload(std::span<const float>(normals));
    for (const BrushFeature feature : {BrushFeature::contours, BrushFeature::surface_edges, BrushFeature::ridges,
                                       BrushFeature::valleys, BrushFeature::inflections}) {
        FeatureFinding finding(render, {.feature = feature, .diffusion = 3}, features_size, features_size);
        SlopeJob{.kind = feature == BrushFeature::contours ? SlopeKind::breaks : SlopeKind::surface,
                 .depth_buffer = none,
                 .normals = normal,
                 .picture_depth = depth,
                 .picture_normals = normal,
                 .rect = {0, 0, features_size, features_size},
                 .to = finding.slope_texture()}
            .run(render);
        finding.run();
        EXPECT_TRUE(finding.all_finite()) << static_cast<int>(feature);
    }
    test::Tones tones(features_size, features_size);
    for (std::size_t i = 0; i < tones.values.size(); ++i)
        tones.values[i] =
            i % 5 == 0 ? static_cast<double>(bad[i / 5 % bad.size()]) : 0.5 + 0.5 * std::sin(0.2 * double(i));
    FeatureFinding finding(render, {.feature = BrushFeature::luminance_edges, .diffusion = 3}, features_size,
                           features_size);
    finding.find(tones);
    EXPECT_TRUE(finding.all_finite());
    for (const std::uint32_t id : {none, depth, normal}) render.backend->destroy_texture(id);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(FeatureFailuresTest);

} // namespace
} // namespace hachure
