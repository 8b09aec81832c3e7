#include <hachure/tests/editor/forked_command.h>
#include <hachure/tests/editor/program.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace hachure::test {
namespace {

using testing::HasSubstr;

constexpr const char* good_scene = R"({"hachure_scene": 1, "entities": [{"name": "A", "model": "a.obj"}]})";

TEST(Validate, TheScenesOfTheSamplesAreRight) {
    const std::filesystem::path samples = HACHURE_SOURCE_DIR "/samples";
    std::vector<std::string> arguments{"validate"};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(samples))
        if (entry.path().filename().string().ends_with(".scene.json")) arguments.push_back(entry.path().string());
    ASSERT_GE(arguments.size(), 3u);
    const ProcessResult result = forked_command(arguments);
    EXPECT_TRUE(succeeded(result)) << result.out;
    EXPECT_THAT(result.out, HasSubstr(" 0 faults, 0 warnings\n")) << result.out;
}

TEST(Validate, TellsEveryFaultWithItsPlace) {
    const TempFolder folder;
    folder.write("a.obj", tetrahedron_obj);
    folder.write("good.scene.json", good_scene);
    folder.write("bad.scene.json", "{\"hachure_scene\": 1,\n \"entities\": [{\"gooch\": {\"b\": 2, \"y\": 3}},\n"
                                   "  {\"model\": \"none.obj\"}, {\"zork\": 1}]}");
    folder.write("bad.json",
                 "{\"hachure_style\": 1,\n \"surface\": {\"gooch\": {\"b\": 2, \"zap\": 1}, \"none\": {}}}");
    const ProcessResult result =
        forked_command({"validate", "good.scene.json", "bad.scene.json", "bad.json"}, folder.path());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out,
              "fault: bad.scene.json: none.obj: there is no such file (line 3, column 13: /entities/1/model)\n"
              "fault: bad.scene.json: gooch.b: 2 is outside [0, 1] (line 2, column 31: /entities/0/gooch/b)\n"
              "fault: bad.scene.json: gooch.y: 3 is outside [0, 1] (line 2, column 39: /entities/0/gooch/y)\n"
              "warning: bad.scene.json: there is no component 'zork' (line 3, column 35: /entities/2/zork)\n"
              "fault: bad.json: gooch.b: 2 is outside [0, 1] (line 2, column 30: /surface/gooch/b)\n"
              "fault: bad.json: component 'gooch' has no field 'zap' (line 2, column 40: /surface/gooch/zap)\n"
              "fault: bad.json: there is no component 'none' (line 2, column 52: /surface/none)\n"
              "3 files, 6 faults, 1 warning\n");
}

TEST(Validate, OtherFilesAreFaultsOrModels) {
    const TempFolder folder;
    folder.write("a.obj", tetrahedron_obj);
    folder.write("a.txt", "x");
    folder.write("broken.scene.json", "{\"hachure_scene\": 1,");
    EXPECT_EQ(forked_command({"validate", "a.obj"}, folder.path()).out, "1 file, 0 faults, 0 warnings\n");
    for (const char* name : {"a.txt", "none.scene.json", "broken.scene.json", "none.json"}) {
        const ProcessResult result = forked_command({"validate", name}, folder.path());
        EXPECT_EQ(result.exit_code, 1) << name;
        EXPECT_THAT(result.out, testing::AllOf(HasSubstr(name), HasSubstr("1 file, 1 fault, "))) << name;
    }
    EXPECT_EQ(forked_command({"validate"}, folder.path()).exit_code, 2);
}

TEST(ListSchema, SaysOfEveryFieldWhatItMayBe) {
    const TempFolder folder;
    const ProcessResult result = forked_command({"list", "schema"}, folder.path());
    ASSERT_TRUE(succeeded(result));
    const auto schema = nlohmann::json::parse(result.out);
    EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    const nlohmann::json& components = schema["$defs"]["components"];
    const nlohmann::json& b = components["gooch"]["properties"]["b"];
    EXPECT_EQ(b["type"], "number");
    EXPECT_EQ(b["minimum"], 0.0);
    EXPECT_EQ(b["maximum"], 1.0);
    EXPECT_EQ(b["default"], 0.4);
    EXPECT_EQ(b["description"], "blue of the cool tone");
    EXPECT_EQ(components["camera"]["properties"]["projection"]["enum"],
              (nlohmann::json{"perspective", "orthographic"}));
    EXPECT_EQ(components["transform"]["properties"]["rotation"]["minItems"], 4);
    const nlohmann::json& keys = schema["$defs"]["entity"]["properties"];
    for (const char* key : {"name", "model", "scene", "look", "overrides", "children", "below", "transform", "gooch"})
        EXPECT_TRUE(keys.contains(key)) << key;
    EXPECT_EQ(keys["gooch"]["$ref"], "#/$defs/components/gooch");
}

TEST(InfoOfAScene, TellsWhatIsInIt) {
    const TempFolder folder;
    const ProcessResult result = forked_command({"info", HACHURE_SOURCE_DIR "/samples/scenes/shapes.scene.json"});
    ASSERT_TRUE(succeeded(result));
    for (const char* row : {"kind           scene\n", "style          gooch\n", "scenes         2: tower.scene.json\n",
                            "models         7: die.obj\n", "surfaces       7 of 84 triangles\n", "cameras        1\n",
                            "lights         1\n", "looks          2: bold, plain\n"})
        EXPECT_THAT(result.out, HasSubstr(row));
    folder.write("bad.scene.json", R"({"hachure_scene": 1, "entities": 3})");
    EXPECT_TRUE(failed(forked_command({"info", "bad.scene.json"}, folder.path()), 1,
                       "bad.scene.json: the entities are a list (line 1, column 34: /entities)"));
}

TEST(RenderOfAScene, DrawsIt) {
    const TempFolder folder;
    folder.write("a.obj", tetrahedron_obj);
    folder.write("good.scene.json", good_scene);
    EXPECT_TRUE(succeeded(hachure_program(folder, {"render", "a.obj", "-o", "model.png", "--size", "64x48"})));
    EXPECT_TRUE(
        succeeded(hachure_program(folder, {"render", "good.scene.json", "-o", "scene.png", "--size", "64x48"})));
    EXPECT_TRUE(file_text(folder / "model.png") == file_text(folder / "scene.png"))
        << "a scene of one model looks like the model";
    folder.write("bad.scene.json", R"({"hachure_scene": 1, "entities": [{"gooch": {"b": 7}}]})");
    EXPECT_TRUE(failed(hachure_program(folder, {"render", "bad.scene.json", "-o", "bad.png"}), 1,
                       "bad.scene.json: gooch.b: 7 is outside [0, 1] (line 1, column 51: /entities/0/gooch/b)"));
    EXPECT_TRUE(failed(hachure_program(folder, {"render", "good.scene.json", "-o", "x.png", "--clip", "Run"}), 1,
                       "--clip is for models"));
    EXPECT_FALSE(std::filesystem::exists(folder / "x.png"));
}

} // namespace
} // namespace hachure::test
