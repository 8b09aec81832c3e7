#pragma once

#include <hachure/runtime/assets/model.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hachure::animation {

/// Where a node is in its parent: `translation * rotation * scale`, as glTF has it.
struct JointPose {
    glm::vec3 translation{0.0f};                ///< metres
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f}; ///< unit
    glm::vec3 scale{1.0f};

    friend bool operator==(const JointPose&, const JointPose&) = default;
};

/// What the poses of one model have in common: a JointPose per node of the file, joint of a skin or not, and the morph
/// weights of all nodes in one array.
struct PoseLayout {
    std::vector<std::string> names;    ///< per node, as the file has them
    std::vector<std::int32_t> parents; ///< per node, -1 for roots; not sorted in any way
    std::vector<std::uint32_t>
        first_weight; ///< per node and one more: the weights of node n are [first[n], first[n+1])

    [[nodiscard]] std::size_t nodes() const { return parents.size(); }
    [[nodiscard]] std::size_t weights() const { return first_weight.empty() ? 0 : first_weight.back(); }
    [[nodiscard]] std::size_t weights_of(std::size_t node) const { return first_weight[node + 1] - first_weight[node]; }
};

/// The layout of a model: a node has as many weights as its mesh has morph targets.
[[nodiscard]] PoseLayout pose_layout(const assets::Model& model);

/// The first node of this name, or none.
[[nodiscard]] std::optional<std::uint32_t> find_node(const PoseLayout& layout, std::string_view name);

/// A pose that someone else owns, to read.
struct ConstPoseSpan {
    std::span<const JointPose> joints; ///< one per node of the layout
    std::span<const float> weights;    ///< as PoseLayout::first_weight divides them
};

/// A pose that someone else owns, to write.
struct PoseSpan {
    std::span<JointPose> joints;
    std::span<float> weights;

    // NOLINTNEXTLINE(google-explicit-constructor): as a span of T is one of const T
    operator ConstPoseSpan() const { return {joints, weights}; }
};

/// A pose of its own.
struct Pose {
    std::vector<JointPose> joints;
    std::vector<float> weights;

    [[nodiscard]] PoseSpan span() { return {joints, weights}; }
    [[nodiscard]] ConstPoseSpan span() const { return {joints, weights}; }
    friend bool operator==(const Pose&, const Pose&) = default;
};

/// The pose that the file itself shows: translation, rotation and scale of its nodes, and the node's morph weights or
/// else the mesh's. A node that has a matrix which does not decompose is at the origin here; its matrix holds as long
/// as nothing animates it.
[[nodiscard]] Pose rest_pose(const assets::Model& model, const PoseLayout& layout);

/// Copies one pose over another of the same layout.
void copy_pose(ConstPoseSpan from, PoseSpan to);

} // namespace hachure::animation
