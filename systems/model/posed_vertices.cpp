#include <hachure/runtime/geometry/morph.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/systems/model/posed_vertices.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>

namespace hachure {
namespace {

using assets::Model;
using assets::Node;
using assets::Primitive;

glm::mat4 local_matrix(const Node& node) {
    if (node.matrix) return *node.matrix;
    glm::mat4 matrix = glm::mat4_cast(node.rotation);
    for (int axis = 0; axis < 3; ++axis) matrix[axis] *= node.scale[axis];
    matrix[3] = glm::vec4(node.translation, 1.0f);
    return matrix;
}

std::vector<glm::vec3> morphed(const Primitive& primitive, std::vector<float> weights) {
    if (std::ranges::all_of(weights, [](float weight) { return weight == 0.0f; })) return primitive.positions;
    std::vector<geometry::MorphDeltas> deltas;
    for (const assets::MorphTarget& target : primitive.morph_targets) deltas.push_back({.positions = target.positions});
    weights.resize(deltas.size(), 0.0f);
    const geometry::MorphTargets targets(primitive.positions.size(), deltas);
    std::vector<glm::vec3> result(primitive.positions.size());
    geometry::MorphJob{
        .base_positions = primitive.positions, .targets = &targets, .weights = weights, .positions = result}
        .run();
    return result;
}

std::vector<glm::vec3> skinned(const Primitive& primitive, const std::vector<glm::vec3>& positions,
                               const std::vector<geometry::JointMatrix>& palette) {
    const geometry::SkinWeights weights =
        geometry::pack_skin_weights(positions.size(), palette.size() - 1, primitive.joints[0], primitive.weights[0],
                                    primitive.joints[1], primitive.weights[1]);
    std::vector<glm::vec3> result(positions.size());
    geometry::SkinJob{.rest_positions = positions, .weights = &weights, .palette = palette, .positions = result}.run();
    return result;
}

/// Of a skin with its joints where the nodes are; empty without one.
std::vector<geometry::JointMatrix> palette_of(const Model& model, const Node& node,
                                              const std::vector<glm::mat4>& matrices) {
    if (node.skin < 0) return {};
    const assets::Skin& skin = model.skins[static_cast<std::size_t>(node.skin)];
    std::vector<glm::mat4> joints;
    for (const std::int32_t joint : skin.joints) joints.push_back(matrices[static_cast<std::size_t>(joint)]);
    std::vector<geometry::JointMatrix> palette(joints.size() + 1);
    geometry::SkinPaletteJob{.joints = joints, .inverse_bind = skin.inverse_bind, .palette = palette}.run();
    return palette;
}

void append_used(const Primitive& primitive, const std::vector<glm::vec3>& positions, const glm::mat4& matrix,
                 std::vector<glm::vec3>& points) {
    std::vector<bool> used(positions.size(), false);
    for (const std::uint32_t i : primitive.indices) used[i] = true;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) points.push_back(glm::vec3(matrix * glm::vec4(positions[i], 1.0f)));
}

} // namespace

std::vector<glm::mat4> node_matrices(std::span<const Node> nodes) {
    std::vector<glm::mat4> matrices(nodes.size(), glm::mat4(1.0f));
    std::vector<std::int32_t> pending;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].parent < 0) pending.push_back(static_cast<std::int32_t>(i));
    while (!pending.empty()) {
        const auto index = static_cast<std::size_t>(pending.back());
        pending.pop_back();
        const Node& node = nodes[index];
        const glm::mat4 parent = node.parent < 0 ? glm::mat4(1.0f) : matrices[static_cast<std::size_t>(node.parent)];
        matrices[index] = parent * local_matrix(node);
        pending.insert(pending.end(), node.children.begin(), node.children.end());
    }
    return matrices;
}

std::vector<std::vector<glm::vec3>> posed_vertices(const Model& model, const Node& node,
                                                   const std::vector<glm::mat4>& matrices) {
    const assets::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
    const std::vector<float>& weights = node.morph_weights.empty() ? mesh.morph_weights : node.morph_weights;
    const std::vector<geometry::JointMatrix> palette = palette_of(model, node, matrices);
    std::vector<std::vector<glm::vec3>> result;
    for (const Primitive& primitive : mesh.primitives) {
        std::vector<glm::vec3> positions = morphed(primitive, weights);
        result.push_back(palette.empty() ? std::move(positions) : skinned(primitive, positions, palette));
    }
    return result;
}

std::vector<glm::vec3> scene_points(const Model& model, std::span<const Node> nodes) {
    const std::vector<glm::mat4> matrices = node_matrices(nodes);
    const auto& roots = model.scenes[static_cast<std::size_t>(model.default_scene)].roots;
    std::vector<std::int32_t> pending(roots.begin(), roots.end());
    std::vector<glm::vec3> points;
    while (!pending.empty()) {
        const auto index = static_cast<std::size_t>(pending.back());
        pending.pop_back();
        const Node& node = nodes[index];
        pending.insert(pending.end(), node.children.begin(), node.children.end());
        if (node.mesh < 0) continue;
        const auto& primitives = model.meshes[static_cast<std::size_t>(node.mesh)].primitives;
        const std::vector<std::vector<glm::vec3>> posed = posed_vertices(model, node, matrices);
        const glm::mat4 matrix = node.skin >= 0 ? glm::mat4(1.0f) : matrices[index];
        for (std::size_t p = 0; p < posed.size(); ++p) append_used(primitives[p], posed[p], matrix, points);
    }
    return points;
}

} // namespace hachure
