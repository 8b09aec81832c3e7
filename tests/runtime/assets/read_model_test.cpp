#include <hachure/runtime/assets/complete.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/temp_folder.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hachure::assets {
namespace {

std::string model_fault(const std::filesystem::path& file) {
    try {
        static_cast<void>(read_model(file));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(ReadModel, KindFollowsTheExtension) {
    for (const char* name : {"a.glb", "a.GLTF", "a.obj", "a.ply", "a.off", "a.stl", "a.ply.gz"})
        EXPECT_EQ(input_kind(name), InputKind::model) << name;
    for (const char* name : {"a.png", "a.JPG", "a.exr"}) EXPECT_EQ(input_kind(name), InputKind::image) << name;
    EXPECT_EQ(input_kind("a.mp4"), InputKind::video);
    for (const char* name : {"a.txt", "a", "obj", ".obj.txt"}) EXPECT_EQ(input_kind(name), InputKind::unknown) << name;
}

TEST(ReadModel, NamesTheFault) {
    const test::TempFolder folder;
    std::filesystem::create_directory(folder / "d.obj");
    EXPECT_EQ(model_fault(folder / "absent.obj"), (folder / "absent.obj").string() + ": there is no such file");
    EXPECT_EQ(model_fault(folder / "d.obj"), (folder / "d.obj").string() + ": is a folder, not a model");
    EXPECT_TRUE(model_fault(folder.write("t.txt", "text"))
                    .starts_with((folder / "t.txt").string() + ": is not a kind of model"));
}

TEST(ReadModel, GivesNormalsToAMeshWithout) {
    const test::TempFolder folder;
    const Model model = read_model(folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    const Primitive& primitive = model.meshes.at(0).primitives.at(0);
    EXPECT_TRUE(primitive.normals_computed);
    ASSERT_EQ(primitive.normals.size(), primitive.positions.size());
    for (const glm::vec3& normal : primitive.normals) EXPECT_NEAR(normal.z, 1.0f, 1e-6f);
}

/// A cube of shared corners: hard edges split every vertex, and everything that a vertex carries must follow it.
Primitive shared_cube() {
    Primitive cube;
    for (int i = 0; i < 8; ++i) cube.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    cube.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    MorphTarget target;
    for (const glm::vec3& p : cube.positions) {
        cube.tangents.emplace_back(p, 1.0f);
        cube.texcoords[0].emplace_back(p.x, p.y);
        cube.texcoords[1].emplace_back(p.y, p.z);
        cube.colors.emplace_back(p, 0.5f);
        cube.joints[0].emplace_back(p.x, p.y, p.z, 9);
        cube.weights[0].emplace_back(p, 0.25f);
        target.positions.push_back(2.0f * p);
    }
    cube.morph_targets.push_back(target);
    return cube;
}

TEST(CompleteNormals, KeepsEveryAttributeWithItsVertex) {
    Model model;
    model.meshes.push_back({"cube", {shared_cube()}, {}});
    complete_normals(model);
    const Primitive& cube = model.meshes[0].primitives[0];
    ASSERT_EQ(cube.positions.size(), 24u);
    ASSERT_EQ(cube.normals.size(), 24u);
    EXPECT_TRUE(cube.tangents.empty()) << "they belong to other normals";
    EXPECT_EQ(cube.indices.size(), 36u);
    ASSERT_EQ(cube.morph_targets[0].positions.size(), 24u);
    for (std::size_t i = 0; i < 24; ++i) {
        const glm::vec3 p = cube.positions[i];
        EXPECT_EQ(cube.texcoords[0][i], glm::vec2(p.x, p.y));
        EXPECT_EQ(cube.texcoords[1][i], glm::vec2(p.y, p.z));
        EXPECT_EQ(glm::vec3(cube.colors[i]), p);
        EXPECT_EQ(glm::vec3(cube.joints[0][i]), p);
        EXPECT_EQ(glm::vec3(cube.weights[0][i]), p);
        EXPECT_EQ(cube.morph_targets[0].positions[i], 2.0f * p);
        EXPECT_NEAR(glm::length(cube.normals[i]), 1.0f, 1e-5f);
    }
    for (std::size_t i = 0; i < cube.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return cube.positions[cube.indices[i + k]]; };
        const glm::vec3 face = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(glm::dot(face, cube.normals[cube.indices[i + k]]), 1.0f, 1e-5f);
    }
}

/// A picture seen through the cube: it is mirrored on the far side, and vertices of both sides are split.
TEST(CompleteTangents, KeepsEveryAttributeWithItsVertex) {
    Primitive cube = shared_cube();
    cube.tangents.clear();
    const auto texcoord = [](glm::vec3 p) { return glm::vec2(p.x + 0.25f * p.z, p.y + 0.75f * p.z); };
    cube.texcoords[1].clear();
    for (const glm::vec3& p : cube.positions) {
        cube.normals.push_back(glm::normalize(p - 0.5f));
        cube.texcoords[1].push_back(texcoord(p));
    }
    const Primitive source = cube;
    complete_tangents(cube, {.texture = 0, .texcoord = 1});
    ASSERT_GT(cube.positions.size(), 8u);
    ASSERT_EQ(cube.tangents.size(), cube.positions.size());
    for (std::size_t i = 0; i < cube.positions.size(); ++i) {
        const glm::vec3 p = cube.positions[i];
        EXPECT_NEAR(glm::dot(cube.normals[i], glm::normalize(p - 0.5f)), 1.0f, 1e-6f);
        EXPECT_EQ(cube.texcoords[1][i], texcoord(p));
        EXPECT_EQ(glm::vec3(cube.colors[i]), p);
        EXPECT_EQ(glm::vec3(cube.joints[0][i]), p);
        EXPECT_EQ(glm::vec3(cube.weights[0][i]), p);
        EXPECT_EQ(cube.morph_targets[0].positions[i], 2.0f * p);
    }
    for (std::size_t c = 0; c < cube.indices.size(); ++c)
        EXPECT_EQ(cube.positions[cube.indices[c]], source.positions[source.indices[c]]);
}

TEST(CompleteTangents, FollowTheTransformOfTheMap) {
    Primitive plane;
    plane.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    plane.normals.assign(3, {0, 0, 1});
    plane.texcoords[0] = {{0, 1}, {1, 1}, {0, 0}};
    plane.indices = {0, 1, 2};
    const auto tangent = [&](const TextureUse& use) {
        Primitive copy = plane;
        complete_tangents(copy, use);
        return copy.tangents.at(0);
    };
    EXPECT_EQ(tangent({}), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(tangent({.scale = {-2, 1}}), glm::vec4(-1, 0, 0, -1));
    // Coordinates are turned counter-clockwise, so the picture's u axis is turned clockwise.
    const glm::vec4 turned = tangent({.scale = {3, 3}, .rotation = 0.5f});
    EXPECT_NEAR(turned.x, std::cos(0.5f), 1e-6f);
    EXPECT_NEAR(turned.y, -std::sin(0.5f), 1e-6f);
    EXPECT_EQ(turned.w, 1.0f);
    for (const float huge : {std::numeric_limits<float>::max(), std::numeric_limits<float>::infinity()})
        EXPECT_NEAR(glm::length(glm::vec3(tangent({.offset = {huge, 0}, .scale = {huge, huge}, .rotation = huge}))),
                    1.0f, 1e-6f);
}

TEST(CompleteTangents, LeavesGivenTangentsAndUntexturedPrimitivesAlone) {
    Primitive given = shared_cube();
    const std::vector<glm::vec4> tangents = given.tangents;
    complete_tangents(given, {});
    EXPECT_EQ(given.tangents, tangents);
    given.tangents.clear();
    given.texcoords[1].clear();
    complete_tangents(given, {.texcoord = 1});
    EXPECT_TRUE(given.tangents.empty());
}

TEST(CompleteNormals, LeavesGivenNormalsAlone) {
    Primitive given = shared_cube();
    given.normals.assign(8, glm::vec3(0.0f, 0.0f, 1.0f));
    Model model;
    model.meshes.push_back({"cube", {given}, {}});
    complete_normals(model);
    EXPECT_EQ(model.meshes[0].primitives[0].positions.size(), 8u);
    EXPECT_FALSE(model.meshes[0].primitives[0].normals_computed);
}

} // namespace
} // namespace hachure::assets
