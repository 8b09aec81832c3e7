#include <hachure/components/abstracted_lines.h>
#include <hachure/components/light.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace hachure::test {
namespace {

constexpr int width = 240, height = 200;

/// An upright tube before the eye, whose rims are dark under a light from there: a line down each side. Its rows are
/// `rows` apart in the lower and in the upper half.
SurfaceMesh tube(float lower_rows, float upper_rows, std::uint32_t around) {
    SurfaceMesh mesh;
    mesh.name = "tube";
    std::vector<float> levels;
    for (float y = -2.0f; y < -1e-4f; y += lower_rows) levels.push_back(y);
    for (float y = 0.0f; y < 2.0f + 1e-4f; y += upper_rows) levels.push_back(y);
    for (const float y : levels)
        for (std::uint32_t i = 0; i < around; ++i) {
            const float angle = 6.2831853f * float(i) / float(around);
            mesh.normals.push_back({std::cos(angle), 0.0f, std::sin(angle)});
            mesh.positions.push_back(0.5f * mesh.normals.back() + glm::vec3(0, y, 0));
        }
    for (std::uint32_t row = 0; row + 1 < levels.size(); ++row)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = row * around + i, b = row * around + (i + 1) % around;
            mesh.indices.insert(mesh.indices.end(), {a, a + around, b, b, a + around, b + around});
        }
    mesh.submeshes = {{0, static_cast<std::uint32_t>(mesh.indices.size()), {}}};
    return mesh;
}

/// The mean width of the lines in the rows from `first` to `last` of the picture, px a line.
class LinesOf {
public:
    LinesOf(gpu::Context& context, SurfaceMesh mesh, const AbstractedLines& lines) {
        DrawnScene scene(context, {width, height});
        scene.world().add(scene.add(std::move(mesh)), lines);
        scene.add(Camera{.projection = Projection::orthographic, .ymag = 1.0f, .zfar = 10.0f},
                  {.translation = {0, 0, 3}});
        scene.world().create_with(Transform{}, Light{.rig = LightRig::camera});
        scene.renderer().request_aov("line_opacity");
        scene.renderer().render_frame();
        opacity_ = scene.renderer().read_aov("line_opacity");
    }

    [[nodiscard]] double width_in(int first, int last) const {
        double sum = 0.0;
        for (int y = first; y < last; ++y)
            for (int x = 0; x < width; ++x) sum += double(opacity_.f32()[2 * (y * width + x)]);
        return sum / (2 * (last - first));
    }
    [[nodiscard]] double upper() const { return width_in(20, 80); }
    [[nodiscard]] double lower() const { return width_in(120, 180); }

private:
    assets::Image opacity_;
};

/// Dark lines alone, opaque over their width.
AbstractedLines dark_lines(LineAbstraction by, float min_width = 3.0f) {
    return {.highlight = false,
            .specular = false,
            .width = 9.0f,
            .width_by = by,
            .min_width = min_width,
            .dark_low = 0.002f,
            .dark_high = 0.004f,
            .fade = 0.0f,
            .counterchange = 0.0f};
}

using MeshWidthsGlTest = GlTest;

TEST_P(MeshWidthsGlTest, LinesAreThinWhereTheMeshIsFine) {
    const LinesOf constant(context(), tube(0.02f, 0.2f, 64), dark_lines(LineAbstraction::constant));
    EXPECT_NEAR(constant.lower() / constant.upper(), 1.0, 0.05);
    const LinesOf by_mesh(context(), tube(0.02f, 0.2f, 64), dark_lines(LineAbstraction::edge_length));
    EXPECT_NEAR(by_mesh.upper() / constant.upper(), 1.0, 0.1) << "the coarse half keeps its width";
    EXPECT_LT(by_mesh.lower(), 0.6 * by_mesh.upper());
    const LinesOf even(context(), tube(0.1f, 0.1f, 64), dark_lines(LineAbstraction::edge_length));
    EXPECT_NEAR(even.lower() / even.upper(), 1.0, 0.05);
}

TEST_P(MeshWidthsGlTest, LinesAreThinWhereTheyArePaintedThin) {
    const auto painted = [&](float lower) {
        SurfaceMesh mesh = tube(0.1f, 0.1f, 64);
        for (const glm::vec3& place : mesh.positions)
            mesh.colors.emplace_back(1.0f, 1.0f, 1.0f, place.y < 0.0f ? lower : 1.0f);
        return LinesOf(context(), std::move(mesh), dark_lines(LineAbstraction::paint));
    };
    const LinesOf whole = painted(1.0f), half = painted(0.5f), none = painted(0.0f);
    EXPECT_NEAR(whole.lower() / whole.upper(), 1.0, 0.05);
    EXPECT_NEAR(half.lower() / half.upper(), 0.5, 0.1);
    EXPECT_NEAR(none.lower() / none.upper(), 3.0 / 9.0, 0.1) << "no thinner than min_width";
}

TEST_P(MeshWidthsGlTest, AMeshWithoutColoursHasItsFullWidth) {
    const LinesOf constant(context(), tube(0.1f, 0.1f, 64), dark_lines(LineAbstraction::constant));
    testing::internal::CaptureStderr();
    const LinesOf painted(context(), tube(0.1f, 0.1f, 64), dark_lines(LineAbstraction::paint));
    EXPECT_NE(testing::internal::GetCapturedStderr().find("has no vertex colours"), std::string::npos);
    EXPECT_NEAR(painted.upper() / constant.upper(), 1.0, 0.05);
    EXPECT_NEAR(painted.lower() / constant.lower(), 1.0, 0.05);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(MeshWidthsGlTest);

} // namespace
} // namespace hachure::test
