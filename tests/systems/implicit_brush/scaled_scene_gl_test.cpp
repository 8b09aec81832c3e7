// A scene a thousand times as large or small, seen from a thousand times as far or near, has the same picture.

#include <hachure/components/implicit_brush.h>
#include <hachure/systems/styles/style.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace hachure::test {
namespace {

constexpr Canvas scaled_canvas{240, 180};

/// Two rings that run through each other, one behind them, all `scale` times as large.
class ScaledScene {
public:
    ScaledScene(gpu::Context& context, float scale, bool perspective) : scene_(context, scaled_canvas) {
        const glm::quat lean = glm::angleAxis(0.9f, glm::normalize(glm::vec3(1.0f, 0.3f, 0.2f)));
        ring(scale, 1.0, 0.45, {-0.4f, 0.0f, 0.0f}, lean);
        ring(scale, 0.8, 0.4, {0.5f, 0.1f, 0.1f}, glm::inverse(lean));
        ring(scale, 0.9, 0.3, {0.3f, 0.7f, -1.5f}, lean);
        Camera camera{.yfov = 0.7f, .znear = 0.1f * scale};
        if (!perspective)
            camera = {.projection = Projection::orthographic, .ymag = 1.7f * scale, .znear = camera.znear};
        scene_.add(camera, {.translation = scale * glm::vec3(0.0f, 0.0f, 4.8f)});
        apply_style(scene_.world(), scene_.app().types(), find_style(scene_.app().types(), "brush"));
    }

    /// Lengths of all brushes in metres, `scale` times as many.
    void brush_in_metres(float scale) {
        for (auto [entity, brush] : scene_.world().query<ImplicitBrush>()) {
            brush.unit = BrushUnit::world;
            for (float* length : {&brush.window, &brush.spread, &brush.weak_spread, &brush.size, &brush.weak_size})
                *length *= 0.02f * scale;
        }
    }

    assets::Image picture() { return scene_.draw(); }

private:
    void ring(float scale, double major, double minor, glm::vec3 place, glm::quat turn) {
        const auto s = static_cast<double>(scale);
        scene_.add(surface_mesh(geometry::torus(s * major, s * minor, 96, 48)), {scale * place, turn});
    }

    DrawnScene scene_;
};

struct PictureDifference {
    int most = 0, dark = 0; ///< of 255; pixels of ink

    PictureDifference(const assets::Image& a, const assets::Image& b) {
        for (int i = 0; i < a.width * a.height * a.channels; ++i) {
            most = std::max(most, std::abs(int(a.u8()[i]) - int(b.u8()[i])));
            dark += a.u8()[i] < 80 ? 1 : 0;
        }
        dark /= a.channels;
    }
};

using BrushScaleTest = GlTest;

TEST_P(BrushScaleTest, AThousandTimesAsLargeOrSmallIsTheSamePicture) {
    for (const bool perspective : {true, false})
        for (const bool metres : {false, true}) {
            const float scale = perspective == metres ? 1000.0f : 0.001f;
            ScaledScene plain(context(), 1.0f, perspective), scaled(context(), scale, perspective);
            if (metres) plain.brush_in_metres(1.0f), scaled.brush_in_metres(scale);
            const PictureDifference difference(plain.picture(), scaled.picture());
            EXPECT_LE(difference.most, 1) << perspective << " " << metres << " " << scale;
            EXPECT_GT(difference.dark, 1000) << "there is something to compare";
        }
}

/// The test would see a brush whose lengths stay as they are.
TEST_P(BrushScaleTest, LengthsInMetresAreTrueToTheScene) {
    ScaledScene plain(context(), 1.0f, true), scaled(context(), 2.0f, true);
    plain.brush_in_metres(1.0f), scaled.brush_in_metres(1.0f);
    EXPECT_GT(PictureDifference(plain.picture(), scaled.picture()).most, 100);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(BrushScaleTest);

} // namespace
} // namespace hachure::test
