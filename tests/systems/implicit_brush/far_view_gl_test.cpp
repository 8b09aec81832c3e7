// What is smaller than a pixel: noise on a surface that is far away (figure 4), a model that moves away, and what finer
// samples of a pixel change.

#include <hachure/tests/support/brush_reference.h>
#include <hachure/tests/support/feature_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/ripple_mesh.h>
#include <hachure/tests/support/ripple_score.h>
#include <hachure/tests/systems/implicit_brush/line_energy.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace hachure::test {
namespace {

constexpr double relief = 0.4; // of the ripple
const auto far_ripple = [](double r) { return ripple::h(r); };
const auto far_ripple_slope = [](double r) { return ripple::derivative(1, r); };

/// Waves half a metre long in all directions, on the half where x > 0; slopes of .06 on average (mean square).
class Roughness {
public:
    Roughness() {
        std::mt19937 random(3);
        const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
        for (int i = 0; i < count; ++i) {
            const double k = 2.0 * std::numbers::pi / (0.4 + 0.2 * unit()), angle = 2.0 * std::numbers::pi * unit();
            waves_.push_back({k * glm::dvec2(std::cos(angle), std::sin(angle)), 2.0 * std::numbers::pi * unit()});
        }
    }

    Bump operator()(glm::dvec2 p) const {
        if (p.x <= 0.0) return {};
        Bump sum;
        for (const Wave& wave : waves_) {
            const double phase = glm::dot(wave.k, p) + wave.phase;
            const double slope = 0.06 * std::sqrt(2.0 / count);
            sum.z += slope / glm::length(wave.k) * std::cos(phase);
            sum.gradient -= slope * std::sin(phase) * glm::normalize(wave.k);
        }
        return sum;
    }

private:
    static constexpr int count = 12;
    struct Wave {
        glm::dvec2 k;
        double phase;
    };
    std::vector<Wave> waves_;
};

/// Ridges of the half rough ripple from straight above, `scale` px to a metre, as far as `outer` metres from its
/// middle.
RippleScore rough_ripple(gpu::Context& context, int size, double scale, double outer) {
    FeatureScene scene(context, {size, size});
    scene.scene().add(ripple_mesh(448, 24.0, relief, far_ripple, far_ripple_slope, Roughness()), Transform{});
    scene.scene().add(Camera{.projection = Projection::orthographic, .ymag = static_cast<float>(0.5 * size / scale)},
                      Transform{.translation = {0.0f, 0.0f, 10.0f}});
    constexpr double window = 6.0;
    scene.want({.feature = BrushFeature::ridges, .diffusion = 8, .window = static_cast<float>(window)});
    scene.draw();
    std::vector<TrueCircle> circles;
    double faintest = 1e9;
    for (const double r : maxima([](double x) { return -ripple::derivative(2, x); }, 2.5, outer)) {
        circles.push_back({.radius = scale * r});
        faintest = std::min(faintest, -relief * ripple::derivative(2, r) / scale * window);
    }
    RippleScore score(glm::dvec2(0.5 * size), 2.2 * scale, outer * scale, 2.0, circles);
    score.add(scene.profiles(), size, 0.5 * faintest);
    return score;
}

using BrushFarViewTest = GlTest;

/// Figure 4: noise clutters the near view and is gone from the far one.
TEST_P(BrushFarViewTest, NoiseDisappearsFromFarAway) {
    const RippleScore near = rough_ripple(context(), 192, 14.0, 6.8), far = rough_ripple(context(), 192, 4.6, 20.0);
    EXPECT_LT(near.precision(), 0.8) << "half of it is rough";
    EXPECT_GE(far.precision(), 0.98);
    EXPECT_GE(far.recall(), 0.97);
    RecordProperty("near", std::to_string(near.precision()));
    RecordProperty("far", std::to_string(far.precision()) + " " + std::to_string(far.recall()));
}

/// A dolly to a 32nd of the size, with one and with four samples of each pixel: lines fade, and none jumps.
TEST_P(BrushFarViewTest, LinesFadeOnTheWay) {
    for (const int samples : {1, 2}) {
        FeatureScene scene(context(), {96, 96});
        scene.scene().add(ripple_mesh(224, 24.0, relief, far_ripple, far_ripple_slope), Transform{});
        const Entity camera = scene.scene().add(Camera{.yfov = 0.5f}, Transform{});
        scene.world().add(camera, FeatureImage{.samples = samples});
        scene.want({.feature = BrushFeature::ridges, .diffusion = 4, .window = 4.0f});
        std::vector<double> energies;
        for (int step = 0; step <= 20; ++step) {
            const float distance = 12.0f * std::exp2(0.25f * static_cast<float>(step));
            scene.world().get_mutable<Transform>(camera).translation = {0.3f, 0.2f, distance};
            scene.draw();
            energies.push_back(line_energy(scene.profiles(), 0.05, 0.1));
            EXPECT_TRUE(std::isfinite(energies.back()));
        }
        RecordProperty("energies_" + std::to_string(samples), ::testing::PrintToString(energies));
        const double most = *std::ranges::max_element(energies);
        EXPECT_GT(most, 200.0);
        EXPECT_LE(largest_step(energies), 0.3 * most) << samples << ::testing::PrintToString(energies);
        EXPECT_LE(energies.back(), 0.1 * most) << samples << ::testing::PrintToString(energies);
    }
}

struct Step {
    double place = 0.0, height = 0.0; ///< of its contour, px across it and as a mean
    int pixels = 0;
};

/// The edge of a board in front of a wall, `along` radians from upright, its place in px from the picture's middle.
Step board(gpu::Context& context, int samples, double along, double place) {
    constexpr int size = 64;
    FeatureScene scene(context, {size, size});
    const glm::quat upright = glm::angleAxis(glm::radians(90.0f), glm::vec3(1.0f, 0.0f, 0.0f));
    scene.scene().add(surface_mesh(geometry::plane(200.0, 1)), {.rotation = upright});
    const glm::dvec2 across(std::cos(along), std::sin(along));
    const glm::vec2 middle(-(100.0 - place) * across); // a pixel is a metre
    scene.scene().add(surface_mesh(geometry::plane(200.0, 1)),
                      {{middle.x, middle.y, 30.0f},
                       glm::angleAxis(static_cast<float>(along), glm::vec3(0.0f, 0.0f, 1.0f)) * upright});
    const Entity camera = scene.scene().add(Camera{.projection = Projection::orthographic, .ymag = 0.5f * size},
                                            {.translation = {0, 0, 99}});
    scene.world().add(camera, FeatureImage{.samples = samples});
    scene.want({.feature = BrushFeature::contours, .diffusion = 0, .window = 4.0f});
    scene.draw();
    Step step;
    for (int y = 12; y < size - 12; ++y)
        for (int x = 12; x < size - 12; ++x) {
            const PixelProfile& p = scene.profiles()[static_cast<std::size_t>(y * size + x)];
            if (p.height < 0.2 || glm::length(p.offset) > 1.5) continue;
            step.place += glm::dot(pixel_center(x, y) + p.offset - 0.5 * size, across);
            step.height += p.height;
            ++step.pixels;
        }
    step.place /= step.pixels, step.height /= step.pixels;
    return step;
}

/// Finer samples know better where depth breaks off, and no less how much.
TEST_P(BrushFarViewTest, FinerSamplesFindTheSameContour) {
    for (const double along : {0.0, 0.3})
        for (const double place : {0.1, 0.35, 0.6, 0.85}) {
            const Step one = board(context(), 1, along, place), two = board(context(), 2, along, place);
            SCOPED_TRACE(testing::Message() << along << " " << place << ": " << one.place << " " << two.place << ", "
                                            << one.height << " " << two.height);
            ASSERT_GT(std::min(one.pixels, two.pixels), 60);
            EXPECT_NEAR(one.place, place, 0.51);
            EXPECT_NEAR(two.place, place, 0.26);
            EXPECT_NEAR(two.height / one.height, 1.0, 0.05);
        }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(BrushFarViewTest);

} // namespace
} // namespace hachure::test
