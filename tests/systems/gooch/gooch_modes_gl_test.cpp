#include <cmath>
#include <string>

#include "gooch_scene.h"

// The modes of Gooch on whole shapes: tones, their approximation by two lights (section 4.4), and equation 1.
namespace hachure::test {
namespace {

constexpr double mode_tolerance = 1e-3;

using GoochModesTest = GlTest;

Gooch with(Gooch gooch, GoochShading shading) {
    gooch.shading = shading;
    return gooch;
}

void expect_exact(const GoochScene::Worst& worst) {
    EXPECT_LE(worst.error, mode_tolerance);
    EXPECT_GT(worst.checked, 35'000); // of 49,152
    EXPECT_GT(worst.drawn, 10'000);
}

TEST_P(GoochModesTest, TonesOfFigures7And8AreExactOnSphereCylinderAndTorus) {
    for (const Camera& view : both_projections()) {
        GoochScene scene(context(), view);
        Gooch printed = figure_8(), shiny = figure_7();
        printed.printed_equation = true;
        shiny.highlight = 0.8f;
        const std::vector<std::pair<const char*, Gooch>> looks = {
            {"figure 7", figure_7()}, {"figure 8", figure_8()}, {"equation as printed", printed}, {"highlight", shiny}};
        for (const auto& [name, gooch] : looks) {
            SCOPED_TRACE(std::string(name) + (view.projection == Projection::perspective ? ", perspective" : ""));
            scene.set(gooch);
            const auto worst = scene.compare(
                [&, &look = gooch](const CastObject& object, const Hit& hit, const dvec3&, const dvec3& to_eye) {
                    return gooch_color(look, object.color, hit.normal, scene.camera.light(), to_eye);
                });
            expect_exact(worst);
            std::printf("%s: %.2e\n", name, worst.error);
        }
    }
}

/// "We can approximate Equation 2 by two lights": per pixel, and while negative colours survive, it is equation 2.
TEST_P(GoochModesTest, TwoLightsPerPixelAreEquation2) {
    for (const Camera& view : both_projections()) {
        GoochScene scene(context(), view);
        for (const Gooch& figure : {figure_7(), figure_8()}) {
            Gooch gooch = with(figure, GoochShading::two_lights);
            gooch.highlight = 0.8f; // section 4.4 turns it off
            scene.set(gooch);
            const auto worst =
                scene.compare([&](const CastObject& object, const Hit& hit, const dvec3&, const dvec3& to_eye) {
                    return gooch_color(figure, object.color, hit.normal, scene.camera.light(), to_eye);
                });
            expect_exact(worst);
            std::printf("two lights: %.2e\n", worst.error);
        }
    }
}

/// A pipeline without negative light errs by up to half of what warm and cool differ: .40 in red and green of white,
/// where the light comes from behind.
TEST_P(GoochModesTest, ClampedLightsShowTheArtefact) {
    GoochScene scene(context(), both_projections()[0]);
    const glm::quat behind = tilted_camera().rotation * glm::angleAxis(glm::pi<float>(), glm::vec3(0, 1, 0));
    scene.scene.world().create_with(Transform{.rotation = behind}, Light{});
    const dvec3 l = -scene.camera.axis();
    Gooch gooch = with(figure_7(), GoochShading::two_lights);
    gooch.clamp_lights = true;
    scene.set(gooch);
    expect_exact(scene.compare([&](const CastObject& object, const Hit& hit, const dvec3&, const dvec3&) {
        return two_light_color(gooch, object.color, hit.normal, l);
    }));
    const auto off = scene.compare([&](const CastObject& object, const Hit& hit, const dvec3&, const dvec3& to_eye) {
        return gooch_color(figure_7(), object.color, hit.normal, l, to_eye);
    });
    EXPECT_NEAR(off.error, 0.40, 0.005);
    std::printf("clamped: off by %.3f\n", off.error);
}

/// Figure 5's: k_d = .5, k_a = .1; and with a highlight.
TEST_P(GoochModesTest, PhongIsEquation1) {
    for (const Camera& view : both_projections()) {
        GoochScene scene(context(), view);
        for (const float highlight : {0.0f, 0.7f}) {
            Gooch gooch = with({}, GoochShading::phong);
            gooch.ambient = 0.1f;
            gooch.diffuse = 0.5f;
            gooch.highlight = highlight;
            scene.set(gooch);
            expect_exact(scene.compare([&](const CastObject& object, const Hit& hit, const dvec3&,
                                           const dvec3& to_eye) {
                return phong_color(gooch, object.color, hit.normal, to_eye, {{scene.camera.light(), 1.0, dvec3(1.0)}});
            }));
        }
    }
}

/// Straight at the side of a smooth-shaded prism whose edges turn the normal by D, a facet towards the light.
class Prism {
public:
    static constexpr Canvas canvas{160, 120};

    Prism(gpu::Context& context, std::uint32_t sides) : scene_(context, canvas) {
        const auto step = 2.0f * glm::pi<float>() / static_cast<float>(sides);
        prism_ = scene_.add(surface_mesh(geometry::cylinder(1.0, 2.0, sides)));
        scene_.world().add(prism_, Gooch{});
        // Looks at the middle of the facet between the first two vertices, in whose direction the light is, too.
        const geometry::Shape shape = geometry::cylinder(1.0, 2.0, sides);
        const glm::vec3 towards = glm::angleAxis(0.5f * step, glm::vec3(0, 1, 0)) *
                                  glm::normalize(glm::vec3(shape.normals[0].x, 0.0f, shape.normals[0].z));
        const glm::quat turn = glm::angleAxis(std::atan2(towards.x, towards.z), glm::vec3(0, 1, 0));
        scene_.add(Camera{.projection = Projection::orthographic, .ymag = 0.8f, .zfar = 10.0f},
                   {.translation = 4.0f * towards, .rotation = turn});
        scene_.world().create_with(Transform{.rotation = turn}, Light{});
        scene_.renderer().request_aov("color");
    }

    assets::Image draw(const Gooch& gooch) {
        scene_.world().get_mutable<Gooch>(prism_) = gooch;
        scene_.renderer().render_frame();
        return scene_.renderer().read_aov("color");
    }

private:
    DrawnScene scene_;
    Entity prism_;
};

/// Lighting vertices errs by (1 - cos(D/2))/2 of what warm and cool differ, in the middle of an edge at which the
/// normal turns by D, on the side of the light (readings of section 4.4: .0019 for 10 degrees, .0076 for 20, .038 for
/// 45).
TEST_P(GoochModesTest, LightPerVertexErrsAsTheAngleBetweenVerticesSays) {
    const double apart = 0.8; // k_warm - k_cool of white, figure 7, in red and green; 0 in blue
    for (const std::uint32_t sides : {36u, 18u, 8u}) {
        Prism prism(context(), sides);
        const double predicted = 0.5 * (1.0 - std::cos(glm::pi<double>() / sides)) * apart;
        const assets::Image exact = prism.draw(figure_7());
        EXPECT_LE(difference(prism.draw(with(figure_7(), GoochShading::two_lights)), exact), 1e-6);
        const double measured = difference(prism.draw(with(figure_7(), GoochShading::two_lights_per_vertex)), exact);
        std::printf("%3.0f degrees: measured %.5f, predicted %.5f\n", 360.0 / sides, measured, predicted);
        EXPECT_NEAR(measured / predicted, 1.0, 0.1);
    }
}

TEST_P(GoochModesTest, PhongPerVertexErrsLikewise) {
    Gooch matt = with({}, GoochShading::phong);
    matt.highlight = 0.0f;
    Prism prism(context(), 18);
    const assets::Image exact = prism.draw(matt);
    const double measured = difference(prism.draw(with(matt, GoochShading::phong_per_vertex)), exact);
    EXPECT_NEAR(measured / (1.0 - std::cos(glm::pi<double>() / 18)), 1.0, 0.1);
    matt.highlight = 1.0f;
    const assets::Image shiny = prism.draw(matt);
    EXPECT_GT(difference(prism.draw(with(matt, GoochShading::phong_per_vertex)), shiny), 0.1)
        << "highlights between vertices are lost, as is well known";
}

/// Lit at the vertices, both sides of a surface that is seen from both are lit for themselves.
TEST_P(GoochModesTest, VertexLightIsRightOnBothSidesAndMirrored) {
    geometry::Shape square = {.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                              .normals = {4, {0, 0, 1}},
                              .indices = {0, 1, 2, 0, 2, 3}};
    for (const bool double_sided : {false, true}) {
        DrawnScene scene(context(), {64, 64});
        SurfaceMaterial material;
        material.double_sided = double_sided;
        const Entity entity = scene.add(surface_mesh(square, material));
        scene.world().add(entity, Gooch{});
        scene.add(Camera{}, {.translation = {0, 0, 5}});
        scene.renderer().request_aov("color");
        const auto draw = [&](GoochShading shading) {
            scene.world().get_mutable<Gooch>(entity) = with(figure_7(), shading);
            scene.renderer().render_frame();
            return scene.renderer().read_aov("color");
        };
        for (const glm::vec3 scale : {glm::vec3(1.0f), glm::vec3(-1, 1, 1), glm::vec3(1, 1, -1)})
            for (const float turn : {0.3f, 2.8f}) {
                scene.world().get_mutable<Transform>(entity) = {
                    .rotation = glm::angleAxis(turn, glm::normalize(glm::vec3(0.2f, 1, 0))), .scale = scale};
                SCOPED_TRACE(std::to_string(scale.x) + " " + std::to_string(scale.z) + " " + std::to_string(turn));
                EXPECT_LE(difference(draw(GoochShading::two_lights), draw(GoochShading::two_lights_per_vertex)), 1e-5);
                EXPECT_LE(difference(draw(GoochShading::phong), draw(GoochShading::phong_per_vertex)), 1e-5);
            }
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(GoochModesTest);

} // namespace
} // namespace hachure::test
