#include <hachure/systems/model/merge_primitives.h>
#include <hachure/systems/model/rest_pose.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace hachure {
namespace {

using assets::Model;
using assets::Node;
using assets::Primitive;

glm::dmat4 matrix_of(const Node& node) {
    return glm::translate(glm::dmat4(1.0), glm::dvec3(node.translation)) * glm::mat4_cast(glm::dquat(node.rotation)) *
           glm::scale(glm::dmat4(1.0), glm::dvec3(node.scale));
}

/// A strip bent by two joints, the second below the first; the mesh's node has a transform that must not count.
Model two_joints() {
    Model model;
    model.nodes.resize(4);
    model.nodes[0] = {.children = {1},
                      .translation = {0.5f, 1, 0},
                      .rotation = glm::angleAxis(0.4f, glm::normalize(glm::vec3(1, 2, 0)))};
    model.nodes[1] = {.parent = 0,
                      .children = {2},
                      .translation = {0, 1, 0},
                      .rotation = glm::angleAxis(0.9f, glm::vec3(0, 0, 1)),
                      .scale = {1, 1.5f, 0.8f}};
    model.nodes[2] = {.parent = 1};
    model.nodes[3] = {.translation = {100, 200, 300}, .mesh = 0, .skin = 0};
    model.skins.push_back({.joints = {0, 1},
                           .inverse_bind = {glm::translate(glm::mat4(1.0f), {0, 0.1f, 0}),
                                            glm::translate(glm::mat4(1.0f), {0.2f, -1, 0})}});
    Primitive primitive;
    for (int i = 0; i <= 10; ++i) {
        const float t = static_cast<float>(i) / 10.0f;
        primitive.positions.emplace_back(0.3f * t, 2.0f * t, 0.1f);
        primitive.normals.push_back(glm::normalize(glm::vec3(1, t, 0.3f)));
        primitive.tangents.emplace_back(glm::normalize(glm::vec3(-t, 1, 0.2f)), t < 0.5f ? 1.0f : -1.0f);
        primitive.joints[0].emplace_back(0, 1, 0, 0);
        primitive.weights[0].emplace_back(2.0f * (1.0f - t), 2.0f * t, 0, 0); // sums to 2
    }
    primitive.indices = {0, 1, 2};
    model.meshes.push_back({.primitives = {primitive}});
    return model;
}

TEST(RestPose, SkinsWithTheJointsWhereTheNodesPutThem) {
    const Model model = two_joints();
    const std::vector<Primitive> posed = rest_pose(model, model.nodes[3], node_matrices(model.nodes));
    const glm::dmat4 joint0 = matrix_of(model.nodes[0]) * glm::dmat4(model.skins[0].inverse_bind[0]);
    const glm::dmat4 joint1 =
        matrix_of(model.nodes[0]) * matrix_of(model.nodes[1]) * glm::dmat4(model.skins[0].inverse_bind[1]);
    const Primitive& source = model.meshes[0].primitives[0];
    ASSERT_EQ(posed.size(), 1u);
    for (std::size_t i = 0; i < source.positions.size(); ++i) {
        const double t = static_cast<double>(i) / 10.0;
        const glm::dmat4 blended = (1.0 - t) * joint0 + t * joint1;
        const glm::dvec3 position(blended * glm::dvec4(source.positions[i], 1.0f));
        const glm::dvec3 normal =
            glm::normalize(glm::inverse(glm::transpose(glm::dmat3(blended))) * glm::dvec3(source.normals[i]));
        EXPECT_LT(glm::distance(glm::dvec3(posed[0].positions[i]), position), 1e-5) << i;
        EXPECT_LT(glm::distance(glm::dvec3(posed[0].normals[i]), normal), 1e-5) << i;
        const glm::dvec3 tangent = glm::normalize(glm::dmat3(blended) * glm::dvec3(source.tangents[i]));
        EXPECT_LT(glm::distance(glm::dvec3(posed[0].tangents[i]), tangent), 1e-5) << i;
        EXPECT_EQ(posed[0].tangents[i].w, source.tangents[i].w) << i;
    }
    EXPECT_EQ(posed[0].indices, source.indices);
}

TEST(RestPose, AVertexWithoutWeightStays) {
    Model model = two_joints();
    model.meshes[0].primitives[0].weights[0][4] = glm::vec4(0.0f);
    const glm::vec3 before = model.meshes[0].primitives[0].positions[4];
    EXPECT_EQ(rest_pose(model, model.nodes[3], node_matrices(model.nodes))[0].positions[4], before);
}

TEST(RestPose, AFlattenedJointKeepsFiniteNormals) {
    Model model = two_joints();
    model.nodes[0].scale = {1, 0, 1};
    const std::vector<Primitive> posed = rest_pose(model, model.nodes[3], node_matrices(model.nodes));
    for (const glm::vec3& normal : posed[0].normals) EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f);
}

TEST(RestPose, MorphsBeforeItSkinsAndTheNodesWeightsGoBeforeTheMeshs) {
    Model model = two_joints();
    Primitive& primitive = model.meshes[0].primitives[0];
    assets::MorphTarget target;
    target.positions.assign(primitive.positions.size(), {0.5f, 0, 0});
    target.tangents.assign(primitive.positions.size(), {0, -0.5f, 1});
    primitive.morph_targets = {target};
    model.meshes[0].morph_weights = {1.0f};
    Model moved = two_joints();
    for (const float weight : {1.0f, 0.25f}) {
        if (weight != 1.0f) model.nodes[3].morph_weights = {weight};
        Primitive& by_hand = moved.meshes[0].primitives[0];
        for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
            by_hand.positions[i] = primitive.positions[i] + weight * target.positions[i];
            by_hand.tangents[i] = primitive.tangents[i] + glm::vec4(weight * target.tangents[i], 0.0f);
        }
        const Primitive got = rest_pose(model, model.nodes[3], node_matrices(model.nodes))[0];
        const Primitive wanted = rest_pose(moved, moved.nodes[3], node_matrices(moved.nodes))[0];
        for (std::size_t i = 0; i < got.positions.size(); ++i) {
            EXPECT_LT(glm::distance(got.positions[i], wanted.positions[i]), 1e-5f);
            EXPECT_LT(glm::distance(got.tangents[i], wanted.tangents[i]), 1e-5f);
        }
    }
}

TEST(NodeMatrices, FollowTheTreeAndItsMatrices) {
    Model model = two_joints();
    model.nodes[2].matrix = glm::mat4(1, 0, 0, 0, 0.5f, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1); // sheared
    const std::vector<glm::mat4> matrices = node_matrices(model.nodes);
    const glm::dmat4 wanted =
        matrix_of(model.nodes[0]) * matrix_of(model.nodes[1]) * glm::dmat4(*model.nodes[2].matrix);
    for (int i = 0; i < 4; ++i) EXPECT_LT(glm::distance(glm::dvec4(matrices[2][i]), wanted[i]), 1e-5);
}

TEST(MergePrimitives, PutsNeutralValuesWhereOnlySomeHaveThem) {
    Primitive bare, rich;
    bare.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    bare.indices = {0, 1, 2};
    bare.material = 7;
    rich = bare;
    rich.material = 3;
    rich.indices = {2, 1, 0, 0, 1, 2};
    rich.normals.assign(3, {0, 0, 1});
    rich.texcoords[0].assign(3, {0.5f, 0.25f});
    rich.colors.assign(3, {0.1f, 0.2f, 0.3f, 0.4f});
    const std::vector<Primitive> primitives{bare, rich};
    const SurfaceMesh mesh = merge_primitives(
        "both", primitives, [](std::int32_t index) { return SurfaceMaterial{.name = std::to_string(index)}; });
    EXPECT_EQ(mesh.name, "both");
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 5, 4, 3, 3, 4, 5}));
    ASSERT_EQ(mesh.submeshes.size(), 2u);
    EXPECT_EQ(mesh.submeshes[0].material.name, "7");
    EXPECT_EQ(mesh.submeshes[1].material.name, "3");
    EXPECT_EQ(mesh.submeshes[1].first_index, 3u);
    EXPECT_EQ(mesh.submeshes[1].index_count, 6u);
    ASSERT_EQ(mesh.colors.size(), 6u);
    EXPECT_EQ(mesh.colors[0], glm::vec4(1.0f));
    EXPECT_EQ(mesh.colors[4], rich.colors[0]);
    EXPECT_EQ(mesh.texcoords[1], glm::vec2(0.0f));
    EXPECT_EQ(mesh.texcoords[5], glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(mesh.normals.size(), 6u);
    EXPECT_TRUE(merge_primitives("bare", std::span(primitives).first(1), [](std::int32_t) {
                    return SurfaceMaterial{};
                }).colors.empty());
}

} // namespace
} // namespace hachure
