#include <hachure/runtime/animation/sample_clip.h>
#include <hachure/systems/model/clip_points.h>
#include <hachure/systems/model/posed_vertices.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure {
namespace {

/// So close that what moves fast does not leave the picture in between, and not so many that a long clip takes long.
int moments_of(const animation::Clip& clip) {
    constexpr double per_second = 12.0, least = 12.0, most = 96.0;
    return static_cast<int>(std::clamp(std::ceil(per_second * clip.duration), least, most));
}

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
    const int moments = moments_of(clip);
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
