#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/picture_compare.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <set>
#include <string>

// Pictures that are kept: a still life, and sweeps of one parameter at a time. They are renewed with
// HACHURE_UPDATE_GOLDENS=1 on the EGL back end; look at every one of them before it is committed.
namespace hachure::test {
namespace {

constexpr Canvas scene_canvas{256, 192};

/// What all objects of the still life carry.
struct Look {
    Gooch gooch;
    EdgeLines lines;
};

SurfaceMaterial colored(glm::vec3 color) {
    SurfaceMaterial material;
    material.base_color = glm::vec4(color, 1.0f);
    return material;
}

/// Sphere, torus, cube and cylinder on a square, from a little above.
assets::Image draw_still_life(gpu::Context& context, const Look& look) {
    DrawnScene scene(context, scene_canvas);
    const auto turned = [](float angle, glm::vec3 axis) { return glm::angleAxis(angle, glm::normalize(axis)); };
    const std::vector<Entity> objects = {
        scene.add(surface_mesh(geometry::plane(5.0, 1), colored({0.7f, 0.7f, 0.7f}))),
        scene.add(surface_mesh(geometry::icosphere(0.7, 4), colored({0.8f, 0.2f, 0.2f})),
                  {.translation = {-1.2f, 0.7f, 0.3f}}),
        scene.add(surface_mesh(geometry::torus(0.6, 0.22, 64, 32), colored({0.2f, 0.7f, 0.3f})),
                  {.translation = {0.5f, 0.22f, 1.3f}}),
        scene.add(surface_mesh(geometry::cube(1.1), colored({0.3f, 0.4f, 0.9f})),
                  {.translation = {0.2f, 0.55f, -0.9f}, .rotation = turned(0.5f, {0, 1, 0})}),
        scene.add(surface_mesh(geometry::cylinder(0.45, 1.5, 48), colored({0.9f, 0.8f, 0.3f})),
                  {.translation = {1.5f, 0.75f, 0.1f}})};
    for (const Entity object : objects) {
        scene.world().add(object, look.gooch);
        scene.world().add(object, look.lines);
    }
    const glm::quat turn = turned(0.35f, {0, 1, 0}) * turned(-0.45f, {1, 0, 0});
    scene.add(Camera{.yfov = 0.6f},
              {.translation = glm::vec3(0, 0.5f, 0) + turn * glm::vec3(0, 0, 7), .rotation = turn});
    spawn_default_light(scene.world());
    return scene.draw();
}

struct Picture {
    std::string name;
    Look look;
};

std::vector<Picture> pictures() {
    std::vector<Picture> result = {{"still_life", {}}};
    const auto sweep = [&](const char* name, std::initializer_list<float> values,
                           const std::function<void(Look&, float)>& set) {
        for (const float value : values) {
            Look look;
            set(look, value);
            result.push_back(
                {std::string(name) + "_" + std::to_string(static_cast<int>(std::lround(100 * value))), look});
        }
    };
    sweep("b", {0.0f, 0.2f, 0.8f}, [](Look& look, float value) { look.gooch.b = value; });
    sweep("y", {0.0f, 0.2f, 0.8f}, [](Look& look, float value) { look.gooch.y = value; });
    sweep("alpha", {0.0f, 0.5f, 1.0f}, [](Look& look, float value) { look.gooch.alpha = value; });
    sweep("beta", {0.0f, 0.3f, 1.0f}, [](Look& look, float value) { look.gooch.beta = value; });
    sweep("highlight", {0.0f, 0.4f, 1.0f}, [](Look& look, float value) { look.gooch.highlight = value; });
    sweep("width", {0.5f, 1.0f, 5.0f}, [](Look& look, float value) { look.lines.width = value; });
    sweep("crease_angle", {0.05f, 0.12f, 1.7f}, [](Look& look, float value) { look.lines.crease_angle = value; });
    Look printed;
    printed.gooch.printed_equation = true;
    result.push_back({"printed_equation", printed});
    return result;
}

std::filesystem::path golden_file(const std::string& name) {
    return std::filesystem::path(HACHURE_SOURCE_DIR) / "tests/golden/images" / (name + ".png");
}

bool updating() { return std::getenv("HACHURE_UPDATE_GOLDENS") != nullptr; }

using GoldenTest = GlTest;

TEST_P(GoldenTest, PicturesAreAsKept) {
    for (const Picture& picture : pictures()) {
        SCOPED_TRACE(picture.name);
        const assets::Image drawn = draw_still_life(context(), picture.look);
        const std::filesystem::path file = golden_file(picture.name);
        if (updating() && GetParam() == gpu::Backend::egl) assets::write_png(file, drawn);
        EXPECT_TRUE(same_driver_gate(assets::read_image(file), drawn));
        EXPECT_LT(std::filesystem::file_size(file), 30'000u);
    }
}

/// Each kept picture is told from the one with the default look: no gate is so wide that a sweep shows nothing.
TEST(GoldenSweep, EveryParameterIsSeen) {
    const assets::Image still_life = assets::read_image(golden_file("still_life"));
    for (const Picture& picture : pictures()) {
        if (picture.name == "still_life") continue;
        EXPECT_FALSE(same_driver_gate(still_life, assets::read_image(golden_file(picture.name)))) << picture.name;
    }
}

/// No picture is kept that no test draws.
TEST(GoldenFolder, HoldsNothingElse) {
    std::set<std::string> known;
    for (const Picture& picture : pictures()) known.insert(picture.name + ".png");
    for (const auto& entry : std::filesystem::directory_iterator(golden_file("still_life").parent_path()))
        EXPECT_TRUE(known.contains(entry.path().filename().string())) << entry.path();
}

HACHURE_INSTANTIATE_GL_TESTS(GoldenTest);

} // namespace
} // namespace hachure::test
