#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <cmath>
#include <random>

#include "gltf_builder.h"

namespace hachure::assets {
namespace {

using namespace gltf_testing;
using testing::HasSubstr;

constexpr std::size_t vertices = 300;

Bytes encode_vertices(const void* data, std::size_t count, std::size_t stride) {
    Bytes out(meshopt_encodeVertexBufferBound(count, stride));
    out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), data, count, stride));
    return out;
}

/// A view of `data` compressed, over a fallback buffer that has no bytes, as gltfpack writes it.
int compressed_view(GltfBuilder& builder, const Bytes& data, std::size_t count, std::size_t stride, const char* mode,
                    const char* filter = "NONE") {
    const int plain = builder.view(data);
    json view = builder.root["bufferViews"][static_cast<std::size_t>(plain)];
    view["byteStride"] = stride;
    view["count"] = count;
    view["mode"] = mode;
    view["filter"] = filter;
    json wrapper = {{"buffer", 1}, {"byteOffset", 0}, {"byteLength", count * stride}};
    if (std::string(mode) == "ATTRIBUTES") wrapper["byteStride"] = stride;
    wrapper["extensions"]["EXT_meshopt_compression"] = view;
    builder.root["bufferViews"][static_cast<std::size_t>(plain)] = wrapper;
    return plain;
}

void finish(GltfBuilder& builder) {
    builder.root["extensionsUsed"] = builder.root["extensionsRequired"] = {"EXT_meshopt_compression"};
    builder.root["buffers"] = {
        {{"byteLength", builder.binary.size()}},
        {{"byteLength", 1'000'000}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
}

std::vector<glm::vec3> random_positions() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> coordinate(-10, 10);
    std::vector<glm::vec3> positions(vertices);
    for (auto& p : positions) p = {coordinate(random), coordinate(random), coordinate(random)};
    return positions;
}

std::vector<std::uint32_t> grid_triangles() {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i + 2 < vertices; ++i) indices.insert(indices.end(), {i, i + 1, i + 2});
    return indices;
}

/// A mesh whose positions and indices are both compressed.
GltfBuilder compressed_mesh(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices,
                            const char* mode) {
    GltfBuilder builder;
    const Bytes encoded = encode_vertices(positions.data(), vertices, 12);
    const int position =
        builder.accessor(compressed_view(builder, encoded, vertices, 12, "ATTRIBUTES"), f32, "VEC3", vertices);
    meshopt_encodeIndexVersion(1);
    Bytes data(std::max(meshopt_encodeIndexBufferBound(indices.size(), vertices),
                        meshopt_encodeIndexSequenceBound(indices.size(), vertices)));
    data.resize(std::string(mode) == "TRIANGLES"
                    ? meshopt_encodeIndexBuffer(data.data(), data.size(), indices.data(), indices.size())
                    : meshopt_encodeIndexSequence(data.data(), data.size(), indices.data(), indices.size()));
    const int index =
        builder.accessor(compressed_view(builder, data, indices.size(), 4, mode), u32, "SCALAR", indices.size());
    builder.mesh({{"POSITION", position}}, index);
    finish(builder);
    return builder;
}

TEST(GltfMeshopt, DecodesAttributesAndIndices) {
    const auto positions = random_positions();
    const auto indices = grid_triangles();
    for (const char* mode : {"TRIANGLES", "INDICES"}) {
        const Model model = compressed_mesh(positions, indices, mode).read();
        const Primitive& p = model.meshes.at(0).primitives.at(0);
        EXPECT_EQ(p.positions, positions);
        ASSERT_EQ(p.indices.size(), indices.size());
        // The triangle codec may turn a triangle, not mirror it.
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            std::size_t turn = 0;
            while (turn < 3 && p.indices[i + turn] != indices[i]) ++turn;
            for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(p.indices[i + (turn + k) % 3], indices[i + k]) << mode;
        }
        EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
    }
}

TEST(GltfMeshopt, DecodesOctahedralNormals) {
    std::vector<glm::vec4> normals(vertices);
    for (auto& n : normals) n = glm::vec4(0);
    const auto directions = random_positions();
    for (std::size_t i = 0; i < vertices; ++i) normals[i] = glm::vec4(glm::normalize(directions[i]), 0);
    for (const int bits : {8, 16}) {
        const std::size_t stride = bits == 8 ? 4 : 8;
        Bytes filtered(vertices * stride);
        meshopt_encodeFilterOct(filtered.data(), vertices, stride, bits, &normals[0].x);
        GltfBuilder builder;
        const int position = builder.floats(std::vector<float>(vertices * 3, 1.0f), 3);
        const int normal = builder.accessor(compressed_view(builder, encode_vertices(filtered.data(), vertices, stride),
                                                            vertices, stride, "ATTRIBUTES", "OCTAHEDRAL"),
                                            bits == 8 ? i8 : i16, "VEC3", vertices);
        builder.root["accessors"][static_cast<std::size_t>(normal)]["normalized"] = true;
        builder.mesh({{"POSITION", position}, {"NORMAL", normal}});
        finish(builder);
        const Model model = builder.read();
        const Primitive& p = model.meshes.at(0).primitives.at(0);
        ASSERT_EQ(p.normals.size(), vertices);
        for (std::size_t i = 0; i < vertices; ++i)
            EXPECT_NEAR(glm::distance(p.normals[i], glm::vec3(normals[i])), 0.0f, bits == 8 ? 0.03f : 1e-3f);
    }
}

/// Reads one VEC4 rotation track, compressed.
std::vector<float> read_rotations(const Bytes& encoded, std::size_t stride, const char* filter, Component component) {
    GltfBuilder builder;
    std::vector<float> times(vertices);
    for (std::size_t i = 0; i < vertices; ++i) times[i] = static_cast<float>(i);
    const int input = builder.floats(times, 1);
    const int output = builder.accessor(compressed_view(builder, encoded, vertices, stride, "ATTRIBUTES", filter),
                                        component, "VEC4", vertices);
    if (component != f32) builder.root["accessors"][static_cast<std::size_t>(output)]["normalized"] = true;
    builder.add("nodes", json::object());
    builder.add("animations", {{"samplers", {{{"input", input}, {"output", output}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}});
    finish(builder);
    return builder.read().animations.at(0).channels.at(0).values;
}

TEST(GltfMeshopt, DecodesQuaternionsAndExponents) {
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    std::vector<glm::vec4> rotations(vertices);
    for (auto& q : rotations)
        q = glm::normalize(glm::vec4(normal(random), normal(random), normal(random), normal(random)));

    Bytes quaternions(vertices * 8);
    meshopt_encodeFilterQuat(quaternions.data(), vertices, 8, 16, &rotations[0].x);
    const auto decoded = read_rotations(encode_vertices(quaternions.data(), vertices, 8), 8, "QUATERNION", i16);
    Bytes exponents(vertices * 16);
    meshopt_encodeFilterExp(exponents.data(), vertices, 16, 20, &rotations[0].x);
    const auto floats = read_rotations(encode_vertices(exponents.data(), vertices, 16), 16, "EXPONENTIAL", f32);
    for (std::size_t i = 0; i < vertices; ++i) {
        const glm::vec4 q(decoded[4 * i], decoded[4 * i + 1], decoded[4 * i + 2], decoded[4 * i + 3]);
        EXPECT_NEAR(std::abs(glm::dot(q, rotations[i])), 1.0f, 1e-3f) << "the same rotation, either sign";
        for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(floats[4 * i + k], rotations[i][static_cast<int>(k)], 1e-4f);
    }
}

TEST(GltfMeshopt, RefusesViewsThatContradictThemselves) {
    const auto with = [](auto edit) {
        GltfBuilder builder = compressed_mesh(random_positions(), grid_triangles(), "TRIANGLES");
        edit(builder.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"],
             builder.root["bufferViews"][1]["extensions"]["EXT_meshopt_compression"]);
        return error_of(builder);
    };
    EXPECT_THAT(with([](json& a, json&) { a["byteStride"] = 10; }), HasSubstr("multiple of 4"));
    EXPECT_THAT(with([](json& a, json&) { a["byteStride"] = 300; }), HasSubstr("/byteStride"));
    EXPECT_THAT(with([](json& a, json&) { a["count"] = vertices + 1; }), HasSubstr("decompresses to"));
    EXPECT_THAT(with([](json& a, json&) { a["filter"] = "OCTAHEDRAL"; }), HasSubstr("octahedral"));
    EXPECT_THAT(with([](json& a, json&) { a["mode"] = "NEW"; }), HasSubstr("must be one of"));
    EXPECT_THAT(with([](json& a, json&) { a["byteLength"] = 1'000'000; }), HasSubstr("ends beyond its buffer"));
    EXPECT_THAT(with([](json& a, json&) { a["byteLength"] = 20; }), HasSubstr("broken compressed data"));
    EXPECT_THAT(with([](json&, json& b) { b["byteStride"] = 8; }), HasSubstr("neither 2 nor 4"));
    EXPECT_THAT(with([](json&, json& b) { b["filter"] = "QUATERNION"; }), HasSubstr("filter on compressed indices"));
}

} // namespace
} // namespace hachure::assets
