#include <hachure/runtime/animation/pose.h>
#include <hachure/runtime/assert.h>

#include <algorithm>

namespace hachure::animation {
namespace {

std::size_t morph_weights_of(const assets::Model& model, const assets::Node& node) {
    if (node.mesh < 0) return 0;
    const assets::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
    return mesh.primitives.empty() ? 0 : mesh.primitives.front().morph_targets.size();
}

} // namespace

PoseLayout pose_layout(const assets::Model& model) {
    PoseLayout layout;
    layout.first_weight.push_back(0);
    for (const assets::Node& node : model.nodes) {
        layout.names.push_back(node.name);
        layout.parents.push_back(node.parent);
        const std::size_t end = layout.first_weight.back() + morph_weights_of(model, node);
        HACHURE_ASSERT(end <= UINT32_MAX, "morph weights are counted in 32 bits");
        layout.first_weight.push_back(static_cast<std::uint32_t>(end));
    }
    return layout;
}

std::optional<std::uint32_t> find_node(const PoseLayout& layout, std::string_view name) {
    const auto at = std::ranges::find(layout.names, name);
    if (at == layout.names.end()) return std::nullopt;
    return static_cast<std::uint32_t>(at - layout.names.begin());
}

Pose rest_pose(const assets::Model& model, const PoseLayout& layout) {
    HACHURE_ASSERT(layout.nodes() == model.nodes.size(), "the layout is that of the model");
    Pose pose{std::vector<JointPose>(layout.nodes()), std::vector<float>(layout.weights(), 0.0f)};
    for (std::size_t n = 0; n < layout.nodes(); ++n) {
        const assets::Node& node = model.nodes[n];
        if (!node.matrix) pose.joints[n] = {node.translation, node.rotation, node.scale};
        if (layout.weights_of(n) == 0) continue;
        const std::vector<float>& weights = node.morph_weights.empty()
                                                ? model.meshes[static_cast<std::size_t>(node.mesh)].morph_weights
                                                : node.morph_weights;
        std::copy_n(weights.begin(), std::min(weights.size(), layout.weights_of(n)),
                    pose.weights.begin() + layout.first_weight[n]);
    }
    return pose;
}

void copy_pose(ConstPoseSpan from, PoseSpan to) {
    HACHURE_ASSERT(from.joints.size() == to.joints.size() && from.weights.size() == to.weights.size(),
                   "both poses have one layout");
    std::ranges::copy(from.joints, to.joints.begin());
    std::ranges::copy(from.weights, to.weights.begin());
}

} // namespace hachure::animation
