// The light's stripe moves without a pop: where the step of the light is halved, the largest change from picture to
// picture halves.

#include <hachure/runtime/picture/popping.h>
#include <hachure/tests/support/gl_fixture.h>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "metal_scene.h"

namespace hachure::test {
namespace {

constexpr Canvas popping_canvas{72, 54};

/// Where something is at so many degrees of its way.
using Path = std::function<void(MetalScene&, double degrees)>;

/// The largest change of any pixel, in 255ths, when the way is gone in so many steps.
double largest_step(MetalScene& scene, const Path& path, int steps, double from, double to) {
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
    double from, to; ///< degrees
};

/// Round the axis of the object, past and through the end of the axis, and over the object's back.
std::vector<Journey> light_journeys() {
    const auto round = [](MetalScene& scene, double degrees) {
        const double a = glm::radians(degrees);
        scene.turn_light({std::sin(a), 0.3, std::cos(a)});
    };
    const auto over = [](double beside) {
        return [beside](MetalScene& scene, double degrees) {
            const double a = glm::radians(degrees);
            scene.turn_light({beside, std::sin(a), std::cos(a)});
        };
    };
    return {{"round the object, in front", round, 20, 45},
            {"round the object, behind", round, 165, 190},
            {"past the end of the axis", over(0.05), 75, 100},
            {"through the end of the axis", over(0.0), 80, 105},
            {"over its back", over(0.1), 170, 195}};
}

using MetalPoppingTest = GlTest;

void expect_no_pop(MetalScene& scene, const Journey& journey) {
    const auto degrees = static_cast<int>(journey.to - journey.from);
    const double whole = largest_step(scene, journey.path, degrees, journey.from, journey.to);
    const double half = largest_step(scene, journey.path, 2 * degrees, journey.from, journey.to);
    const double quarter = largest_step(scene, journey.path, 4 * degrees, journey.from, journey.to);
    // A change of half a 255th is none. A path is not quite as steep everywhere, and a degree is not small: .65, then
    // .6.
    EXPECT_LE(half, std::max(0.5, 0.75 * whole)) << journey.name;
    EXPECT_LE(quarter, std::max(0.5, 0.6 * half)) << journey.name;
    EXPECT_LT(quarter, 64.0) << journey.name; // the nearest stripe, when it is picked, jumps by 128 to 255
}

TEST_P(MetalPoppingTest, TheLightMovesOnCylinderAndTorus) {
    for (const MetalSource source :
         {MetalSource::texture_u, MetalSource::around_axis, MetalSource::along_axis, MetalSource::curvature})
        for (const bool round : {false, true}) {
            SCOPED_TRACE(fmt::format("source {}, {}", static_cast<int>(source), round ? "torus" : "cylinder"));
            const Metal metal{.source = source, .highlight = round ? MetalHighlight::halfway : MetalHighlight::light};
            MetalScene scene(context(), popping_canvas,
                             surface_mesh(round ? geometry::torus(1.0, 0.4, 48, 24) : geometry::cylinder(1.0, 3.0, 48)),
                             metal, {1, 1, 1}, 1.8f,
                             {.rotation = glm::angleAxis(0.6f, glm::normalize(glm::vec3(1, 0.2f, 0.4f)))});
            for (const Journey& journey : light_journeys()) expect_no_pop(scene, journey);
        }
}

/// The camera turns about the axis of a cylinder, whose outline stays where it is: stripes and the white one move past.
TEST_P(MetalPoppingTest, TheCameraMoves) {
    const Path orbit = [](MetalScene& scene, double degrees) {
        Transform& place = scene.scene.world().get_mutable<Transform>(scene.camera);
        place.rotation = glm::angleAxis(static_cast<float>(glm::radians(degrees)), glm::vec3(0, 1, 0));
        place.translation = place.rotation * glm::vec3(0, 0, 20);
    };
    for (const MetalSource source : {MetalSource::texture_u, MetalSource::around_axis, MetalSource::curvature}) {
        SCOPED_TRACE(fmt::format("source {}", static_cast<int>(source)));
        // Higher than the picture and wider: every pixel shows it.
        MetalScene scene(context(), popping_canvas, surface_mesh(geometry::cylinder(1.0, 3.0, 720)), {.source = source},
                         {1, 0.5f, 1}, 0.6f);
        expect_no_pop(scene, {"orbit", orbit, 0, 30});
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(MetalPoppingTest);

} // namespace
} // namespace hachure::test
