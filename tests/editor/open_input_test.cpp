#include <hachure/components/abstracted_lines.h>
#include <hachure/components/camera.h>
#include <hachure/components/compose.h>
#include <hachure/components/gooch.h>
#include <hachure/components/light.h>
#include <hachure/components/picture.h>
#include <hachure/components/picture_coat.h>
#include <hachure/components/scene.h>
#include <hachure/components/surface.h>
#include <hachure/editor/open_input.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/scene/spawner.h>
#include <hachure/systems/capabilities.h>
#include <hachure/systems/scene/load_scene.h>
#include <hachure/systems/scene/save_scene.h>
#include <hachure/tests/editor/program.h>

#include <gmock/gmock.h>

namespace hachure::test {
namespace {

class OpenInput : public testing::Test {
protected:
    OpenInput() {
        folder_.write("a.obj", tetrahedron_obj);
        folder_.write("black.json", R"({"hachure_style": 1, "surface": {"gooch": {"b": 0.9}},
                                        "camera": {"compose": {"background": [0, 0, 0]}}})");
    }

    World& open(const std::string& name, const OpenOptions& options = {}) {
        app_ = std::make_unique<App>();
        register_capabilities(*app_);
        open_input(*app_, folder_ / name, {64, 48}, options);
        return app_->world();
    }

    World& open_scene(const std::string& entities, const std::string& more = "", const OpenOptions& options = {}) {
        folder_.write("s.scene.json", "{\"hachure_scene\": 1" + more + ", \"entities\": [" + entities + "]}");
        return open("s.scene.json", options);
    }

    template <class C> static C only(const World& world) {
        EXPECT_EQ(world.query<const C>().count(), 1u);
        return std::get<const C&>(*world.query<const C>().begin());
    }

    TempFolder folder_;
    std::unique_ptr<App> app_;
};

TEST_F(OpenInput, ModelsAndScenesGetACameraALightAndAStyle) {
    const auto expect_all = [](const World& world) {
        EXPECT_EQ(only<Gooch>(world).b, Gooch{}.b);
        EXPECT_TRUE(only<Camera>(world).active);
        EXPECT_EQ(world.query<const Light>().count(), 1u);
        EXPECT_EQ(only<Compose>(world).background, glm::vec3(1));
    };
    expect_all(open("a.obj"));
    expect_all(open_scene(R"({"model": "a.obj"})"));
}

TEST_F(OpenInput, TheStyleAskedForComesBeforeTheScenesOwn) {
    EXPECT_EQ(only<Gooch>(open_scene(R"({"model": "a.obj"})", R"(, "style": "black.json")")).b, 0.9f);
    EXPECT_EQ(only<Compose>(app_->world()).background, glm::vec3(0)) << "the framing camera has it, too";
    EXPECT_EQ(only<Gooch>(open_scene(R"({"model": "a.obj"})", R"(, "style": "black.json")", {"gooch", {}})).b,
              Gooch{}.b);
    EXPECT_EQ(only<Gooch>(open("a.obj", {(folder_ / "black.json").string(), {}})).b, 0.9f);
}

TEST_F(OpenInput, AScenesOwnCameraAndLightStay) {
    World& world = open_scene(R"({"camera": {"yfov": 1}}, {"light": {"intensity": 3}}, {"model": "a.obj"})");
    EXPECT_EQ(only<Camera>(world).yfov, 1.0f);
    EXPECT_EQ(only<Light>(world).intensity, 3.0f);
}

TEST_F(OpenInput, AnEmptySceneIsAScene) {
    EXPECT_EQ(open_scene("").query<const Camera>().count(), 1u);
    EXPECT_TRUE(open_scene("").find_resource<Spawner>());
}

TEST_F(OpenInput, ABareModelCanBeSavedAsAScene) {
    World& world = open("a.obj");
    EXPECT_EQ(save_scene(world, app_->types(), folder_.path()), R"({
  "hachure_scene": 1,
  "style": "gooch",
  "entities": [
    { "model": "a.obj" }
  ]
}
)");
    const Entity copy = world.resource<Spawner>().spawn(world, {.what = "a.obj"});
    EXPECT_EQ(world.query<const Gooch>().count(), 2u) << "what is spawned has the style";
    EXPECT_TRUE(world.alive(copy));
}

TEST_F(OpenInput, AnImageIsASceneOfOnePicture) {
    assets::write_png(folder_ / "photo.png", assets::make_image(6, 4, 3, assets::PixelType::u8));
    World& world = open("photo.png", {.style = "lines", .clip = {}});
    EXPECT_EQ(only<Picture>(world).file, (folder_ / "photo.png").string());
    EXPECT_EQ(only<AbstractedLines>(world), AbstractedLines{});
    EXPECT_TRUE(only<Camera>(world).active);
    EXPECT_EQ(world.query<const Surface>().count(), 0u);
    EXPECT_EQ(save_scene(world, app_->types(), folder_.path()), R"({
  "hachure_scene": 1,
  "style": "lines",
  "entities": [
    { "name": "photo", "picture": { "file": "photo.png" } }
  ]
}
)");
    EXPECT_EQ(picture_size(folder_ / "photo.png"), (Canvas{6, 4}));
    EXPECT_EQ(open("photo.png").resource<SceneDocument>().style, "lines");
}

TEST_F(OpenInput, NumberedImagesAreOnePicture) {
    for (const char* name : {"shot_03.png", "shot_05.png"})
        assets::write_png(folder_ / name, assets::make_image(6, 4, 3, assets::PixelType::u8));
    World& world = open("shot_##.png");
    EXPECT_EQ(only<Picture>(world).file, (folder_ / "shot_##.png").string());
    EXPECT_THAT(save_scene(world, app_->types(), folder_.path()),
                testing::HasSubstr(R"({ "name": "shot", "picture": { "file": "shot_##.png" } })"));
    EXPECT_EQ(picture_size(folder_ / "shot_##.png"), (Canvas{6, 4}));
}

TEST_F(OpenInput, PicturesOfAScenesFileAreSavedAsTheyWere) {
    assets::write_png(folder_ / "photo.png", assets::make_image(6, 4, 3, assets::PixelType::u8));
    const std::string entity =
        R"({ "name": "A", "picture": { "file": "photo.png", "fit": "cover" }, "picture_coat": { "show": "tone" } })";
    World& world = open_scene(entity, R"(, "style": "lines")");
    EXPECT_THAT(save_scene(world, app_->types(), folder_.path()),
                testing::AllOf(testing::HasSubstr(R"("fit": "cover")"), testing::HasSubstr(R"("show": "tone")"),
                               testing::Not(testing::HasSubstr("abstracted_lines"))))
        << "what the style gives is not said again";
}

} // namespace
} // namespace hachure::test
