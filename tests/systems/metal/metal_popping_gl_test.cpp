// The light's stripe moves without a pop: where the step of the light is halved, the largest change from picture to
// picture halves.

#include <hachure/runtime/picture/popping.h>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "../../support/gl_fixture.h"
#include "metal_scene.h"

namespace hachure::test {
namespace {

constexpr Canvas canvas{96, 72};

/// Where something is at time t in [0, 1].
using Path = std::function<void(MetalScene&, double)>;

/// The largest change of any pixel, in 255ths, when the path is gone in so many steps.
double largest_step(MetalScene& scene, const Path& path, int steps, double from = 0.0, double to = 1.0) {
    picture::PoppingMeter meter;
    double largest = 0.0;
    for (int i = 0; i <= steps; ++i) {
        path(scene, from + (to - from) * i / steps);
        const assets::Image picture = scene.draw();
        EXPECT_TRUE(all_finite(picture));
        if (const auto change = meter.add(picture)) largest = std::max(largest, change->largest);
    }
    return largest;
}

struct Journey {
    std::string name;
    Path path;
    double from, to; ///< the part that is gone through finely
};

/// Round the axis of the object, over it and past its ends a little to the side, straight through the end of the axis.
std::vector<Journey> light_journeys() {
    const auto round = [](MetalScene& scene, double t) {
        const double a = 6.2831853 * t;
        scene.turn_light({std::sin(a), 0.3, std::cos(a)});
    };
    const auto over = [](double beside) {
        return [beside](MetalScene& scene, double t) {
            const double a = 6.2831853 * t;
            scene.turn_light({beside, std::sin(a), std::cos(a)});
        };
    };
    return {{"round the object", round, 0.0, 1.0},
            {"past the end of the axis", over(0.05), 0.2, 0.3},
            {"through the end of the axis", over(0.0), 0.2, 0.3},
            {"behind the object", over(0.1), 0.45, 0.55}};
}

std::vector<Metal> all_sources() {
    std::vector<Metal> result;
    for (const MetalSource source :
         {MetalSource::texture_u, MetalSource::around_axis, MetalSource::along_axis, MetalSource::curvature})
        for (const MetalHighlight highlight : {MetalHighlight::light, MetalHighlight::halfway})
            result.push_back({.source = source, .highlight = highlight});
    return result;
}

using MetalPoppingTest = GlTest;

void expect_no_pop(MetalScene& scene, const Journey& journey) {
    constexpr int steps = 40;
    const double whole = largest_step(scene, journey.path, steps, journey.from, journey.to);
    const double half = largest_step(scene, journey.path, 2 * steps, journey.from, journey.to);
    const double quarter = largest_step(scene, journey.path, 4 * steps, journey.from, journey.to);
    // Changes under half a 255th are none. Steps are not so small that curves count as straight: .6 instead of .5.
    EXPECT_LE(half, std::max(0.5, 0.65 * whole)) << journey.name;
    EXPECT_LE(quarter, std::max(0.5, 0.6 * half)) << journey.name;
    EXPECT_LT(quarter, 40.0) << journey.name; // a pick of the nearest stripe jumps by 128 to 255
}

TEST_P(MetalPoppingTest, TheLightMovesOnCylinderAndTorus) {
    for (const Metal& metal : all_sources())
        for (const bool round : {false, true}) {
            SCOPED_TRACE(fmt::format("source {}, highlight {}, {}", static_cast<int>(metal.source),
                                     static_cast<int>(metal.highlight), round ? "torus" : "cylinder"));
            MetalScene scene(context(), canvas,
                             surface_mesh(round ? geometry::torus(1.0, 0.4, 48, 24) : geometry::cylinder(1.0, 3.0, 48)),
                             metal, {1, 1, 1}, 1.8f,
                             {.rotation = glm::angleAxis(0.6f, glm::normalize(glm::vec3(1, 0.2f, 0.4f)))});
            for (const Journey& journey : light_journeys()) expect_no_pop(scene, journey);
        }
}

/// The camera turns about the axis of a cylinder, whose outline stays where it is: stripes and the white one move past.
TEST_P(MetalPoppingTest, TheCameraMoves) {
    const Path orbit = [](MetalScene& scene, double t) {
        Transform& place = scene.scene.world().get_mutable<Transform>(scene.camera);
        place.rotation = glm::angleAxis(static_cast<float>(t), glm::vec3(0, 1, 0));
        place.translation = place.rotation * glm::vec3(0, 0, 20);
    };
    for (const Metal& metal : all_sources()) {
        if (metal.source == MetalSource::along_axis) continue; // nothing moves
        SCOPED_TRACE(
            fmt::format("source {}, highlight {}", static_cast<int>(metal.source), static_cast<int>(metal.highlight)));
        // Higher than the picture and as wide: every pixel shows it.
        MetalScene scene(context(), canvas, surface_mesh(geometry::cylinder(1.0, 3.0, 720)), metal, {1, 0.5f, 1}, 0.6f);
        expect_no_pop(scene, {"orbit", orbit, 0.0, 1.0});
    }
}

HACHURE_INSTANTIATE_GL_TESTS(MetalPoppingTest);

} // namespace
} // namespace hachure::test
