#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using namespace gltf_testing;
using testing::HasSubstr;

const Primitive& only_primitive(const Model& model) { return model.meshes.at(0).primitives.at(0); }

glm::vec3 triangle_normal(const Primitive& p, std::size_t triangle) {
    const auto corner = [&](std::size_t i) { return p.positions[p.indices[3 * triangle + i]]; };
    return glm::cross(corner(1) - corner(0), corner(2) - corner(0));
}

/// A zigzag in the plane z = 0 whose first triangle faces +Z, or a fan around its first vertex.
std::vector<float> planar_positions(int mode, int vertices) {
    std::vector<float> positions;
    for (int i = 0; i < vertices; ++i) {
        const double angle = i * 0.2;
        if (mode == 5)
            positions.insert(positions.end(), {static_cast<float>(i / 2), static_cast<float>(i % 2 == 0 ? 1 : 0), 0});
        else if (i == 0)
            positions.insert(positions.end(), {0, 0, 0});
        else
            positions.insert(positions.end(),
                             {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0});
    }
    return positions;
}

TEST(GltfMesh, UnrollsStripsAndFansWithOneWinding) {
    for (const int mode : {5, 6}) {
        for (const bool indexed : {false, true}) {
            GltfBuilder builder;
            const int positions = builder.floats(planar_positions(mode, 9), 3);
            const int indices = indexed ? builder.shorts({0, 1, 2, 3, 4, 5, 6, 7, 8}) : -1;
            builder.mesh({{"POSITION", positions}}, indices, mode);
            const Model model = builder.read();
            const Primitive& p = only_primitive(model);
            ASSERT_EQ(p.indices.size(), 7u * 3u);
            const float first = triangle_normal(p, 0).z;
            EXPECT_NE(first, 0.0f);
            for (std::size_t i = 0; i < 7; ++i) EXPECT_GT(triangle_normal(p, i).z * first, 0.0f) << mode << " " << i;
        }
    }
}

TEST(GltfMesh, KeepsTheFirstTriangleOfAStripAsItIsWritten) {
    GltfBuilder builder;
    const int positions = builder.floats(planar_positions(5, 4), 3);
    builder.mesh({{"POSITION", positions}}, -1, 5);
    // glTF 2.0, section 3.7.2.1: p_i = {v_i, v_{i+1+i%2}, v_{i+2-i%2}}.
    EXPECT_EQ(only_primitive(builder.read()).indices, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
}

TEST(GltfMesh, ReadsFansFromTheirCentre) {
    GltfBuilder builder;
    builder.mesh({{"POSITION", builder.floats(planar_positions(6, 4), 3)}}, -1, 6);
    EXPECT_EQ(only_primitive(builder.read()).indices, (std::vector<std::uint32_t>{1, 2, 0, 2, 3, 0}));
}

TEST(GltfMesh, ReadsIndicesOfEveryUnsignedType) {
    for (const Component type : {u8, u16, u32}) {
        GltfBuilder builder;
        const int positions = builder.triangle_positions();
        const Bytes data = type == u8    ? Bytes{2, 0, 1}
                           : type == u16 ? bytes_of(std::vector<std::uint16_t>{2, 0, 1})
                                         : bytes_of(std::vector<std::uint32_t>{2, 0, 1});
        const int indices = builder.accessor(builder.view(data), type, "SCALAR", 3);
        builder.mesh({{"POSITION", positions}}, indices);
        EXPECT_EQ(only_primitive(builder.read()).indices, (std::vector<std::uint32_t>{2, 0, 1}));
    }
}

TEST(GltfMesh, ReadsSparseIndicesWithoutAView) {
    GltfBuilder builder;
    const int positions = builder.triangle_positions();
    const int indices = builder.accessor(-1, u16, "SCALAR", 3);
    const int which = builder.view({1, 2});
    const int values = builder.view(bytes_of(std::vector<std::uint16_t>{1, 2}));
    builder.root["accessors"][static_cast<std::size_t>(indices)]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", which}, {"componentType", 5121}}},
        {"values", {{"bufferView", values}}}};
    builder.mesh({{"POSITION", positions}}, indices);
    EXPECT_EQ(only_primitive(builder.read()).indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(GltfMesh, ReadsEveryAttribute) {
    GltfBuilder builder;
    json attributes = {{"POSITION", builder.triangle_positions()},
                       {"NORMAL", builder.floats({0, 0, 2, 0, 3, 0, 1e-30f, 0, 0}, 3)},
                       {"TANGENT", builder.floats({2, 0, 0, 1, 0, 1, 0, -1, 0, 0, 1, -0.9f}, 4)},
                       {"TEXCOORD_0", builder.floats({0, 0, 1, 0, 0, 1}, 2)},
                       {"TEXCOORD_1", builder.floats({5, 6, 7, 8, 9, 10}, 2)},
                       {"COLOR_0", builder.floats({1, 0, 0, 0, 1, 0, 0, 0, 1}, 3)}};
    builder.mesh(attributes);
    const Model model = builder.read();
    const Primitive& p = only_primitive(model);
    EXPECT_EQ(broken_promise(model), "");
    EXPECT_EQ(p.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
    EXPECT_EQ(p.tangents, (std::vector<glm::vec4>{{1, 0, 0, 1}, {0, 1, 0, -1}, {0, 0, 1, -1}}));
    EXPECT_EQ(p.texcoords[1][2], glm::vec2(9, 10));
    EXPECT_EQ(p.colors[1], glm::vec4(0, 1, 0, 1));
    EXPECT_FALSE(p.normals_computed);
    EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
}

TEST(GltfMesh, ReadsQuantizedAttributes) {
    GltfBuilder builder;
    const int positions = builder.accessor(
        builder.view(bytes_of(std::vector<std::uint16_t>{0, 0, 0, 0, 1000, 0, 0, 0, 0, 65535, 0, 0}), 8), u16, "VEC3",
        3);
    const int normals = builder.accessor(builder.view({0, 0, 127, 0, 0, 0, 127, 0, 0, 129, 0, 0}, 4), i8, "VEC3", 3);
    builder.root["accessors"][static_cast<std::size_t>(normals)]["normalized"] = true;
    const int texcoords = builder.accessor(
        builder.view(bytes_of(std::vector<std::int16_t>{0, 0, 32767, -32768, 16384, 1}), 4), i16, "VEC2", 3);
    builder.root["accessors"][static_cast<std::size_t>(texcoords)]["normalized"] = true;
    builder.root["extensionsUsed"] = builder.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    builder.mesh({{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", texcoords}});
    const Model model = builder.read();
    const Primitive& p = only_primitive(model);
    EXPECT_EQ(broken_promise(model), "");
    EXPECT_EQ(p.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1000, 0, 0}, {0, 65535, 0}}));
    EXPECT_EQ(p.normals[2], glm::vec3(0, -1, 0)) << "-127 of 127";
    EXPECT_EQ(p.texcoords[0][1], glm::vec2(1, -1)) << "-32768 is clamped to -1";
    EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
}

TEST(GltfMesh, ReadsMorphTargetsWithTheirNames) {
    GltfBuilder builder;
    const int displaced = builder.floats({0, 0, 1, 0, 0, 2, 0, 0, 3}, 3);
    const int normals = builder.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
    builder.mesh({{"POSITION", builder.triangle_positions()}, {"NORMAL", normals}});
    json& mesh = builder.root["meshes"][0];
    mesh["primitives"][0]["targets"] = {{{"POSITION", displaced}, {"NORMAL", displaced}, {"TANGENT", displaced}},
                                        json::object()};
    mesh["weights"] = {0.25, 0.5};
    mesh["extras"]["targetNames"] = {"smile", "blink"};
    const Model model = builder.read();
    const Primitive& p = only_primitive(model);
    EXPECT_EQ(broken_promise(model), "");
    ASSERT_EQ(p.morph_targets.size(), 2u);
    EXPECT_EQ(p.morph_targets[0].name, "smile");
    EXPECT_EQ(p.morph_targets[1].name, "blink");
    EXPECT_EQ(p.morph_targets[0].positions[2], glm::vec3(0, 0, 3));
    EXPECT_EQ(p.morph_targets[0].normals.size(), 3u);
    EXPECT_TRUE(p.morph_targets[0].tangents.empty()) << "the base has none";
    EXPECT_TRUE(p.morph_targets[1].positions.empty());
    EXPECT_EQ(model.meshes[0].morph_weights, (std::vector<float>{0.25f, 0.5f}));
}

TEST(GltfMesh, LeavesNormalsOutWhenTheyAreMissingOrUnusable) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::vector<float>> unusable = {
        {0, 0, 1, 0, 0, 0, 0, 0, 1}, {0, 0, 1, 0, nan, 0, 0, 0, 1}, {0, 0, 1, 0, 0, 1}};
    for (const auto& normals : unusable) {
        GltfBuilder builder;
        builder.mesh({{"POSITION", builder.triangle_positions()}, {"NORMAL", builder.floats(normals, 3)}});
        const Model model = builder.read();
        EXPECT_TRUE(only_primitive(model).normals.empty());
        EXPECT_EQ(model.warnings.size(), 1u) << warnings_of(model);
    }
    GltfBuilder builder;
    builder.mesh({{"POSITION", builder.triangle_positions()}});
    EXPECT_TRUE(builder.read().warnings.empty());
}

TEST(GltfMesh, RepairsWhatIsNotFiniteInOtherAttributes) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    GltfBuilder builder;
    builder.mesh({{"POSITION", builder.triangle_positions()},
                  {"TEXCOORD_0", builder.floats({0, nan, 1, 0, 0, 1}, 2)},
                  {"COLOR_0", builder.floats({1, 0, inf, 0, 1, 0, 0, 0, 1}, 3)},
                  {"TANGENT", builder.floats({1, 0, 0, 1, 1, 0, 0, nan, 1, 0, 0, 1}, 4)}});
    const Model model = builder.read();
    EXPECT_EQ(broken_promise(model), "");
    EXPECT_EQ(model.warnings.size(), 3u) << warnings_of(model);
    EXPECT_TRUE(only_primitive(model).tangents.empty());
    EXPECT_EQ(only_primitive(model).colors[0], glm::vec4(1, 0, 0, 1));
}

TEST(GltfMesh, SkipsWhatItDoesNotDrawAndSaysSoOnce) {
    GltfBuilder builder;
    const int positions = builder.triangle_positions();
    for (const int mode : {0, 1, 2, 3, 0, 1}) builder.mesh({{"POSITION", positions}}, -1, mode);
    builder.mesh({{"POSITION", positions}}, -1, 9);
    builder.mesh({{"NORMAL", positions}});
    const Model model = builder.read();
    EXPECT_EQ(broken_promise(model), "");
    EXPECT_EQ(model.meshes.size(), 8u) << "nodes keep their mesh";
    for (const Mesh& mesh : model.meshes) EXPECT_TRUE(mesh.primitives.empty());
    EXPECT_EQ(model.warnings.size(), 3u) << warnings_of(model);
    EXPECT_THAT(warnings_of(model), HasSubstr("points and lines are skipped (first at /meshes/0/primitives/0)"));
}

TEST(GltfMesh, DropsVerticesThatMakeNoTriangle) {
    GltfBuilder builder;
    builder.mesh({{"POSITION", builder.triangle_positions()}}, builder.shorts({0, 1, 2, 0, 1}));
    builder.mesh({{"POSITION", builder.triangle_positions()}}, builder.shorts({0, 1}));
    const Model model = builder.read();
    EXPECT_EQ(model.meshes[0].primitives[0].indices.size(), 3u);
    EXPECT_TRUE(model.meshes[1].primitives.empty());
}

} // namespace
} // namespace hachure::assets
