// The limb of a sphere that turns: its slope grows there without bound (readings of Vergne 2011), and its facets come
// and go.

#include <hachure/tests/support/feature_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/systems/implicit_brush/line_energy.h>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace hachure::test {
namespace {

constexpr int limb_size = 128;

/// A sphere of radius 1 with smooth normals, so many facets around; and an eye that sees it `radius` px large.
class Ball {
public:
    Ball(gpu::Context& context, geometry::Shape shape, bool perspective, double radius)
        : scene_(context, {limb_size, limb_size}) {
        ball_ = scene_.scene().add(surface_mesh(shape), {});
        const double half = 0.5 * limb_size / radius; // of the picture's height, in radii
        // From 4 away the outline is that of a cone that touches the sphere: at an angle of asin(1/4).
        const double tangent = std::tan(std::asin(0.25));
        const Camera camera = perspective
                                  ? Camera{.yfov = static_cast<float>(2.0 * std::atan(half * tangent))}
                                  : Camera{.projection = Projection::orthographic, .ymag = static_cast<float>(half)};
        scene_.scene().add(camera, {.translation = {0.0f, 0.0f, 4.0f}});
    }

    std::vector<PixelProfile> turned(BrushFeature feature, double angle) {
        const glm::vec3 axis = glm::normalize(glm::vec3(0.3f, 1.0f, 0.2f));
        scene_.world().get_mutable<Transform>(ball_).rotation = glm::angleAxis(static_cast<float>(angle), axis);
        scene_.want({.feature = feature, .diffusion = 4});
        scene_.draw();
        return scene_.profiles();
    }

private:
    FeatureScene scene_;
    Entity ball_;
};

/// What its lines are like over a turn by small steps.
struct Turn {
    std::vector<double> energies;
    double inside = 0.0, outside = 0.0; ///< how far from the outline lines are, px
    bool finite = true;

    Turn(Ball& ball, BrushFeature feature, double radius) {
        for (int i = 0; i < 6; ++i) {
            const std::vector<PixelProfile> profiles = ball.turned(feature, 0.013 * i);
            energies.push_back(line_energy(profiles, 0.1, 0.2));
            for (std::size_t k = 0; k < profiles.size(); ++k) add(profiles[k], static_cast<int>(k), radius);
        }
    }

    void add(const PixelProfile& p, int index, double radius) {
        finite = finite && std::isfinite(p.offset.x) && std::isfinite(p.offset.y) && std::isfinite(p.height) &&
                 std::isfinite(p.curvature);
        if (p.height < 0.1) return;
        const glm::dvec2 line = pixel_center(index % limb_size, index / limb_size) + p.offset;
        const double beyond = glm::distance(line, glm::dvec2(0.5 * limb_size)) - radius;
        inside = std::max(inside, -beyond), outside = std::max(outside, beyond);
    }
};

class BrushLimbTest : public GlTest {
protected:
    /// Balls of few and of many facets, small and large, in both projections.
    void for_each_ball(const std::function<void(Ball&, double radius)>& test) {
        for (const double radius : {14.3, 40.3})
            for (const bool perspective : {false, true})
                for (const bool coarse : {false, true}) {
                    SCOPED_TRACE(testing::Message() << radius << " px" << (perspective ? ", perspective" : "")
                                                    << (coarse ? ", coarse" : ""));
                    Ball ball(context(), coarse ? geometry::uv_sphere(1.0, 48, 24) : geometry::icosphere(1.0, 5),
                              perspective, radius);
                    test(ball, radius);
                }
    }
};

/// The outline is where the sphere ends, to the pixel that depth knows it to, and does not flicker.
TEST_P(BrushLimbTest, OutlinesStandStill) {
    for_each_ball([](Ball& ball, double radius) {
        const Turn turn(ball, BrushFeature::contours, radius);
        const double length = 2.0 * std::numbers::pi * radius;
        EXPECT_TRUE(turn.finite);
        EXPECT_LE(turn.inside, 0.6);
        EXPECT_LE(turn.outside, 0.3);
        EXPECT_NEAR(turn.energies.front(), 2.3 * length, 0.05 * length);
        EXPECT_LE(largest_step(turn.energies), 0.01 * length);
    });
}

/// Slopes and curvatures grow up to the limb, and have no maximum before it.
TEST_P(BrushLimbTest, NothingIsDrawnInside) {
    for_each_ball([](Ball& ball, double radius) {
        for (const BrushFeature feature :
             {BrushFeature::surface_edges, BrushFeature::ridges, BrushFeature::valleys, BrushFeature::inflections}) {
            const Turn turn(ball, feature, radius);
            EXPECT_TRUE(turn.finite) << int(feature);
            EXPECT_LE(*std::ranges::max_element(turn.energies), 0.1 * 2.0 * std::numbers::pi * radius)
                << int(feature) << ": of 2.3 for each pixel of a line";
        }
    });
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(BrushLimbTest);

} // namespace
} // namespace hachure::test
