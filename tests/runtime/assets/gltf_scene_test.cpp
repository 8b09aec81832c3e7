#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using namespace gltf_testing;
using testing::HasSubstr;

json matrix_json(const glm::mat4& matrix) {
    json numbers = json::array();
    for (int i = 0; i < 16; ++i) numbers.push_back(matrix[i / 4][i % 4]);
    return numbers;
}

Node read_matrix(const glm::mat4& matrix) {
    GltfBuilder builder;
    builder.add("nodes", {{"matrix", matrix_json(matrix)}});
    return builder.read().nodes.at(0);
}

glm::mat4 recompose(const Node& node) {
    return glm::translate(glm::mat4(1), node.translation) * glm::mat4_cast(node.rotation) *
           glm::scale(glm::mat4(1), node.scale);
}

void expect_near(const glm::mat4& a, const glm::mat4& b) {
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(a[i / 4][i % 4], b[i / 4][i % 4], 1e-4);
}

TEST(GltfNodes, ReadsTheTree) {
    GltfBuilder builder;
    builder.add("nodes", {{"name", "root"}, {"children", {2, 1}}});
    builder.add("nodes", {{"name", "leaf"}});
    builder.add("nodes", {{"name", "arm"},
                          {"children", {3}},
                          {"translation", {1, 2, 3}},
                          {"scale", {2, 2, 2}},
                          {"rotation", {0, 0, 2, 0}}});
    builder.add("nodes", json::object());
    const Model model = builder.read();
    EXPECT_EQ(broken_promise(model), "");
    EXPECT_EQ(model.nodes[0].children, (std::vector<std::int32_t>{2, 1}));
    EXPECT_EQ(model.nodes[3].parent, 2);
    EXPECT_EQ(model.nodes[2].translation, glm::vec3(1, 2, 3));
    EXPECT_EQ(model.nodes[2].rotation, glm::quat(0, 0, 0, 1)) << "made unit; glTF writes x, y, z, w";
    EXPECT_THAT(warnings_of(model), HasSubstr("normalised (first at /nodes/2)"));
    ASSERT_EQ(model.scenes.size(), 1u) << "no scene: one of all roots";
    EXPECT_EQ(model.scenes[0].roots, std::vector<std::int32_t>{0});
}

TEST(GltfNodes, DecomposesMatrices) {
    const glm::mat4 turned = glm::translate(glm::mat4(1), glm::vec3(5, -3, 2)) *
                             glm::rotate(glm::mat4(1), 2.5f, glm::normalize(glm::vec3(1, -2, 3)));
    for (const glm::vec3 scale : {glm::vec3(1), glm::vec3(2, 0.5f, 3), glm::vec3(-1, 1, 1), glm::vec3(1, -2, 3),
                                  glm::vec3(1e-3f), glm::vec3(-1, -1, -1)}) {
        const glm::mat4 matrix = turned * glm::scale(glm::mat4(1), scale);
        const Node node = read_matrix(matrix);
        EXPECT_FALSE(node.matrix.has_value());
        EXPECT_NEAR(glm::length(node.rotation), 1.0f, 1e-6);
        expect_near(recompose(node), matrix);
    }
}

TEST(GltfNodes, KeepsMatricesThatDoNotDecompose) {
    glm::mat4 sheared(1);
    sheared[1].x = 0.5f;
    glm::mat4 projective(1);
    projective[0].w = 0.1f;
    const glm::mat4 flat = glm::scale(glm::mat4(1), glm::vec3(1, 0, 1));
    for (const glm::mat4& matrix : {sheared, projective, flat, glm::mat4(0)}) {
        const Node node = read_matrix(matrix);
        ASSERT_TRUE(node.matrix.has_value());
        EXPECT_EQ(*node.matrix, matrix);
    }
}

TEST(GltfScenes, ReadsThemAndTheDefault) {
    GltfBuilder builder;
    builder.add("nodes", {{"children", {2}}});
    builder.add("nodes", json::object());
    builder.add("nodes", json::object());
    builder.add("scenes", {{"name", "one"}, {"nodes", {1}}});
    builder.add("scenes", {{"name", "two"}, {"nodes", {1, 2, 0}}});
    builder.root["scene"] = 1;
    const Model model = builder.read();
    EXPECT_EQ(model.default_scene, 1);
    EXPECT_EQ(model.scenes[0].roots, std::vector<std::int32_t>{1});
    EXPECT_EQ(model.scenes[1].roots, (std::vector<std::int32_t>{1, 0})) << "node 2 stands below 0";
    EXPECT_THAT(warnings_of(model), HasSubstr("the whole tree is taken (first at /scenes/1)"));
}

TEST(GltfCameras, ReadsBothKindsAndReplacesImpossibleOnes) {
    GltfBuilder builder;
    builder.add("cameras", {{"name", "p"},
                            {"type", "perspective"},
                            {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"zfar", 50}, {"aspectRatio", 1.5}}}});
    builder.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.2}}}});
    builder.add("cameras",
                {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0}, {"zfar", 10}}}});
    builder.add("cameras", {{"name", "bad"}, {"type", "perspective"}, {"perspective", {{"yfov", 0}, {"znear", -1}}}});
    builder.add("nodes", {{"camera", 2}});
    const Model model = builder.read();
    EXPECT_FLOAT_EQ(model.cameras[0].yfov, 0.5f);
    EXPECT_EQ(model.cameras[0].aspect, 1.5f);
    EXPECT_EQ(model.cameras[0].zfar, 50.0f);
    EXPECT_FALSE(model.cameras[1].zfar.has_value()) << "infinite";
    EXPECT_FALSE(model.cameras[1].aspect.has_value());
    EXPECT_TRUE(model.cameras[2].orthographic);
    EXPECT_EQ(model.cameras[2].ymag, 2.0f);
    EXPECT_EQ(model.cameras[3].yfov, Camera{}.yfov);
    EXPECT_EQ(model.cameras[3].name, "bad");
    EXPECT_EQ(model.nodes[0].camera, 2);
    EXPECT_EQ(model.warnings.size(), 1u) << warnings_of(model);
}

TEST(GltfLights, ReadsEveryKind) {
    GltfBuilder builder;
    json& lights = builder.root["extensions"]["KHR_lights_punctual"]["lights"];
    lights = {{{"type", "directional"}, {"name", "sun"}, {"color", {1, 0.5, 0.25}}, {"intensity", 3}},
              {{"type", "point"}, {"range", 12}},
              {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
              {{"type", "spot"}, {"spot", json::object()}}};
    builder.root["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.add("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 2}}}}}});
    builder.add("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const Model model = builder.read();
    ASSERT_EQ(model.lights.size(), 4u);
    EXPECT_EQ(model.lights[0].kind, LightKind::directional);
    EXPECT_EQ(model.lights[0].color, glm::vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(model.lights[0].intensity, 3.0f);
    EXPECT_FALSE(model.lights[0].range.has_value());
    EXPECT_EQ(model.lights[1].range, 12.0f);
    EXPECT_EQ(model.lights[2].inner_cone, 0.25f);
    EXPECT_EQ(model.lights[2].outer_cone, 0.5f);
    EXPECT_NEAR(model.lights[3].outer_cone, 3.14159265 / 4, 1e-6);
    EXPECT_EQ(model.nodes[0].light, 2);
    EXPECT_EQ(model.nodes[1].light, 0);
    EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
}

/// A skinned triangle over two joints, the nodes 1 and 2.
GltfBuilder skinned_triangle() {
    GltfBuilder builder;
    const int joints = builder.accessor(builder.view({0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 9, 0}), u8, "VEC4", 3);
    const int weights = builder.floats({0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4);
    builder.mesh({{"POSITION", builder.triangle_positions()}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
    builder.root["nodes"][0]["skin"] = 0;
    builder.add("nodes", {{"children", {2}}});
    builder.add("nodes", json::object());
    builder.add("skins", {{"name", "s"}, {"joints", {1, 2}}, {"skeleton", 1}});
    return builder;
}

TEST(GltfSkins, ReadsJointsAndWeights) {
    GltfBuilder builder = skinned_triangle();
    std::vector<float> matrices(32);
    for (std::size_t i = 0; i < 32; ++i) matrices[i] = static_cast<float>(i);
    builder.root["skins"][0]["inverseBindMatrices"] = builder.floats(matrices, 16);
    const Model model = builder.read();
    EXPECT_EQ(broken_promise(model), "");
    EXPECT_EQ(model.skins[0].joints, (std::vector<std::int32_t>{1, 2}));
    EXPECT_EQ(model.skins[0].inverse_bind[1][2][1], 25.0f) << "by column";
    EXPECT_EQ(model.skins[0].skeleton, 1);
    const Primitive& p = model.meshes[0].primitives[0];
    EXPECT_EQ(p.weights[0][0], glm::vec4(0.5f, 0.5f, 0, 0));
    EXPECT_EQ(p.joints[0][2], glm::u16vec4(1, 0, 0, 0)) << "joint 9 has no weight";
    EXPECT_THAT(warnings_of(model), HasSubstr("joint indices beyond the skin that have no weight become 0"));
}

TEST(GltfSkins, StandsInForMissingInverseBindMatrices) {
    const Model model = skinned_triangle().read();
    EXPECT_EQ(model.skins[0].inverse_bind, std::vector<glm::mat4>(2, glm::mat4(1)));
    EXPECT_THAT(warnings_of(model), HasSubstr("has no inverse bind matrices"));
    GltfBuilder builder = skinned_triangle();
    std::vector<float> twice(16);
    for (std::size_t i = 0; i < 16; i += 5) twice[i] = i < 15 ? 2.0f : 1.0f;
    builder.root["skins"][0]["name"] = "arm";
    builder.root["skins"][0]["inverseBindMatrices"] = builder.floats(twice, 16);
    const Model too_few = builder.read();
    EXPECT_EQ(too_few.skins[0].inverse_bind[0][1][1], 2.0f);
    EXPECT_EQ(too_few.skins[0].inverse_bind[1], glm::mat4(1));
    EXPECT_THAT(warnings_of(too_few), HasSubstr("skin 'arm' has 1 inverse bind matrices for 2 joints"));
}

TEST(GltfSkins, NamesSkinsThatFlatten) {
    GltfBuilder builder = skinned_triangle();
    builder.root["skins"][0]["inverseBindMatrices"] = builder.floats(std::vector<float>(32), 16);
    EXPECT_THAT(warnings_of(builder.read()), HasSubstr("has an inverse bind matrix that flattens what it binds"));
}

TEST(GltfSkins, RefusesWhatDoesNotFit) {
    GltfBuilder too_few = skinned_triangle();
    too_few.root["skins"][0]["joints"] = {1};
    EXPECT_THAT(error_of(too_few), HasSubstr("has the joint 1 in a skin of 1 (/meshes/0)"));
    GltfBuilder empty = skinned_triangle();
    empty.root["skins"][0]["joints"] = json::array();
    EXPECT_THAT(error_of(empty), HasSubstr("/skins/0"));
}

TEST(GltfSkins, ReadsEightInfluencesAndDropsHalvesOfPairs) {
    GltfBuilder builder = skinned_triangle();
    json& attributes = builder.root["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_1"] = attributes["JOINTS_0"];
    attributes["WEIGHTS_1"] = attributes["WEIGHTS_0"];
    attributes["JOINTS_2"] = attributes["JOINTS_0"];
    Model model = builder.read();
    EXPECT_EQ(model.meshes[0].primitives[0].joints[1].size(), 3u);
    EXPECT_THAT(warnings_of(model), HasSubstr("beyond eight"));
    attributes.erase("WEIGHTS_1");
    model = builder.read();
    EXPECT_EQ(broken_promise(model), "");
    EXPECT_TRUE(model.meshes[0].primitives[0].joints[1].empty());
    EXPECT_THAT(warnings_of(model), HasSubstr("joints without weights"));
}

TEST(GltfNodes, OverridesMorphWeights) {
    GltfBuilder builder;
    const int positions = builder.triangle_positions();
    builder.mesh({{"POSITION", positions}});
    builder.root["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", positions}}, {{"POSITION", positions}}};
    builder.root["nodes"][0]["weights"] = {0.5, 1};
    builder.add("nodes", {{"mesh", 0}, {"weights", {1}}});
    const Model model = builder.read();
    EXPECT_EQ(model.nodes[0].morph_weights, (std::vector<float>{0.5f, 1.0f}));
    EXPECT_TRUE(model.nodes[1].morph_weights.empty());
    EXPECT_THAT(warnings_of(model), HasSubstr("/nodes/1"));
}

} // namespace
} // namespace hachure::assets
