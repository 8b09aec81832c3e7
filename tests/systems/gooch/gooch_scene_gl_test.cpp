#include <hachure/systems/styles/style.h>

#include <cmath>
#include <set>
#include <string>

#include "gooch_scene.h"

// Parameters of one object and of the scene, who follows which, and what of a frame their changes run; object colours
// from textures and vertices.
namespace hachure::test {
namespace {

using gpu::PassState;

using GoochSceneTest = GlTest;

std::set<std::string> passes_run(DrawnScene& scene) {
    std::set<std::string> names;
    for (const auto& [name, state] : scene.draw_passes())
        if (state == PassState::run) names.insert(name);
    return names;
}

const std::set<std::string> none;

TEST_P(GoochSceneTest, FollowersTakeTheCamerasFieldsAndTheOthersKeepTheirOwn) {
    GoochScene scene(context(), both_projections()[0]);
    World& world = scene.scene.world();
    Gooch own = figure_7(), following = figure_7();
    following.parameters = GoochParameters::scene;
    world.get_mutable<Gooch>(scene.entities[0]) = own;
    world.get_mutable<Gooch>(scene.entities[1]) = following;
    world.get_mutable<Gooch>(scene.entities[2]) = following;
    const auto expect = [&](const Gooch& for_followers) {
        const auto worst =
            scene.compare([&](const CastObject& object, const Hit& hit, const dvec3&, const dvec3& to_eye) {
                return gooch_color(hit.object == 1 ? own : for_followers, object.color, hit.normal,
                                   scene.camera.light(), to_eye);
            });
        EXPECT_LE(worst.error, 1e-3);
        EXPECT_GT(worst.drawn, 10'000);
    };
    expect(figure_7()); // the camera says nothing
    world.add(scene.eye, figure_8());
    expect(figure_8());
    world.get_mutable<Gooch>(scene.eye).printed_equation = true;
    Gooch printed = figure_8();
    printed.printed_equation = true;
    expect(printed);
    // The mode is one of the fields.
    world.get_mutable<Gooch>(scene.eye) = {.shading = GoochShading::phong, .highlight = 0.0f, .diffuse = 0.7f};
    const auto phong = scene.compare([&](const CastObject& object, const Hit& hit, const dvec3&, const dvec3& to_eye) {
        if (hit.object == 1) return gooch_color(own, object.color, hit.normal, scene.camera.light(), to_eye);
        return phong_color(world.get<Gooch>(scene.eye), object.color, hit.normal, to_eye,
                           {{scene.camera.light(), 1.0, dvec3(1.0)}});
    });
    EXPECT_LE(phong.error, 1e-3);
    world.remove<Gooch>(scene.eye);
    expect(figure_7());
    // Another camera has another Gooch.
    world.get_mutable<Camera>(scene.eye).active = false;
    const Entity other = scene.scene.add(both_projections()[0], tilted_camera());
    world.add(other, figure_8());
    expect(figure_8());
}

TEST_P(GoochSceneTest, ChangesRunThePassesOfThoseWhoFollow) {
    GoochScene scene(context(), both_projections()[0]);
    World& world = scene.scene.world();
    world.add(scene.eye, figure_8());
    scene.draw();
    EXPECT_EQ(passes_run(scene.scene), none);
    world.get_mutable<Gooch>(scene.eye).b = 0.1f;
    EXPECT_EQ(passes_run(scene.scene), none) << "nobody follows";
    world.get_mutable<Gooch>(scene.entities[1]).parameters = GoochParameters::scene;
    EXPECT_EQ(passes_run(scene.scene).count("gooch"), 1u);
    EXPECT_EQ(passes_run(scene.scene), none);
    world.get_mutable<Gooch>(scene.eye).b = 0.2f;
    EXPECT_EQ(passes_run(scene.scene).count("gooch"), 1u);
    static_cast<void>(world.get_mutable<Gooch>(scene.eye));
    EXPECT_EQ(passes_run(scene.scene), none) << "written, and the same";
    world.get_mutable<Gooch>(scene.entities[1]).b = 0.9f;
    EXPECT_EQ(passes_run(scene.scene), none) << "it does not count while it follows";
    world.remove<Gooch>(scene.eye);
    EXPECT_EQ(passes_run(scene.scene).count("gooch"), 1u);
}

TEST_P(GoochSceneTest, AStyleGivesTheSceneItsParameters) {
    GoochScene scene(context(), both_projections()[0]);
    const TypeRegistry& types = scene.scene.app().types();
    apply_style(scene.scene.world(), types, parse_style(types, "mine.json", R"({"hachure_style": 1,
        "surface": {"gooch": {"parameters": "scene"}},
        "camera": {"gooch": {"b": 0.55, "y": 0.3, "alpha": 0.25, "beta": 0.5, "highlight": 0}}})"));
    const auto worst = scene.compare([&](const CastObject& object, const Hit& hit, const dvec3&, const dvec3& to_eye) {
        return gooch_color(figure_8(), object.color, hit.normal, scene.camera.light(), to_eye);
    });
    EXPECT_LE(worst.error, 1e-3);
}

double linear(std::uint8_t encoded) {
    const double s = encoded / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// k_d is texture times material times vertex colour times tint, in every mode.
TEST_P(GoochSceneTest, ObjectColourIsTextureMaterialVerticesAndTint) {
    constexpr int side = 60; // pixels; 15 a texel, so that each texel's centre is a pixel's
    SurfaceTexture texture;
    texture.image = assets::make_image(4, 4, 3, assets::PixelType::u8);
    for (int i = 0; i < 48; ++i) texture.image.u8()[i] = static_cast<std::uint8_t>((i * 89 + 31) % 256);
    SurfaceMaterial material;
    material.base_color = {0.9f, 0.8f, 0.7f, 1.0f};
    material.base_color_texture = 0;
    SurfaceMesh mesh = surface_mesh({.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                                     .normals = {4, glm::normalize(glm::vec3(0.4f, 0.3f, 1.0f))},
                                     .texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}},
                                     .indices = {0, 1, 2, 0, 2, 3}},
                                    material);
    mesh.colors.assign(4, {0.6f, 0.9f, 0.8f, 1.0f});
    DrawnScene scene(context(), {side, side});
    static_cast<void>(scene.world().resource_mutable<MeshStore>().add(texture));
    const Entity entity = scene.add(std::move(mesh));
    scene.world().get_mutable<Surface>(entity).tint = {0.5f, 1.0f, 0.75f};
    scene.add(Camera{.projection = Projection::orthographic, .ymag = 1.0f, .zfar = 10.0f}, {.translation = {0, 0, 2}});
    scene.renderer().request_aov("color");
    const dvec3 n = glm::normalize(dvec3(0.4, 0.3, 1.0)), l = glm::normalize(dvec3(1, 1, 0)), to_eye(0, 0, 1);
    for (const GoochShading shading :
         {GoochShading::tone, GoochShading::two_lights, GoochShading::two_lights_per_vertex, GoochShading::phong}) {
        Gooch gooch = figure_7();
        gooch.shading = shading;
        scene.world().add(entity, gooch);
        scene.renderer().render_frame();
        const assets::Image image = scene.renderer().read_aov("color");
        for (int texel = 0; texel < 16; ++texel) {
            const std::uint8_t* bytes = texture.image.u8() + 3 * texel;
            const dvec3 k_d = dvec3(linear(bytes[0]), linear(bytes[1]), linear(bytes[2])) * dvec3(0.9, 0.8, 0.7) *
                              dvec3(0.6, 0.9, 0.8) * dvec3(0.5, 1.0, 0.75);
            const dvec3 expected = shading == GoochShading::phong
                                       ? phong_color(gooch, k_d, n, to_eye, {{l, 1.0, dvec3(1.0)}})
                                       : gooch_color(gooch, k_d, n, l, to_eye);
            const float* drawn = image.f32() + 3 * ((texel / 4 * 15 + 7) * side + texel % 4 * 15 + 7);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c], expected[c], 1e-3) << texel << " " << int(shading);
        }
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(GoochSceneTest);

} // namespace
} // namespace hachure::test
