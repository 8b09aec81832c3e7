#include <hachure/runtime/animation/sample_clip.h>
#include <hachure/systems/model/clip_points.h>
#include <hachure/systems/model/rest_pose.h>

namespace hachure {
namespace {

constexpr int moments = 12;

/// The model's nodes as a pose puts them; meshes and all else are left behind.
std::vector<assets::Node> posed_nodes(const assets::Model& model, const animation::PoseLayout& layout,
                                      const animation::Pose& pose) {
    std::vector<assets::Node> nodes = model.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const animation::JointPose& joint = pose.joints[i];
        nodes[i].translation = joint.translation;
        nodes[i].rotation = joint.rotation;
        nodes[i].scale = joint.scale;
        const auto first = pose.weights.begin() + layout.first_weight[i];
        nodes[i].morph_weights.assign(first, first + static_cast<std::ptrdiff_t>(layout.weights_of(i)));
    }
    return nodes;
}

} // namespace

std::vector<glm::vec3> clip_points(const assets::Model& model, const animation::ClipSet& set,
                                   const animation::Clip& clip) {
    std::vector<glm::vec3> points;
    animation::SampleCache cache;
    for (int moment = 0; moment <= moments; ++moment) {
        animation::Pose pose = animation::rest_pose(model, set.layout);
        animation::SampleClipJob{
            .clip = &clip, .time = clip.duration * moment / moments, .cache = &cache, .pose = pose.span()}
            .run();
        const std::vector<assets::Node> nodes = posed_nodes(model, set.layout, pose);
        for (const glm::vec3& point : scene_points(model, nodes)) points.push_back(point);
        if (clip.duration == 0.0) break;
    }
    return points;
}

} // namespace hachure
