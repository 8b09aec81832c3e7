#include <hachure/systems/model/rest_pose.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/quaternion.hpp>

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

void apply_morph_weights(Primitive& primitive, const std::vector<float>& weights) {
    for (std::size_t t = 0; t < weights.size() && t < primitive.morph_targets.size(); ++t) {
        if (weights[t] == 0.0f) continue;
        const assets::MorphTarget& target = primitive.morph_targets[t];
        for (std::size_t i = 0; i < target.positions.size(); ++i)
            primitive.positions[i] += weights[t] * target.positions[i];
        for (std::size_t i = 0; i < target.normals.size() && i < primitive.normals.size(); ++i)
            primitive.normals[i] += weights[t] * target.normals[i];
        for (std::size_t i = 0; i < target.tangents.size() && i < primitive.tangents.size(); ++i)
            primitive.tangents[i] += glm::vec4(weights[t] * target.tangents[i], 0.0f);
    }
    for (glm::vec3& normal : primitive.normals) {
        const float length = glm::length(normal);
        normal = length > 0.0f ? normal / length : glm::vec3(0.0f, 1.0f, 0.0f);
    }
    for (glm::vec4& tangent : primitive.tangents) {
        const float length = glm::length(glm::vec3(tangent));
        tangent = glm::vec4(length > 0.0f ? glm::vec3(tangent) / length : glm::vec3(1.0f, 0.0f, 0.0f), tangent.w);
    }
}

/// Sum of weight times joint matrix over the 4 or 8 influences of a vertex; false when no influence has weight.
bool blend_joints(const Primitive& primitive, std::size_t vertex, const std::vector<glm::mat4>& joints,
                  glm::mat4& blended) {
    blended = glm::mat4(0.0f);
    float total = 0.0f;
    for (int set = 0; set < 2; ++set) {
        if (primitive.joints[set].empty() || primitive.weights[set].empty()) continue;
        for (int k = 0; k < 4; ++k) {
            const float weight = primitive.weights[set][vertex][k];
            if (weight == 0.0f) continue;
            blended += weight * joints[primitive.joints[set][vertex][k]];
            total += weight;
        }
    }
    if (!(total > 0.0f)) return false;
    blended /= total;
    return true;
}

void skin_tangent(glm::vec4& tangent, const glm::mat4& blended) {
    const glm::vec3 turned = glm::mat3(blended) * glm::vec3(tangent);
    const float length = glm::length(turned);
    if (length > 0.0f) tangent = glm::vec4(turned / length, tangent.w);
}

void apply_skin(Primitive& primitive, const std::vector<glm::mat4>& joints) {
    glm::mat4 blended;
    for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
        if (!blend_joints(primitive, i, joints, blended)) continue;
        primitive.positions[i] = glm::vec3(blended * glm::vec4(primitive.positions[i], 1.0f));
        if (i < primitive.tangents.size()) skin_tangent(primitive.tangents[i], blended);
        if (i >= primitive.normals.size()) continue;
        // Cofactors instead of the inverse transpose: defined for flattened joints too.
        const glm::vec3 x(blended[0]), y(blended[1]), z(blended[2]);
        const glm::vec3 n = primitive.normals[i];
        const glm::vec3 normal = n.x * glm::cross(y, z) + n.y * glm::cross(z, x) + n.z * glm::cross(x, y);
        const float length = glm::length(normal);
        if (length > 0.0f) primitive.normals[i] = normal / length;
    }
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

std::vector<Primitive> rest_pose(const Model& model, const Node& node, const std::vector<glm::mat4>& matrices) {
    const assets::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
    std::vector<Primitive> primitives = mesh.primitives;
    const std::vector<float>& weights = node.morph_weights.empty() ? mesh.morph_weights : node.morph_weights;
    std::vector<glm::mat4> joints;
    if (node.skin >= 0) {
        const assets::Skin& skin = model.skins[static_cast<std::size_t>(node.skin)];
        for (std::size_t j = 0; j < skin.joints.size(); ++j)
            joints.push_back(matrices[static_cast<std::size_t>(skin.joints[j])] * skin.inverse_bind[j]);
    }
    for (Primitive& primitive : primitives) {
        apply_morph_weights(primitive, weights);
        if (!joints.empty()) apply_skin(primitive, joints);
    }
    return primitives;
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
        const glm::mat4 matrix = node.skin >= 0 ? glm::mat4(1.0f) : matrices[index];
        for (const Primitive& primitive : rest_pose(model, node, matrices)) {
            std::vector<bool> used(primitive.positions.size(), false);
            for (const std::uint32_t i : primitive.indices) used[i] = true;
            for (std::size_t i = 0; i < used.size(); ++i)
                if (used[i]) points.push_back(glm::vec3(matrix * glm::vec4(primitive.positions[i], 1.0f)));
        }
    }
    return points;
}

} // namespace hachure
