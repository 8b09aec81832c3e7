#include <hachure/runtime/assets/gltf.h>
#include <hachure/runtime/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <limits>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using namespace gltf_testing;
using testing::HasSubstr;

/// A file with something of everything: mesh, morph target, skin, clip, camera, light, material, texture.
GltfBuilder complete_file() {
    GltfBuilder builder;
    const int positions = builder.triangle_positions();
    const int joints = builder.accessor(builder.view(Bytes(12)), u8, "VEC4", 3);
    const int weights = builder.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4);
    builder.mesh({{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}, builder.shorts({0, 1, 2}));
    json& primitive = builder.root["meshes"][0]["primitives"][0];
    primitive["targets"] = {{{"POSITION", positions}}};
    primitive["material"] = 0;
    builder.root["nodes"][0].update({{"skin", 0}, {"children", {1}}});
    builder.add("nodes", {{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    builder.add("skins", {{"joints", {1}}});
    builder.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}});
    builder.add("images", {{"uri", "data:image/png;base64,iVBORw0KGgoAAAA="}});
    builder.add("textures", {{"source", 0}});
    builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    builder.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
    const int times = builder.floats({0, 1}, 1);
    const int moves = builder.floats({0, 0, 0, 1, 1, 1}, 3);
    builder.add("animations", {{"samplers", {{{"input", times}, {"output", moves}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}});
    builder.add("scenes", {{"nodes", {0}}});
    builder.root["scene"] = 0;
    return builder;
}

TEST(GltfBroken, TheCompleteFileIsFine) { EXPECT_EQ(error_of(complete_file()), ""); }

struct Fault {
    const char* pointer; // where the value is put
    json value;
    const char* where; // what the message must hold
};

void PrintTo(const Fault& fault, std::ostream* stream) { *stream << fault.pointer << " = " << fault.value; }

class GltfBrokenValue : public testing::TestWithParam<Fault> {};

TEST_P(GltfBrokenValue, IsRefusedWithItsPlace) {
    GltfBuilder builder = complete_file();
    builder.root["buffers"] = {{{"byteLength", builder.binary.size()}}};
    builder.root[json::json_pointer(GetParam().pointer)] = GetParam().value;
    EXPECT_THAT(error_of(builder), HasSubstr(GetParam().where));
}

INSTANTIATE_TEST_SUITE_P(
    Types, GltfBrokenValue,
    testing::Values(Fault{"/asset", 7, "/asset"}, Fault{"/asset/version", "1.0", "glTF 1.0"},
                    Fault{"/asset/version", 2.0, "/asset/version"}, Fault{"/asset/version", "two", "/asset/version"},
                    Fault{"/asset/minVersion", "2.1", "2.1"}, Fault{"/nodes", json::object(), "/nodes"},
                    Fault{"/nodes/0", 5, "/nodes/0"}, Fault{"/nodes/0/name", 5, "/nodes/0/name"},
                    Fault{"/materials/0", json::array(), "/materials/0"},
                    Fault{"/materials/0/pbrMetallicRoughness", 3, "/materials/0/pbrMetallicRoughness"},
                    Fault{"/materials/0/doubleSided", 1, "/materials/0/doubleSided"},
                    Fault{"/materials/0/alphaMode", "GLASS", "/materials/0/alphaMode"},
                    Fault{"/materials/0/emissiveFactor", {1, 2}, "must have 3 numbers"},
                    Fault{"/materials/0/normalTexture", "x", "/materials/0/normalTexture"},
                    Fault{"/nodes/0/matrix", {1}, "must have 16 numbers"},
                    Fault{"/nodes/0/translation", {0, 0, "x"}, "/nodes/0/translation"},
                    Fault{"/nodes/0/translation", {1e300, 0, 0}, "/nodes/0/translation"},
                    Fault{"/extensions/KHR_lights_punctual/lights/0", 1, "/extensions/KHR_lights_punctual/lights/0"},
                    Fault{"/extensions/KHR_lights_punctual/lights/0/type", "laser", "must be one of"},
                    Fault{"/extensions/KHR_lights_punctual", 1, "/extensions/KHR_lights_punctual"},
                    Fault{"/cameras/0/type", "fisheye", "/cameras/0/type"},
                    Fault{"/cameras/0/perspective", json::object(), "lacks 'yfov'"},
                    Fault{"/meshes/0/primitives", 1, "/meshes/0/primitives"},
                    Fault{"/meshes/0/primitives/0/attributes", json::array(), "/meshes/0/primitives/0/attributes"},
                    Fault{"/meshes/0/primitives/0/mode", -1, "/meshes/0/primitives/0/mode"},
                    Fault{"/animations/0/samplers/0/interpolation", "CURVE", "/animations/0/samplers/0"},
                    Fault{"/extensionsRequired", {"EXT_unheard"}, "EXT_unheard"},
                    Fault{"/extensionsUsed", {1}, "/extensionsUsed"}));

INSTANTIATE_TEST_SUITE_P(
    Indices, GltfBrokenValue,
    testing::Values(Fault{"/scene", 1, "/scene"}, Fault{"/scene", -1, "/scene"}, Fault{"/scene", 0.5, "/scene"},
                    Fault{"/scenes/0/nodes", {2}, "/scenes/0/nodes"},
                    Fault{"/nodes/0/children", {9}, "/nodes/0/children"}, Fault{"/nodes/0/mesh", 1, "/nodes/0/mesh"},
                    Fault{"/nodes/0/skin", 1, "/nodes/0/skin"}, Fault{"/nodes/0/camera", 4294967296, "/nodes/0/camera"},
                    Fault{"/nodes/1/extensions/KHR_lights_punctual/light", 1, "/nodes/1/extensions"},
                    Fault{"/meshes/0/primitives/0/attributes/POSITION", 99, "attributes/POSITION"},
                    Fault{"/meshes/0/primitives/0/targets/0/POSITION", -1, "targets/0/POSITION"},
                    Fault{"/meshes/0/primitives/0/indices", 99, "/meshes/0/primitives/0/indices"},
                    Fault{"/meshes/0/primitives/0/material", 1, "/meshes/0/primitives/0/material"},
                    Fault{"/skins/0/joints", {5}, "/skins/0/joints"},
                    Fault{"/skins/0/inverseBindMatrices", 99, "/skins/0/inverseBindMatrices"},
                    Fault{"/textures/0/source", 1, "/textures/0/source"},
                    Fault{"/textures/0/sampler", 0, "/textures/0/sampler"},
                    Fault{"/materials/0/pbrMetallicRoughness/baseColorTexture/index", 3, "baseColorTexture/index"},
                    Fault{"/animations/0/channels/0/sampler", 1, "/animations/0/channels/0/sampler"},
                    Fault{"/accessors/0/bufferView", 99, "/accessors/0/bufferView"},
                    Fault{"/bufferViews/0/buffer", 1, "/bufferViews/0/buffer"}));

INSTANTIATE_TEST_SUITE_P(Sizes, GltfBrokenValue,
                         testing::Values(Fault{"/accessors/0/count", 4, "ends beyond its buffer view (/accessors/0)"},
                                         Fault{"/accessors/0/count", 100'000'000, "claims more data"},
                                         Fault{"/accessors/0/count", 2147483648, "/accessors/0/count"},
                                         Fault{"/accessors/0/count", -1, "/accessors/0/count"},
                                         Fault{"/accessors/0/count", 1e300, "/accessors/0/count"},
                                         Fault{"/accessors/0/count", 2.5, "/accessors/0/count"},
                                         Fault{"/accessors/0/count", "3", "/accessors/0/count"},
                                         Fault{"/accessors/0/byteOffset", 4, "ends beyond its buffer view"},
                                         Fault{"/accessors/0/byteOffset", -4, "/accessors/0/byteOffset"},
                                         Fault{"/accessors/0/byteOffset", 1e18, "/accessors/0/byteOffset"},
                                         Fault{"/accessors/0/componentType", 5124, "/accessors/0/componentType"},
                                         Fault{"/accessors/0/componentType", 5130, "/accessors/0/componentType"},
                                         Fault{"/accessors/0/type", "VEC5", "/accessors/0/type"},
                                         Fault{"/bufferViews/0/byteLength", 1'000'000,
                                               "ends beyond its buffer (/bufferViews/0)"},
                                         Fault{"/bufferViews/0/byteOffset", 2147483647, "ends beyond its buffer"},
                                         Fault{"/bufferViews/0/byteStride", 1e9, "/bufferViews/0/byteStride"},
                                         Fault{"/bufferViews/0/byteStride", -4, "/bufferViews/0/byteStride"},
                                         Fault{"/bufferViews/0/byteStride", 4, "larger than its view's stride"},
                                         Fault{"/buffers/0/byteLength", 100'000, "/buffers/0"},
                                         Fault{"/buffers/0/byteLength", 4, "/bufferViews"},
                                         Fault{"/buffers/0/uri", "../../etc/passwd", "leaves the file's folder"},
                                         Fault{"/buffers/0/uri", "/etc/passwd", "absolute path"},
                                         Fault{"/buffers/0/uri", "none.bin", "none.bin: no such file"},
                                         Fault{"/buffers/0/uri", "data:;base64,####", "not base64"}));

TEST(GltfBroken, NodeGraphsThatAreNoForest) {
    GltfBuilder cycle = complete_file();
    cycle.root["nodes"][1]["children"] = {0};
    EXPECT_THAT(error_of(cycle), HasSubstr("among its own descendants (/nodes/0)"));
    GltfBuilder self = complete_file();
    self.root["nodes"][1]["children"] = {1};
    EXPECT_THAT(error_of(self), HasSubstr("two parents (/nodes/1)"));
    GltfBuilder twice = complete_file();
    twice.root["nodes"][0]["children"] = {1, 1};
    EXPECT_THAT(error_of(twice), HasSubstr("two parents (/nodes/1)"));
}

TEST(GltfBroken, IndicesBeyondTheVerticesAndRestarts) {
    GltfBuilder beyond;
    const int positions = beyond.triangle_positions();
    beyond.mesh({{"POSITION", positions}}, beyond.shorts({0, 1, 3}));
    EXPECT_THAT(error_of(beyond), HasSubstr("has the index 3 to 3 vertices (/accessors/1)"));
    GltfBuilder restart;
    restart.mesh({{"POSITION", restart.triangle_positions()}}, restart.shorts({0, 1, 2, 65535}), 5);
    EXPECT_THAT(error_of(restart), HasSubstr("primitive restart"));
}

TEST(GltfBroken, PositionsAndInverseBindMatricesThatAreNotFinite) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
        GltfBuilder positions;
        positions.mesh({{"POSITION", positions.floats({0, 0, 0, 1, 0, bad, 0, 1, 0}, 3)}});
        EXPECT_THAT(error_of(positions), HasSubstr("position that is not finite (/accessors/0)"));
        GltfBuilder skin = complete_file();
        std::vector<float> matrix(16, 1.0f);
        matrix[5] = bad;
        skin.root["skins"][0]["inverseBindMatrices"] = skin.floats(matrix, 16);
        EXPECT_THAT(error_of(skin), HasSubstr("inverse bind matrix that is not finite"));
    }
}

TEST(GltfBroken, PrimitivesWithDifferentNumbersOfTargets) {
    GltfBuilder builder = complete_file();
    json primitive = builder.root["meshes"][0]["primitives"][0];
    primitive.erase("targets");
    builder.root["meshes"][0]["primitives"].push_back(primitive);
    EXPECT_THAT(error_of(builder), HasSubstr("different numbers of morph targets (/meshes/0)"));
}

TEST(GltfBroken, MegabytesClaimedByAKilobyte) {
    const auto start = std::chrono::steady_clock::now();
    GltfBuilder sparse;
    const int view = sparse.view(Bytes(16));
    const int positions = sparse.accessor(-1, f32, "VEC3", 100'000'000);
    sparse.root["accessors"][0]["sparse"] = {
        {"count", 1}, {"indices", {{"bufferView", view}, {"componentType", 5121}}}, {"values", {{"bufferView", view}}}};
    sparse.mesh({{"POSITION", positions}});
    EXPECT_THAT(error_of(sparse), HasSubstr("claims more data than a file of its size can hold (/accessors/0)"));

    // A thousand primitives that share one accessor at the edge of what is allowed.
    GltfBuilder shared;
    const int zeros = shared.accessor(-1, f32, "VEC3", 1'000'000);
    shared.mesh({{"POSITION", zeros}});
    const json primitive = shared.root["meshes"][0]["primitives"][0];
    for (int i = 0; i < 1000; ++i) shared.root["meshes"][0]["primitives"].push_back(primitive);
    EXPECT_THAT(error_of(shared), HasSubstr("claims more data"));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

TEST(GltfBroken, JsonThatIsDeepHugeOrNotJson) {
    const auto start = std::chrono::steady_clock::now();
    const auto error_of_text = [](const std::string& text) {
        return error_of({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    };
    EXPECT_THAT(error_of_text(std::string(100'000, '[')), HasSubstr("nested too deeply (byte 128)"));
    EXPECT_THAT(error_of_text("{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(100'000, '[') +
                              std::string(100'000, ']') + "}"),
                HasSubstr("nested too deeply"));
    std::string objects = "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{}";
    for (int i = 0; i < 600'000; ++i) objects += ",{}";
    EXPECT_THAT(error_of_text(objects + "]}"), HasSubstr("too much JSON"));
    EXPECT_THAT(error_of_text("{\"asset\":{\"version\":\"2.0\"},\"scene\":1e999}"), HasSubstr("out of range"));
    EXPECT_THAT(error_of_text("{\"asset\":"), HasSubstr("not valid JSON (byte"));
    EXPECT_THAT(error_of_text("[]"), HasSubstr("must be an object"));
    EXPECT_THAT(error_of_text("{}"), HasSubstr("lacks 'asset'"));
    EXPECT_THAT(error_of_text("{\"asset\":{\"version\":\"2.0\"},\"\xff\":1}"), HasSubstr("not valid JSON"));
    EXPECT_THAT(error_of_text(""), HasSubstr("is empty"));
    EXPECT_THAT(error_of_text("solid cube"), HasSubstr("not valid JSON"));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

// Sizes at which a quadratic step would take minutes.
TEST(GltfBroken, WideAndDeepFilesTakeLinearTime) {
    const auto start = std::chrono::steady_clock::now();
    constexpr int many = 30'000;
    GltfBuilder builder;
    json every = json::array();
    for (int i = 0; i < many; ++i) {
        builder.add("nodes", i + 1 < many ? json{{"children", {i + 1}}} : json::object());
        builder.root["extensionsUsed"].push_back("EXT_" + std::to_string(i));
        every.push_back(i);
    }
    for (int i = 0; i < 10; ++i) builder.add("scenes", {{"nodes", every}});
    const Model model = builder.read();
    EXPECT_EQ(model.scenes.at(9).roots, std::vector<std::int32_t>{0});
    EXPECT_EQ(model.warnings.size(), 101u) << "the last one says that there are more";
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(GltfBroken, GlbContainers) {
    const Bytes good = complete_file().glb();
    const auto with = [&](std::size_t offset, unsigned char value) {
        Bytes bytes = good;
        bytes[offset] = value;
        return error_of(bytes);
    };
    EXPECT_THAT(with(4, 1), HasSubstr("GLB version 1"));
    EXPECT_THAT(with(11, 0x7f), HasSubstr("is truncated"));
    EXPECT_THAT(with(8, 14), testing::Not(testing::IsEmpty()));
    EXPECT_THAT(with(15, 0x7f), HasSubstr("chunk that ends beyond the file"));
    EXPECT_THAT(with(16, 'X'), HasSubstr("first chunk that is not JSON"));
    Bytes longer = good;
    longer.insert(longer.end(), 100, 0);
    EXPECT_EQ(error_of(longer), "") << "what follows the GLB is skipped";
}

TEST(GltfBroken, TruncationsAtEverySixteenth) {
    const Bytes good = complete_file().glb();
    for (std::size_t i = 0; i < 16; ++i) {
        const std::string error = error_of(std::span(good).first(good.size() * i / 16));
        EXPECT_THAT(error, HasSubstr("model.glb: ")) << i;
        EXPECT_EQ(error.find("ACCEPTED"), std::string::npos) << i;
    }
}

TEST(GltfBroken, FilesThatAreNoFiles) {
    const TempFolder folder;
    const auto error_of_path = [](const std::filesystem::path& path) -> std::string {
        try {
            (void)read_gltf(path);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(error_of_path(folder.path()), HasSubstr("is a directory"));
    EXPECT_THAT(error_of_path(folder / "none.glb"), HasSubstr("no such file"));
    EXPECT_THAT(error_of_path("/dev/null"), HasSubstr("not a regular file"));
    if (::geteuid() == 0) return; // root may read every file
    write_file(folder / "locked.glb", complete_file().glb());
    std::filesystem::permissions(folder / "locked.glb", std::filesystem::perms::none);
    EXPECT_THAT(error_of_path(folder / "locked.glb"), HasSubstr("cannot be opened"));
}

} // namespace
} // namespace hachure::assets
