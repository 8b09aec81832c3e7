#include <hachure/runtime/assets/gltf.h>
#include <hachure/runtime/assets/gltf_write.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/editor/forked_command.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/support/glb_file.h>
#include <hachure/tests/support/model_difference.h>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <set>

namespace hachure::test {
namespace {

using nlohmann::json;

class Convert : public testing::Test {
protected:
    void SetUp() override {
        folder.write("squares.glb", two_squares_glb());
        folder.write("tetra.obj", tetrahedron_obj);
        assets::Model arm = arm_model();
        arm.nodes[0].extras = R"({"gooch":{"b":0.9,"y":0.1}})";
        arm.scenes[0].extras = R"({"animation":{"clip":"bend","offset":0.5}})";
        assets::write_gltf(arm, folder / "arm.glb");
    }

    ProcessResult run(std::vector<std::string> arguments) {
        return forked_command(std::move(arguments), folder.path());
    }

    ProcessResult convert(const std::string& input, const std::string& output) {
        return run({"convert", input, "-o", output});
    }

    /// The picture that a file makes, with or without what moves.
    assets::Image picture(const std::string& input, bool moving = false) {
        std::vector<std::string> arguments{"render", input, "-o", "out.png", "--size", "96x64"};
        if (moving) arguments.insert(arguments.end(), {"--time", "0.25"});
        const ProcessResult result = run(arguments);
        EXPECT_EQ(result.exit_code, 0) << input << ": " << result.err;
        return assets::read_image(folder / "out.png");
    }

    json document(const std::string& file) { return json::parse(std::ifstream(folder / file)); }

    TempFolder folder;
};

/// Places of skinned vertices are rounded in the model's space, which is another when models are merged.
testing::AssertionResult alike(const assets::Image& a, const assets::Image& b) {
    if (a.width != b.width || a.height != b.height || a.channels != b.channels)
        return testing::AssertionFailure() << "sizes differ";
    const auto bytes = static_cast<std::size_t>(a.width * a.height * a.channels);
    int largest = 0;
    std::set<std::uint8_t> tones;
    for (std::size_t i = 0; i < bytes; ++i) {
        largest = std::max(largest, std::abs(a.u8()[i] - b.u8()[i]));
        tones.insert(a.u8()[i]);
    }
    if (tones.size() < 4) return testing::AssertionFailure() << "there is nothing in the picture";
    if (largest > 2) return testing::AssertionFailure() << "tones differ by " << largest << " of 255";
    return testing::AssertionSuccess();
}

constexpr const char* scene_of_all = R"({
  "hachure_scene": 1, "style": "gooch",
  "looks": {"blue": {"gooch": {"b": 0.9}, "edge_lines": {"width": 4}}},
  "entities": [
    {"name": "Left", "model": "arm.glb", "transform": {"translation": [-1.5, 0, 0]}, "look": "blue",
     "animation": {"clip": "bend", "offset": 0.5}},
    {"name": "Right", "model": "arm.glb", "transform": {"translation": [1.5, 0, 0]}, "animation": null,
     "overrides": {"elbow": {"transform": {"rotation": [0, 0, 0.70710678, 0.70710678]}}}},
    {"name": "Solid", "model": "tetra.obj", "transform": {"scale": [0.4, 0.4, 0.4]}, "look": "blue",
     "children": [{"name": "Eye", "transform": {"translation": [0, 2.5, 12]}, "camera": {"yfov": 0.9}},
                  {"name": "Lamp", "light": {"rig": "camera", "color": [1, 1, 0.5]}}]},
    {"name": "Inner", "scene": "inner.scene.json", "transform": {"translation": [0, 2, 0]}}
  ]})";

constexpr const char* inner_scene = R"({"hachure_scene": 1, "entities": [
    {"name": "Squares", "model": "squares.glb", "overrides": {"right": {"gooch": {"y": 0.8}}}}]})";

TEST_F(Convert, ASceneBecomesOneFileThatDrawsTheSame) {
    folder.write("all.scene.json", scene_of_all);
    folder.write("inner.scene.json", inner_scene);
    const assets::Image still = picture("all.scene.json"), moving = picture("all.scene.json", true);
    for (const char* file : {"all.glb", "all.gltf"}) {
        ASSERT_TRUE(succeeded(convert("all.scene.json", file)));
        EXPECT_TRUE(alike(picture(file), still)) << file;
        EXPECT_TRUE(alike(picture(file, true), moving)) << file;
    }
    EXPECT_FALSE(alike(still, moving));

    const assets::Model model = assets::read_gltf(folder / "all.glb");
    EXPECT_TRUE(model.warnings.empty());
    EXPECT_EQ(model.meshes.size(), 3u) << "a mesh that two entities draw is there once";
    EXPECT_EQ(model.skins.size(), 2u);
    EXPECT_EQ(model.animations.size(), 6u);
    EXPECT_EQ(model.scenes[0].roots.size(), 4u);
    EXPECT_EQ(json::parse(model.scenes[0].extras),
              json::parse(R"({"style": "gooch", "animation": {"clip": "bend", "offset": 0.5}})"));
}

TEST_F(Convert, ComponentsBecomeExtras) {
    folder.write("all.scene.json", R"({"hachure_scene": 1, "entities": [
        {"name": "Solid", "model": "tetra.obj", "edge_lines": {"width": 3}},
        {"name": "Lamp", "light": {"rig": "camera"}, "from_a_newer_program": [1]}]})");
    ASSERT_EQ(convert("all.scene.json", "all.gltf").exit_code, 0);
    const json nodes = document("all.gltf").at("nodes");
    EXPECT_EQ(nodes.at(0).at("name"), "Solid");
    EXPECT_EQ(nodes.at(0).at("extras").at("hachure"), json::parse(R"({"edge_lines": {"width": 3.0}})"));
    EXPECT_EQ(nodes.back().at("extras").at("hachure"),
              json::parse(R"({"light": {"rig": "camera"}, "from_a_newer_program": [1]})"));
    EXPECT_TRUE(nodes.back().at("extensions").contains("KHR_lights_punctual"));
}

TEST_F(Convert, ThereAndBackKeepsMeshesClipsAndLooks) {
    ASSERT_TRUE(succeeded(convert("arm.glb", "arm.scene.json")));
    EXPECT_EQ(document("arm.scene.json"), json::parse(R"({"hachure_scene": 1,
        "looks": {"arm": {"gooch": {"b": 0.9, "y": 0.1}}},
        "entities": [{"name": "arm", "model": "arm.glb", "look": "arm",
                      "animation": {"clip": "bend", "offset": 0.5}}]})"));
    ASSERT_TRUE(succeeded(convert("arm.scene.json", "back.glb")));
    const assets::Model before = assets::read_gltf(folder / "arm.glb");
    const assets::Model after = assets::read_gltf(folder / "back.glb");
    EXPECT_EQ(after.nodes.size(), before.nodes.size() + 1) << "the entity";
    EXPECT_EQ(after.scenes[0].extras, before.scenes[0].extras);
    ASSERT_EQ(after.animations.size(), before.animations.size());
    for (std::size_t i = 0; i < after.animations.size(); ++i) {
        EXPECT_EQ(after.animations[i].name, before.animations[i].name);
        EXPECT_EQ(after.animations[i].duration, before.animations[i].duration);
    }
    for (std::size_t i = 0; i < before.nodes.size(); ++i) {
        EXPECT_EQ(after.nodes[i + 1].name, before.nodes[i].name);
        EXPECT_EQ(after.nodes[i + 1].translation, before.nodes[i].translation);
        EXPECT_EQ(after.nodes[i + 1].extras, before.nodes[i].extras);
    }
    assets::Model meshes_before, meshes_after;
    meshes_before.meshes = before.meshes;
    meshes_after.meshes = after.meshes;
    EXPECT_EQ(model_difference(meshes_after, meshes_before), "");
    const assets::Image drawn = picture("arm.glb");
    EXPECT_TRUE(alike(picture("arm.scene.json"), drawn));
    EXPECT_TRUE(alike(picture("back.glb"), drawn));
}

TEST_F(Convert, ALookCanBeEditedInTheScene) {
    ASSERT_TRUE(succeeded(convert("arm.glb", "arm.scene.json")));
    json scene = document("arm.scene.json");
    scene["looks"]["arm"]["gooch"]["b"] = 0.2;
    folder.write("edited.scene.json", scene.dump());
    EXPECT_FALSE(alike(picture("edited.scene.json"), picture("arm.scene.json")));
}

TEST_F(Convert, AModelBecomesAnother) {
    for (const char* output : {"tetra.glb", "tetra.gltf"}) {
        ASSERT_TRUE(succeeded(convert("tetra.obj", output)));
        EXPECT_TRUE(alike(picture(output), picture("tetra.obj"))) << output;
    }
    ASSERT_TRUE(succeeded(convert("arm.glb", "again.gltf")));
    EXPECT_EQ(model_difference(assets::read_gltf(folder / "again.gltf"), assets::read_gltf(folder / "arm.glb")), "");
}

TEST_F(Convert, SeveralModelsThatPlayAreSaid) {
    folder.write("two.scene.json", R"({"hachure_scene": 1, "entities": [
        {"name": "A", "model": "arm.glb"}, {"name": "B", "model": "arm.glb"}]})");
    const ProcessResult result = convert("two.scene.json", "two.glb");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.err.find("2 models play clips"), std::string::npos) << result.err;
    std::set<std::string> clips;
    for (const assets::Animation& animation : assets::read_gltf(folder / "two.glb").animations)
        clips.insert(animation.name);
    EXPECT_EQ(clips, (std::set<std::string>{"bend", "walk", "swell", "B/bend", "B/walk", "B/swell"}));
}

TEST_F(Convert, BadInputIsOneLineAndNothingIsWritten) {
    folder.write("loop.scene.json", R"({"hachure_scene": 1, "entities": [{"scene": "loop.scene.json"}]})");
    folder.write("missing.scene.json", R"({"hachure_scene": 1, "entities": [{"model": "none.glb"}]})");
    folder.write("wrong.scene.json", R"({"hachure_scene": 1, "entities": [{"camera": {"yfov": "wide"}}]})");
    folder.write("no.scene.json", "{");
    folder.write("broken.glb", "glTF");
    folder.write("picture.png", "");
    const std::set<std::string> before = folder.listing();
    EXPECT_TRUE(failed(convert("loop.scene.json", "out.glb"), 1, "contains itself"));
    EXPECT_TRUE(failed(convert("missing.scene.json", "out.glb"), 1, "none.glb"));
    EXPECT_TRUE(failed(convert("wrong.scene.json", "out.glb"), 1, "yfov"));
    EXPECT_TRUE(failed(convert("no.scene.json", "out.glb"), 1, "no.scene.json"));
    EXPECT_TRUE(failed(convert("there-is-none.glb", "out.glb"), 1, "there is no such file"));
    EXPECT_TRUE(failed(convert("broken.glb", "out.scene.json"), 1, "broken.glb"));
    EXPECT_TRUE(failed(convert("picture.png", "out.glb"), 1, "not a kind of model"));
    EXPECT_TRUE(failed(convert("arm.glb", "none/out.glb"), 1, "none/out.glb"));
    EXPECT_TRUE(failed(convert("arm.glb", "out.obj"), 2, "out.obj"));
    EXPECT_TRUE(failed(convert("arm.scene.json", "out.scene.json"), 2, "scenes"));
    EXPECT_EQ(folder.listing(), before);
}

TEST_F(Convert, ExtrasThatAreWrongOrHugeAreWarnings) {
    assets::Model arm = arm_model();
    arm.nodes[0].extras = R"({"gooch": {"b": "blue"}, "edge_lines": 3, "script": {"file": ")" +
                          std::string(std::size_t{2} << 20, 'x') + R"("}})";
    arm.nodes[1].extras = R"({"gooch": {"b": "blue"}})";
    assets::write_gltf(arm, folder / "odd.glb");
    const ProcessResult result = convert("odd.glb", "odd.scene.json");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("longer than 1 MiB"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("/nodes/1/extras/hachure/gooch/b"), std::string::npos) << result.err;
    EXPECT_LT(result.err.size(), 4000u);
    EXPECT_EQ(document("odd.scene.json").at("entities").at(0).count("look"), 0u);
}

TEST_F(Convert, RealModels) {
    if (given_models().empty()) GTEST_SKIP() << no_given_models;
    for (const char* file : {"characters/khronos/Fox.glb", "meshes/torus.obj"})
        std::filesystem::copy_file(given_models() / file, folder / std::filesystem::path(file).filename().string());
    folder.write("fox.scene.json", R"({"hachure_scene": 1, "entities": [
        {"name": "Fox", "model": "Fox.glb", "transform": {"scale": [0.02, 0.02, 0.02]}, "animation": {"clip": "Run"}},
        {"name": "Ring", "model": "torus.obj", "transform": {"translation": [0, 3, 0]}, "gooch": {"b": 0.8}}]})");
    ASSERT_TRUE(succeeded(convert("fox.scene.json", "fox.glb")));
    EXPECT_TRUE(alike(picture("fox.glb", true), picture("fox.scene.json", true)));
    const assets::Model before = assets::read_gltf(folder / "Fox.glb"), after = assets::read_gltf(folder / "fox.glb");
    ASSERT_EQ(after.images.size(), 1u);
    EXPECT_EQ(after.images[0].bytes, before.images[0].bytes) << "byte for byte";
}

} // namespace
} // namespace hachure::test
