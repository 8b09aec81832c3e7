// Timelines in scene files, as a user has them.

#include <hachure/components/name.h>
#include <hachure/components/name_index.h>
#include <hachure/components/timeline.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/animation/animation.h>
#include <hachure/systems/scene/load_scene.h>
#include <hachure/systems/scene/save_scene.h>
#include <hachure/systems/scene/scene.h>
#include <hachure/systems/timeline/timeline.h>
#include <hachure/systems/transform/transform.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace hachure::test {
namespace {

struct TimelineSceneFileTest : ::testing::Test {
    TimelineSceneFileTest() : folder(std::filesystem::path(testing::TempDir()) / "timeline_scene_file") {
        std::filesystem::create_directories(folder);
        app.add_component<Name>();
        register_transform(app);
        register_animation(app);
        register_scene(app);
        register_timeline(app);
    }

    LoadedScene load(const std::string& text) {
        std::ofstream(folder / "test.scene.json") << text;
        return load_scene(app, folder / "test.scene.json");
    }
    Entity find(const char* path) {
        NameIndex index;
        index.update(app.world());
        return index.find(app.world(), path);
    }
    const Transform& place(const char* path) { return app.world().get<Transform>(find(path)); }

    std::filesystem::path folder;
    App app;
};

TEST_F(TimelineSceneFileTest, MovesSpawnsAndCopies) {
    const LoadedScene scene = load(R"({"hachure_scene": 1, "entities": [
        {"name": "Ship", "timeline": {
            "tracks": [{"target": "transform.translation", "keys": [[0, [0,0,0]], [4, [4,0,0]]]},
                       {"target": "Mast/transform.scale.y", "keys": [[0, 1], [4, 5]]}],
            "actions": [{"at": 1, "spawn": "Buoy", "name": "Second", "parent": "Ship"}]},
         "children": [{"name": "Mast"}]},
        {"name": "Buoy", "transform": {"translation": [1, 2, 3]}, "children": [{"name": "Bell"}]}]})");
    EXPECT_THAT(scene.warnings, testing::IsEmpty());
    app.run_frame(0.5);
    EXPECT_EQ(place("Ship").translation, glm::vec3(0.5f, 0, 0));
    EXPECT_EQ(place("Ship/Mast").scale.y, 1.5f);
    EXPECT_FALSE(find("Second"));
    app.run_frame(1.0);
    EXPECT_EQ(place("Ship/Second").translation, glm::vec3(1, 2, 3));
    EXPECT_TRUE(find("Ship/Second/Bell"));
}

TEST_F(TimelineSceneFileTest, SavingWritesWhatWasRead) {
    const std::string timeline =
        R"({"speed": 2, "tracks": [{"target": "Ship/transform.scale.x", "keys": [[0, 1], [4, 2]]}]})";
    load(R"({"hachure_scene": 1, "entities": [{"name": "Ship", "timeline": )" + timeline + "}]}");
    const auto saved = [&] {
        return nlohmann::json::parse(save_scene(app.world(), app.types(), folder))["entities"][0]["timeline"];
    };
    nlohmann::json wanted = nlohmann::json::parse(timeline);
    EXPECT_EQ(saved(), wanted);
    app.run_frame(0.5);
    wanted["time"] = 1.0;
    EXPECT_EQ(saved(), wanted) << "and how far it has come";
}

TEST_F(TimelineSceneFileTest, FaultsNameFileLineAndColumn) {
    try {
        load("{\"hachure_scene\": 1, \"entities\": [\n {\"name\": \"a\", \"timeline\": {\"tracks\": 3}}]}");
        ADD_FAILURE() << "it was read";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("test.scene.json"));
        EXPECT_THAT(error.what(), testing::HasSubstr("this is no array"));
        EXPECT_THAT(error.what(), testing::HasSubstr("(line 2, column 39: /entities/0/timeline/tracks)"));
    }
}

} // namespace
} // namespace hachure::test
