#include <hachure/components/abstracted_lines.h>
#include <hachure/components/light.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace hachure {
namespace {

using LineLightTest = test::GlTest;

/// A sphere in the middle of the view, 200 pixels wide, and its lines with a light from a direction.
class LitSphere {
public:
    LitSphere(gpu::Context& context, float light_turn) : scene_(context, Canvas{256, 256}) {
        const Entity sphere = scene_.add(test::surface_mesh(geometry::uv_sphere(1.0, 96, 48)));
        scene_.world().add(sphere, AbstractedLines{});
        // Four away and a tangent of 1/4 wide: the outline is seen under asin(1/4).
        const float yfov = 2.0f * std::atan(1.28f * std::tan(std::asin(0.25f)));
        scene_.add(Camera{.yfov = yfov, .znear = 0.1f}, {.translation = {0, 0, 4}});
        scene_.world().create_with(Transform{.rotation = glm::angleAxis(light_turn, glm::vec3(0, 1, 0))}, Light{});
        for (const char* name : {"tone", "ridge_distance", "ridge_curvature", "line_opacity"})
            scene_.renderer().request_aov(name);
        scene_.renderer().render_frame();
    }

    assets::Image aov(const char* name) { return scene_.renderer().read_aov(name); }

private:
    test::DrawnScene scene_;
};

/// Pixels whose opacity of lines is more than a tenth, at most `radius` from the middle of the view.
int drawn_within(const assets::Image& opacity, double radius) {
    int drawn = 0;
    const auto channels = static_cast<std::size_t>(opacity.channels);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            if (std::hypot(x - 127.5, y - 127.5) > radius) continue;
            const float* p = opacity.f32() + channels * static_cast<std::size_t>(y * 256 + x);
            drawn += p[0] > 0.1f || (channels > 1 && p[1] > 0.1f) ? 1 : 0;
        }
    return drawn;
}

void expect_finite(const assets::Image& image, const char* name) {
    const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                       static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(std::isfinite(image.f32()[i])) << name << " " << i;
}

/// Black before white: an outline, and nothing inside of it.
TEST_P(LineLightTest, FromBehindAShapeIsAnOutlineAlone) {
    LitSphere sphere(context(), static_cast<float>(std::numbers::pi));
    for (const char* name : {"tone", "ridge_distance", "ridge_curvature", "line_opacity"})
        expect_finite(sphere.aov(name), name);
    const assets::Image tone = sphere.aov("tone");
    EXPECT_EQ(tone.f32()[static_cast<std::size_t>(tone.channels) * (128 * 256 + 128)], 0.0f);
    EXPECT_EQ(drawn_within(sphere.aov("line_opacity"), 80.0), 0);
}

/// From the eye a sphere darkens towards its outline, which is a thin dark area before a white background.
TEST_P(LineLightTest, FromTheEyeTheOutlineIsALine) {
    LitSphere sphere(context(), 0.0f);
    const assets::Image opacity = sphere.aov("line_opacity");
    EXPECT_EQ(drawn_within(opacity, 80.0), 0);
    EXPECT_GE(drawn_within(opacity, 110.0), 300);
}

HACHURE_INSTANTIATE_GL_TESTS(LineLightTest);

} // namespace
} // namespace hachure
