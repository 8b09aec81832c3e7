#include <hachure/systems/model/posed_vertices.h>

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
        primitive.joints[0].emplace_back(0, 1, 0, 0);
        primitive.weights[0].emplace_back(2.0f * (1.0f - t), 2.0f * t, 0, 0); // sums to 2
    }
    primitive.indices = {0, 1, 2};
    model.meshes.push_back({.primitives = {primitive}});
    return model;
}

TEST(PosedVertices, AreSkinnedWithTheJointsWhereTheNodesPutThem) {
    const Model model = two_joints();
    const auto posed = posed_vertices(model, model.nodes[3], node_matrices(model.nodes));
    const glm::dmat4 joint0 = matrix_of(model.nodes[0]) * glm::dmat4(model.skins[0].inverse_bind[0]);
    const glm::dmat4 joint1 =
        matrix_of(model.nodes[0]) * matrix_of(model.nodes[1]) * glm::dmat4(model.skins[0].inverse_bind[1]);
    const Primitive& source = model.meshes[0].primitives[0];
    ASSERT_EQ(posed.size(), 1u);
    for (std::size_t i = 0; i < source.positions.size(); ++i) {
        const double t = static_cast<double>(i) / 10.0;
        const glm::dmat4 blended = (1.0 - t) * joint0 + t * joint1;
        const glm::dvec3 position(blended * glm::dvec4(source.positions[i], 1.0f));
        EXPECT_LT(glm::distance(glm::dvec3(posed[0][i]), position), 1e-5) << i;
    }
}

TEST(PosedVertices, OneWithoutWeightStays) {
    Model model = two_joints();
    model.meshes[0].primitives[0].weights[0][4] = glm::vec4(0.0f);
    const glm::vec3 before = model.meshes[0].primitives[0].positions[4];
    EXPECT_EQ(posed_vertices(model, model.nodes[3], node_matrices(model.nodes))[0][4], before);
}

TEST(PosedVertices, AreMorphedFirstAndTheNodesWeightsGoBeforeTheMeshs) {
    Model model = two_joints();
    Primitive& primitive = model.meshes[0].primitives[0];
    assets::MorphTarget target;
    target.positions.assign(primitive.positions.size(), {0.5f, 0, 0});
    primitive.morph_targets = {target};
    model.meshes[0].morph_weights = {1.0f};
    Model moved = two_joints();
    for (const float weight : {1.0f, 0.25f}) {
        if (weight != 1.0f) model.nodes[3].morph_weights = {weight};
        for (std::size_t i = 0; i < primitive.positions.size(); ++i)
            moved.meshes[0].primitives[0].positions[i] = primitive.positions[i] + weight * target.positions[i];
        const auto got = posed_vertices(model, model.nodes[3], node_matrices(model.nodes))[0];
        const auto wanted = posed_vertices(moved, moved.nodes[3], node_matrices(moved.nodes))[0];
        for (std::size_t i = 0; i < got.size(); ++i) EXPECT_LT(glm::distance(got[i], wanted[i]), 1e-5f);
    }
}

TEST(ScenePoints, AreTheUsedVerticesOfTheScene) {
    Model model = two_joints();
    model.scenes.push_back({"scene", {0, 3}});
    const std::vector<glm::vec3> points = scene_points(model, model.nodes);
    const auto posed = posed_vertices(model, model.nodes[3], node_matrices(model.nodes));
    EXPECT_EQ(points, std::vector<glm::vec3>(posed[0].begin(), posed[0].begin() + 3)) << "its one triangle";
    model.scenes[0].roots = {0};
    EXPECT_TRUE(scene_points(model, model.nodes).empty()) << "the mesh is in no scene";
}

TEST(NodeMatrices, FollowTheTreeAndItsMatrices) {
    Model model = two_joints();
    model.nodes[2].matrix = glm::mat4(1, 0, 0, 0, 0.5f, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1); // sheared
    const std::vector<glm::mat4> matrices = node_matrices(model.nodes);
    const glm::dmat4 wanted =
        matrix_of(model.nodes[0]) * matrix_of(model.nodes[1]) * glm::dmat4(*model.nodes[2].matrix);
    for (int i = 0; i < 4; ++i) EXPECT_LT(glm::distance(glm::dvec4(matrices[2][i]), wanted[i]), 1e-5);
}

} // namespace
} // namespace hachure
