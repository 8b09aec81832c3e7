#include <hachure/runtime/assets/read_model.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/styles/style.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/picture_compare.h>

#include <algorithm>
#include <filesystem>

// Real models in the built-in style: EGL and OSMesa agree, and something is drawn. No picture of them is kept.
namespace hachure::test {
namespace {

constexpr Canvas model_canvas{256, 192};

assets::Image draw_model(gpu::Context& context, const assets::Model& model) {
    DrawnScene scene(context, model_canvas);
    const SpawnedModel spawned = spawn_model(scene.world(), model);
    if (spawned.cameras.empty()) spawn_framing_camera(scene.world(), spawned.points, model_canvas);
    if (spawned.lights.empty()) spawn_default_light(scene.world());
    apply_style(scene.world(), scene.app().types(), find_style(scene.app().types(), "gooch"));
    return scene.draw();
}

void expect_alike(const std::filesystem::path& file) {
    SCOPED_TRACE(file.string());
    std::string reason;
    gpu::Context* egl = GlContexts::use(gpu::Backend::egl, reason);
    if (!egl) GTEST_SKIP() << "no EGL context: " << reason;
    const assets::Model model = assets::read_model(file);
    const assets::Image on_egl = draw_model(*egl, model);
    gpu::Context* osmesa = GlContexts::use(gpu::Backend::osmesa, reason);
    if (!osmesa) GTEST_SKIP() << "no OSMesa context: " << reason;
    EXPECT_TRUE(same_driver_gate(on_egl, draw_model(*osmesa, model)));
    const std::uint8_t* bytes = on_egl.u8();
    const auto drawn = std::count_if(bytes, bytes + model_canvas.width * model_canvas.height * 3,
                                     [](std::uint8_t v) { return v != 255; });
    EXPECT_GT(drawn, model_canvas.width * model_canvas.height / 10) << "next to nothing is drawn";
    EXPECT_TRUE(std::any_of(bytes, bytes + model_canvas.width * model_canvas.height * 3, [](std::uint8_t v) {
        return v < 16;
    })) << "no line is drawn";
}

TEST(Models, BunnyIsAlikeOnEglAndOsMesa) {
    const std::filesystem::path bunny = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(bunny)) GTEST_SKIP() << bunny << " is not there (Debian's glmark2-data)";
    expect_alike(bunny);
}

class GivenModels : public GivenModelTest {};

TEST_P(GivenModels, AreAlikeOnEglAndOsMesa) { expect_alike(file()); }

INSTANTIATE_TEST_SUITE_P(Folder, GivenModels,
                         ::testing::Values("characters/khronos/Fox.glb", "characters/khronos/CesiumMan.glb",
                                           "characters/quaternius/Frog.gltf", "mechanical/CesiumMilkTruck.glb",
                                           "mechanical/cannon.glb", "mechanical/wingnut.obj",
                                           "mechanical/trimesh/plate_holes.STL",
                                           "mechanical/trimesh/octagonal_pocket.ply", "meshes/Suzanne/Suzanne.gltf",
                                           "meshes/spot.obj"),
                         given_model_name);

} // namespace
} // namespace hachure::test
