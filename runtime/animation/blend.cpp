#include <hachure/runtime/animation/blend.h>
#include <hachure/runtime/animation/interpolate.h>
#include <hachure/runtime/assert.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure::animation {
namespace {

bool same_size(ConstPoseSpan a, ConstPoseSpan b) {
    return a.joints.size() == b.joints.size() && a.weights.size() == b.weights.size();
}

void validate_layout(ConstPoseSpan pose, const PoseLayout* layout) {
    HACHURE_ASSERT(pose.weights.empty() || layout != nullptr, "the layout says whose the morph weights are");
    HACHURE_ASSERT(layout == nullptr ||
                       (layout->nodes() == pose.joints.size() && layout->weights() == pose.weights.size()),
                   "poses have the layout's size");
}

void validate_weights(float weight, std::span<const float> mask, std::size_t nodes, float most) {
    const auto in_range = [most](float w) { return w >= 0.0f && w <= most; };
    HACHURE_ASSERT(in_range(weight), "the weight is in range");
    HACHURE_ASSERT(mask.empty() || mask.size() == nodes, "one weight of the mask per node, or none");
    HACHURE_ASSERT(std::ranges::all_of(mask, in_range), "the mask is in range");
}

/// In double precision, where no two finite weights overflow.
double weight_at(float weight, std::span<const float> mask, std::size_t node) {
    return mask.empty() ? weight : static_cast<double>(weight) * mask[node];
}

/// The morph weights of a node.
template <typename T> std::span<T> weights_at(std::span<T> weights, const PoseLayout* layout, std::size_t node) {
    if (weights.empty()) return {};
    return weights.subspan(layout->first_weight[node], layout->weights_of(node));
}

void copy_node(ConstPoseSpan from, PoseSpan to, const PoseLayout* layout, std::size_t node) {
    to.joints[node] = from.joints[node];
    std::ranges::copy(weights_at(from.weights, layout, node), weights_at(to.weights, layout, node).begin());
}

/// What the layers weigh at one node.
struct NodeWeights {
    double sum = 0.0;
    std::size_t heaviest = 0; ///< the first of those
    std::size_t count = 0;    ///< layers that weigh anything
};

NodeWeights weigh(std::span<const BlendLayer> layers, std::size_t node) {
    NodeWeights result;
    double most = 0.0;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const double weight = weight_at(layers[i].weight, layers[i].mask, node);
        result.sum += weight;
        if (weight > 0.0) ++result.count;
        if (weight <= most) continue;
        most = weight;
        result.heaviest = i;
    }
    return result;
}

JointPose mean_joint(std::span<const BlendLayer> layers, std::size_t node, const NodeWeights& weights) {
    const glm::quat hemisphere = layers[weights.heaviest].pose.joints[node].rotation;
    JointPose mean{glm::vec3(0.0f), glm::quat(0.0f, 0.0f, 0.0f, 0.0f), glm::vec3(0.0f)};
    for (const BlendLayer& layer : layers) {
        const auto w = static_cast<float>(weight_at(layer.weight, layer.mask, node) / weights.sum);
        if (w == 0.0f) continue;
        const JointPose& joint = layer.pose.joints[node];
        mean.translation += joint.translation * w;
        mean.rotation += joint.rotation * (glm::dot(hemisphere, joint.rotation) < 0.0f ? -w : w);
        mean.scale += joint.scale * w;
    }
    mean.rotation = unit_or(mean.rotation, hemisphere);
    return mean;
}

/// Element by element: `out` may be one of the layers'.
void mean_weights(const BlendPosesJob& job, std::size_t node, double sum) {
    const std::size_t first = job.layout->first_weight[node];
    for (std::size_t i = first; i < job.layout->first_weight[node + 1]; ++i) {
        double mean = 0.0;
        for (const BlendLayer& layer : job.layers)
            mean += weight_at(layer.weight, layer.mask, node) / sum * layer.pose.weights[i];
        job.out.weights[i] = finite_float(mean);
    }
}

glm::quat add_rotation(const glm::quat& to, const glm::quat& source, const glm::quat& reference, float weight) {
    if (source == reference) return to;
    const glm::quat difference = source * glm::conjugate(reference);
    return unit_or(slerp_short(glm::quat(1.0f, 0.0f, 0.0f, 0.0f), difference, weight) * to, to);
}

float add_scale(float to, float source, float reference, float weight) {
    const float scaled = to * (1.0f + weight * (source / reference - 1.0f));
    return reference != 0.0f && std::isfinite(scaled) ? scaled : to + weight * (source - reference);
}

void add_joint(JointPose& to, const JointPose& source, const JointPose& reference, float weight) {
    to.translation += (source.translation - reference.translation) * weight;
    to.rotation = add_rotation(to.rotation, source.rotation, reference.rotation, weight);
    for (int i = 0; i < 3; ++i) to.scale[i] = add_scale(to.scale[i], source.scale[i], reference.scale[i], weight);
}

} // namespace

void BlendPosesJob::validate() const {
    constexpr float most = std::numeric_limits<float>::max();
    HACHURE_ASSERT(same_size(rest, out), "all poses have one size");
    validate_layout(out, layout);
    for (const BlendLayer& layer : layers) {
        HACHURE_ASSERT(same_size(layer.pose, out), "all poses have one size");
        validate_weights(layer.weight, layer.mask, out.joints.size(), most);
    }
}

void BlendPosesJob::run() {
    for (std::size_t node = 0; node < out.joints.size(); ++node) {
        const NodeWeights weights = weigh(layers, node);
        if (weights.count < 2) {
            copy_node(weights.count == 0 ? rest : layers[weights.heaviest].pose, out, layout, node);
            continue;
        }
        out.joints[node] = mean_joint(layers, node, weights);
        if (!out.weights.empty()) mean_weights(*this, node, weights.sum);
    }
}

void OverlayPoseJob::validate() const {
    HACHURE_ASSERT(same_size(pose, over), "both poses have one size");
    validate_layout(pose, layout);
    validate_weights(weight, mask, pose.joints.size(), 1.0f);
}

void OverlayPoseJob::run() {
    for (std::size_t node = 0; node < pose.joints.size(); ++node) {
        const auto w = static_cast<float>(weight_at(weight, mask, node));
        if (w == 0.0f) continue;
        if (w == 1.0f) {
            copy_node(over, pose, layout, node);
            continue;
        }
        JointPose& to = pose.joints[node];
        const JointPose& from = over.joints[node];
        to.translation = to.translation * (1.0f - w) + from.translation * w;
        to.scale = to.scale * (1.0f - w) + from.scale * w;
        const float sign = glm::dot(to.rotation, from.rotation) < 0.0f ? -w : w;
        to.rotation = unit_or(to.rotation * (1.0f - w) + from.rotation * sign, to.rotation);
        const std::span<float> weights = weights_at(pose.weights, layout, node);
        const std::span<const float> others = weights_at(over.weights, layout, node);
        for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = lerp(weights[i], others[i], w);
    }
}

void AddPoseJob::validate() const {
    HACHURE_ASSERT(same_size(pose, source) && same_size(pose, reference), "all poses have one size");
    validate_layout(pose, layout);
    validate_weights(weight, mask, pose.joints.size(), 1.0f);
}

void AddPoseJob::run() {
    for (std::size_t node = 0; node < pose.joints.size(); ++node) {
        const auto w = static_cast<float>(weight_at(weight, mask, node));
        if (w == 0.0f) continue;
        add_joint(pose.joints[node], source.joints[node], reference.joints[node], w);
        const std::span<float> weights = weights_at(pose.weights, layout, node);
        const std::span<const float> from = weights_at(reference.weights, layout, node);
        const std::span<const float> to = weights_at(source.weights, layout, node);
        for (std::size_t i = 0; i < weights.size(); ++i) weights[i] += w * (to[i] - from[i]);
    }
}

void mask_branch(const PoseLayout& layout, std::uint32_t node, float weight, std::span<float> mask) {
    HACHURE_ASSERT(mask.size() == layout.nodes() && node < layout.nodes(), "one weight per node");
    // A node may stand before its parent, so each looks upwards until it meets one whose place is known.
    enum : std::uint8_t { unknown, inside, outside };
    std::vector<std::uint8_t> places(layout.nodes(), unknown);
    places[node] = inside;
    for (std::size_t n = 0; n < layout.nodes(); ++n) {
        const auto parent = [&](std::int32_t of) { return layout.parents[static_cast<std::size_t>(of)]; };
        auto top = static_cast<std::int32_t>(n);
        while (top >= 0 && places[static_cast<std::size_t>(top)] == unknown) top = parent(top);
        const std::uint8_t place = top < 0 ? std::uint8_t{outside} : places[static_cast<std::size_t>(top)];
        for (auto at = static_cast<std::int32_t>(n); at != top; at = parent(at))
            places[static_cast<std::size_t>(at)] = place;
        if (places[n] == inside) mask[n] = weight;
    }
}

std::optional<std::vector<float>> make_mask(const PoseLayout& layout, std::string_view node, float inside,
                                            float outside) {
    const std::optional<std::uint32_t> top = find_node(layout, node);
    if (!top) return std::nullopt;
    std::vector<float> mask(layout.nodes(), outside);
    mask_branch(layout, *top, inside, mask);
    return mask;
}

} // namespace hachure::animation
