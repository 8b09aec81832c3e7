#include <hachure/components/gooch.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <glm/gtc/constants.hpp>

#include <array>
#include <string>

#include "closed_form.h"

namespace hachure::test {
namespace {

constexpr Canvas canvas{256, 192};
constexpr double tolerance = 1e-3;

/// 327,680 triangles. Their edges span .0087 rad, so that the faces lie up to .0087^2 / 6 = 1.3e-5 radii inside the
/// sphere. Where a ray meets the sphere at an angle of incidence theta, the hit moves by 1.3e-5 / cos theta; two pixels
/// inside an outline of 60 pixels radius, cos theta is .25, which gives 5e-5 in depth and normal. The highlight is the
/// steepest part of the shading: its slope is at most 2 sqrt(shininess / e) = 8 per radian, and half a radian from the
/// outline the move is under 3e-5. So tessellation takes less than a third of the tolerance anywhere.
const geometry::Shape& fine_sphere() {
    static const geometry::Shape shape = geometry::icosphere(1.0, 7);
    return shape;
}

/// The square [-1, 1]^2 in z = 0 that faces +Z; texture coordinate (0, 0) at its upper left corner.
geometry::Shape square() {
    return {.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
            .normals = {4, {0, 0, 1}},
            .texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}},
            .indices = {0, 1, 2, 0, 2, 3}};
}

struct Trial {
    std::string name;
    Camera camera;
    Gooch gooch;
    glm::vec3 sphere_scale{1.2f};
};

Transform camera_place() {
    const glm::quat turn = glm::angleAxis(0.6f, glm::vec3(0, 1, 0)) * glm::angleAxis(-0.4f, glm::vec3(1, 0, 0));
    return {.translation = turn * glm::vec3(0.1f, 0.2f, 7.0f), .rotation = turn};
}

std::vector<CastObject> still_life(const Trial& trial) {
    const glm::quat turn = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    return {
        {CastObject::sphere,
         {.translation = {-0.7f, 0.2f, 0.4f}, .rotation = turn, .scale = trial.sphere_scale},
         {0.8, 0.5, 0.3}},
        {CastObject::square,
         {.translation = {0.9f, -0.1f, -0.8f}, .rotation = camera_place().rotation * turn, .scale = {1.3f, 1.1f, 1.0f}},
         {0.2, 0.6, 0.7},
         true}};
}

SurfaceMaterial material_of(const CastObject& object) {
    SurfaceMaterial material;
    material.base_color = glm::vec4(glm::vec3(object.color), 1.0f);
    material.double_sided = object.double_sided;
    return material;
}

struct Worst {
    double color = 0.0, normal = 0.0, depth = 0.0;
    int wrong_ids = 0, checked = 0, drawn = 0;
};

/// Draws the objects and compares every pixel away from outlines with the closed form.
Worst compare(gpu::Context& context, const Trial& trial, const std::vector<CastObject>& objects) {
    DrawnScene scene(context, canvas);
    for (const char* aov : {"color", "normal", "depth", "object_id"}) scene.renderer().request_aov(aov);
    for (const CastObject& object : objects)
        scene.world().add(
            scene.add(surface_mesh(object.kind == CastObject::sphere ? fine_sphere() : square(), material_of(object)),
                      object.transform),
            trial.gooch);
    scene.add(trial.camera, camera_place());
    spawn_default_light(scene.world());
    scene.renderer().render_frame();
    const assets::Image color = scene.renderer().read_aov("color"), normal = scene.renderer().read_aov("normal"),
                        depth = scene.renderer().read_aov("depth"), id = scene.renderer().read_aov("object_id");

    const RayCamera camera(trial.camera, camera_place(), canvas);
    const std::vector<Hit> hits = cast_all(objects, camera, canvas);
    Worst worst;
    for (int row = 0; row < canvas.height; ++row)
        for (int column = 0; column < canvas.width; ++column) {
            if (!away_from_outlines(hits, canvas, column, row)) continue;
            const int i = row * canvas.width + column;
            const Hit& hit = hits[static_cast<std::size_t>(i)];
            const dvec3 expected =
                hit.object == 0 ? dvec3(1.0)
                                : gooch_color(trial.gooch, objects[static_cast<std::size_t>(hit.object - 1)].color,
                                              hit.normal, camera.light(), -camera.ray(column, row).direction);
            for (int c = 0; c < 3; ++c) {
                worst.color = std::max(worst.color, std::abs(double(color.f32()[3 * i + c]) - expected[c]));
                worst.normal = std::max(worst.normal, std::abs(double(normal.f32()[3 * i + c]) - hit.normal[c]));
            }
            if (hit.object == 0)
                worst.depth = std::max(worst.depth, depth.f32()[i] == 1e10f ? 0.0 : 1.0);
            else
                worst.depth = std::max(worst.depth, std::abs(double(depth.f32()[i]) - hit.depth));
            worst.wrong_ids += id.f32()[i] != static_cast<float>(hit.object) ? 1 : 0;
            worst.checked += 1;
            worst.drawn += hit.object > 0 ? 1 : 0;
        }
    return worst;
}

void expect_exact(const Worst& worst) {
    EXPECT_LE(worst.color, tolerance);
    EXPECT_LE(worst.normal, tolerance);
    EXPECT_LE(worst.depth, tolerance);
    EXPECT_EQ(worst.wrong_ids, 0);
    // Most of the picture is checked, and a good part of it is drawn.
    EXPECT_GT(worst.checked, canvas.width * canvas.height * 8 / 10);
    EXPECT_GT(worst.drawn, 4000);
}

std::vector<Trial> trials() {
    const Camera perspective{.yfov = 0.7f};
    const Camera orthographic{.projection = Projection::orthographic, .ymag = 2.4f, .zfar = 100.0f};
    const Gooch figure7{.b = 0.4f, .y = 0.4f, .alpha = 0.2f, .beta = 0.6f, .highlight = 0.0f};
    const Gooch figure8{.b = 0.55f, .y = 0.3f, .alpha = 0.25f, .beta = 0.5f, .highlight = 0.0f};
    Gooch printed = figure8, shiny = figure7, dull = figure8;
    printed.printed_equation = true;
    shiny.highlight = 0.8f;
    dull.highlight = 0.5f;
    dull.shininess = 5.0f;
    const Camera bounded{.yfov = 0.7f, .znear = 0.5f, .zfar = 30.0f};
    const Camera unbounded{.projection = Projection::orthographic, .ymag = 2.4f};
    return {{"figure 7, perspective", perspective, figure7},
            {"figure 7, orthographic", orthographic, figure7},
            {"figure 8, far plane", bounded, figure8},
            {"equation as printed", perspective, printed},
            {"highlight", perspective, shiny},
            {"highlight, orthographic without a far plane", unbounded, shiny},
            {"broad highlight on an ellipsoid", perspective, dull, {1.5f, 0.8f, 1.1f}},
            {"mirrored", perspective, shiny, {-1.2f, 1.2f, 1.2f}},
            {"mirrored thrice", orthographic, shiny, {-1.3f, -0.9f, -1.1f}}};
}

using GoochTest = GlTest;

TEST_P(GoochTest, SphereAndSquareMatchTheClosedForm) {
    for (const Trial& trial : trials()) {
        SCOPED_TRACE(trial.name);
        const Worst worst = compare(context(), trial, still_life(trial));
        expect_exact(worst);
        RecordProperty(trial.name, std::to_string(std::max({worst.color, worst.normal, worst.depth})));
    }
}

/// The test must be able to fail: another reading of the paper is told from ours.
TEST_P(GoochTest, TheClosedFormTellsTheReadingsApart) {
    const Trial trial = trials()[0];
    const std::vector<CastObject> objects = still_life(trial);
    const RayCamera camera(trial.camera, camera_place(), canvas);
    const Hit hit = cast_all(objects, camera, canvas)[static_cast<std::size_t>(canvas.width * 100 + 90)];
    ASSERT_EQ(hit.object, 1);
    Gooch printed = trial.gooch;
    printed.printed_equation = true;
    const dvec3 l = camera.light(), v(0, 0, 1);
    EXPECT_GT(glm::distance(gooch_color(trial.gooch, dvec3(0.5), hit.normal, l, v),
                            gooch_color(printed, dvec3(0.5), hit.normal, l, v)),
              0.01);
}

/// A square turned away is drawn only when both of its sides are, and then shows a normal towards the eye; a mirrored
/// transform moves the side of its front along with its normal.
TEST_P(GoochTest, BackFacesAndMirroredFaces) {
    const Trial trial = trials()[4];
    const glm::quat towards = camera_place().rotation * glm::angleAxis(0.4f, glm::vec3(0.6f, 0.8f, 0));
    const glm::quat away = towards * glm::angleAxis(glm::pi<float>(), glm::vec3(0, 1, 0));
    for (const glm::quat& turn : {towards, away})
        for (const glm::vec3 scale : {glm::vec3(1.4f), glm::vec3(-1.4f, 1.4f, 1.4f), glm::vec3(1.4f, 1.4f, -1.4f)})
            for (const bool double_sided : {false, true}) {
                const bool front = (turn == towards) == (scale.z > 0.0f);
                SCOPED_TRACE(std::string(front ? "front " : "back ") + std::to_string(scale.x) + " " +
                             std::to_string(scale.z) + (double_sided ? " double-sided" : ""));
                const Worst worst =
                    compare(context(), trial,
                            {{CastObject::square, {.rotation = turn, .scale = scale}, {0.7, 0.6, 0.5}, double_sided}});
                EXPECT_LE(worst.color, tolerance);
                EXPECT_LE(worst.normal, tolerance);
                EXPECT_LE(worst.depth, tolerance);
                EXPECT_EQ(worst.wrong_ids, 0);
                EXPECT_EQ(worst.drawn > 4000, front || double_sided);
            }
}

HACHURE_INSTANTIATE_GL_TESTS(GoochTest);

} // namespace
} // namespace hachure::test
