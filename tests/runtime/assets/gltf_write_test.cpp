#include <hachure/runtime/assets/append_model.h>
#include <hachure/runtime/assets/gltf.h>
#include <hachure/runtime/assets/gltf_write.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/support/model_difference.h>

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using namespace gltf_testing;
using test::model_difference;

/// A model with one of everything that files hold.
Model everything() {
    Model model = test::arm_model();
    Primitive& arm = model.meshes[0].primitives[0];
    const std::size_t count = arm.positions.size();
    arm.material = 1;
    arm.tangents.assign(count, {1, 0, 0, -1});
    arm.texcoords[0].assign(count, {0.1f, 0.7f});
    arm.texcoords[1].assign(count, {0.3f, 0.2f});
    arm.colors.assign(count, {0.1f, 0.2f, 0.3f, 1.0f});
    model.images.push_back({"a.png",
                            {std::byte{0x89}, std::byte{'P'}, std::byte{'N'}, std::byte{'G'}, std::byte{0x0d},
                             std::byte{0x0a}, std::byte{0x1a}, std::byte{0x0a}, std::byte{7}}});
    model.textures.push_back({.image = 0, .wrap_s = Wrap::mirror, .minify = Filter::nearest, .mipmaps = false});
    model.textures.push_back({.image = 0, .wrap_t = Wrap::clamp, .magnify = Filter::nearest});
    model.materials.push_back({.name = "plain"});
    Material full{.name = "full", .base_color = {0.1f, 0.2f, 0.3f, 0.4f}, .metallic = 0.3f, .roughness = 0.7f};
    full.base_color_texture = {.texture = 0, .offset = {0.1f, 0.2f}, .scale = {2, 3}, .rotation = 0.4f};
    full.metallic_roughness_texture = {.texture = 1};
    full.normal_texture = {.texture = 1, .texcoord = 1};
    full.normal_scale = 0.6f;
    full.emissive = {0.1f, 0.0f, 1.0f};
    full.alpha_mode = AlphaMode::mask;
    full.double_sided = true;
    full.emissive_texture = {.texture = 0};
    full.occlusion_texture = {.texture = 1};
    full.extras = R"({"edge_lines":{},"gooch":{"b":0.1}})";
    model.materials.push_back(full);
    model.cameras.push_back({.name = "eye", .yfov = 0.7f, .aspect = 1.5f, .zfar = 100.0f});
    model.cameras.push_back({.orthographic = true, .xmag = 2.0f, .ymag = 1.0f, .znear = 0.1f, .zfar = 7.0f});
    model.lights.push_back({.name = "sun", .color = {1, 0.5f, 0.1f}, .intensity = 3.0f});
    model.lights.push_back({.kind = LightKind::spot, .range = 4.0f, .inner_cone = 0.1f, .outer_cone = 0.3f});
    model.nodes[0].morph_weights = {0.25f};
    model.nodes[1].extras = R"({"script":{"file":"a.lua"}})";
    Node eye{.name = "eye", .camera = 0, .light = 1};
    eye.rotation = glm::angleAxis(0.3f, glm::vec3(0, 1, 0));
    eye.scale = {1, 2, 3};
    model.nodes.push_back(eye);
    Node sheared{.name = "sheared", .camera = 1, .light = 0};
    sheared.matrix = glm::mat4(1.0f);
    (*sheared.matrix)[1][0] = 0.5f;
    model.nodes.push_back(sheared);
    model.scenes[0].roots = {0, 1, 3, 4};
    model.scenes[0].extras = R"({"style":"gooch"})";
    AnimationChannel pointer{.path = AnimationPath::pointer, .times = {0, 1}, .values = {0.5f, 0.6f}};
    pointer.pointer = "/cameras/0/perspective/yfov";
    pointer.components = 1;
    model.animations[0].channels.push_back(pointer);
    return model;
}

/// The model as it is read from the file that it was written to.
Model written(const Model& model, const std::string& name) {
    const TempFolder folder;
    write_gltf(model, folder / name);
    return read_gltf(folder / name);
}

TEST(GltfWrite, WhatIsWrittenIsReadAgain) {
    const Model model = everything();
    for (const char* name : {"a.glb", "a.gltf"}) {
        const Model again = written(model, name);
        EXPECT_EQ(model_difference(model, again), "") << name;
        EXPECT_EQ(broken_promise(again), "");
        EXPECT_TRUE(again.warnings.empty()) << warnings_of(again);
    }
}

TEST(GltfWrite, OtherReadersTakeIt) {
    const TempFolder folder;
    Model model = everything();
    model.animations[0].channels.pop_back(); // this reader knows no channels of pointers
    write_gltf(model, folder / "a.glb");
    write_gltf(model, folder / "a.gltf");
    tinygltf::TinyGLTF loader;
    // Nine bytes are no picture.
    const auto load_nothing = [](tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                                 void*) { return true; };
    loader.SetImageLoader(load_nothing, nullptr);
    tinygltf::Model binary, text;
    std::string error, warning;
    ASSERT_TRUE(loader.LoadBinaryFromFile(&binary, &error, &warning, (folder / "a.glb").string())) << error;
    ASSERT_TRUE(loader.LoadASCIIFromFile(&text, &error, &warning, (folder / "a.gltf").string())) << error;
    EXPECT_EQ(error + warning, "");
    EXPECT_EQ(binary.buffers.at(0).data, text.buffers.at(0).data);
    const tinygltf::Accessor& positions =
        binary.accessors.at(static_cast<std::size_t>(binary.meshes[0].primitives[0].attributes.at("POSITION")));
    ASSERT_EQ(positions.maxValues.size(), 3u);
    ASSERT_EQ(positions.minValues.size(), 3u);
    EXPECT_EQ(static_cast<float>(positions.maxValues[0]), 0.2f);
    EXPECT_EQ(positions.maxValues[1], 2.0);
    EXPECT_EQ(static_cast<float>(positions.minValues[0]), -0.2f);
    for (const tinygltf::BufferView& view : binary.bufferViews)
        EXPECT_LE(view.byteOffset + view.byteLength, binary.buffers[0].data.size());
}

TEST(GltfWrite, EqualArraysAreStoredOnce) {
    Model model = test::arm_model();
    const TempFolder folder;
    write_gltf(model, folder / "one.glb");
    model.meshes.push_back(model.meshes[0]);
    write_gltf(model, folder / "two.glb");
    EXPECT_LT(std::filesystem::file_size(folder / "two.glb"), std::filesystem::file_size(folder / "one.glb") + 500);
    EXPECT_EQ(model_difference(read_gltf(folder / "two.glb"), model), "");
}

TEST(GltfWrite, LeavesNothingBehindThatIsNotWhole) {
    const TempFolder folder;
    EXPECT_THROW(write_gltf(everything(), folder / "none/a.glb"), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(AppendModel, InstancesHaveTheirOwnNodesAndShareTheRest) {
    const Model source = everything();
    Model scene;
    scene.nodes.resize(2);
    scene.scenes.push_back({"scene", {0, 1}});
    const ModelPlaces shared = append_resources(scene, source);
    for (std::int32_t i = 0; i < 2; ++i) append_instance(scene, source, shared, i);
    const Model again = written(scene, "a.glb");
    EXPECT_EQ(broken_promise(again), "");
    EXPECT_EQ(model_difference(scene, again), "");
    EXPECT_EQ(again.meshes.size(), source.meshes.size());
    EXPECT_EQ(again.images.size(), source.images.size());
    EXPECT_EQ(again.nodes.size(), 2 + 2 * source.nodes.size());
    EXPECT_EQ(again.skins.size(), 2u);
    EXPECT_EQ(again.skins[1].joints, (std::vector<std::int32_t>{8, 9}));
    EXPECT_EQ(again.nodes[1].children, (std::vector<std::int32_t>{7, 8, 10, 11}));
    EXPECT_EQ(again.animations.size(), 2 * source.animations.size());
    EXPECT_EQ(again.animations[3].channels[1].pointer, "/cameras/2/perspective/yfov");
}

TEST(GltfWrite, RealModelsStayWhatTheyAre) {
    for (const auto& file : test::given_gltf_files("characters/khronos")) {
        const Model model = read_gltf(file);
        if (!model.extensions.empty()) continue; // what is not understood is not written
        EXPECT_EQ(model_difference(written(model, "a.glb"), model), "") << file;
    }
}

} // namespace
} // namespace hachure::assets
