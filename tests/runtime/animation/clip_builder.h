#pragma once

#include <hachure/runtime/animation/clip.h>
#include <hachure/runtime/animation/sample_clip.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace hachure::animation {

/// A model of nodes "a", "b", "c", ... in one chain, with morph targets where asked for, and animations made by hand.
struct ModelBuilder {
    assets::Model model;

    explicit ModelBuilder(std::size_t nodes, std::size_t morph_targets = 0) {
        for (std::size_t n = 0; n < nodes; ++n) {
            assets::Node node;
            node.name = std::string(1, static_cast<char>('a' + n));
            node.parent = static_cast<std::int32_t>(n) - 1;
            if (n > 0) model.nodes.back().children.push_back(static_cast<std::int32_t>(n));
            if (morph_targets > 0) node.mesh = 0;
            model.nodes.push_back(node);
        }
        if (morph_targets == 0) return;
        assets::Primitive primitive;
        primitive.morph_targets.resize(morph_targets);
        model.meshes.push_back({"mesh", {primitive}, {}});
    }

    assets::Animation& clip(const std::string& name) {
        model.animations.push_back({name, {}, 0.0f});
        return model.animations.back();
    }

    /// Adds a channel to the last clip.
    assets::AnimationChannel& channel(std::int32_t node, AnimationPath path, std::vector<float> times,
                                      std::vector<float> values, Interpolation interpolation = Interpolation::linear,
                                      std::int32_t components = 0) {
        if (components == 0) components = path == AnimationPath::rotation ? 4 : 3;
        assets::AnimationChannel channel;
        channel.node = node;
        channel.path = path;
        channel.interpolation = interpolation;
        channel.times = std::move(times);
        channel.values = std::move(values);
        channel.components = components;
        model.animations.back().channels.push_back(std::move(channel));
        return model.animations.back().channels.back();
    }

    ClipSet compile() {
        warnings.clear();
        return compile_clips(model, warnings);
    }

    std::vector<std::string> warnings; ///< of the last compilation
};

/// The pose of a clip at a moment, over the model's rest pose.
inline Pose sampled(const ClipSet& set, const assets::Model& model, double time, std::size_t clip = 0) {
    Pose pose = rest_pose(model, set.layout);
    SampleCache cache;
    SampleClipJob job{&set.clips.at(clip), time, &cache, pose.span()};
    job.validate();
    job.run();
    return pose;
}

inline glm::quat about_y(float radians) { return {std::cos(radians / 2), 0.0f, std::sin(radians / 2), 0.0f}; }

/// The angle between two rotations, radians.
inline double angle_between(const glm::quat& a, const glm::quat& b) {
    const glm::dquat difference = glm::conjugate(glm::dquat(a)) * glm::dquat(b);
    return 2.0 * std::atan2(glm::length(glm::dvec3(difference.x, difference.y, difference.z)), std::abs(difference.w));
}

} // namespace hachure::animation
