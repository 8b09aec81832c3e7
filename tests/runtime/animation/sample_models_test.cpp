// Every clip of the real files that HACHURE_MODELS names, against the formulas of the specification.

#include <hachure/runtime/animation/sample_clip.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/tests/runtime/animation/gltf_sampling.h>
#include <hachure/tests/support/given_models.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace hachure::animation {
namespace {

namespace fs = std::filesystem;

/// Before, at, between and after the keys.
std::vector<double> moments(const assets::Animation& animation) {
    std::vector<double> keys;
    for (const assets::AnimationChannel& channel : animation.channels)
        keys.insert(keys.end(), channel.times.begin(), channel.times.end());
    std::ranges::sort(keys);
    keys.erase(std::ranges::unique(keys).begin(), keys.end());
    std::vector<double> all;
    for (std::size_t k = 0; k < keys.size(); ++k) {
        all.push_back(keys[k]);
        if (k + 1 < keys.size())
            all.push_back(keys[k] + (keys[k + 1] - keys[k]) * (0.1 + 0.8 * static_cast<double>(k % 7) / 6.0));
    }
    if (!keys.empty()) all.insert(all.end(), {keys.front() - 1.0, keys.back() + 0.5, keys.back() + 1e6});
    return all;
}

double error_at(const assets::AnimationChannel& channel, const Pose& pose, const PoseLayout& layout, double time) {
    const gltf_sampling::Value expected = gltf_sampling::sample(channel, time);
    const auto node = static_cast<std::size_t>(channel.node);
    const JointPose& joint = pose.joints[node];
    double error = 0.0;
    for (int i = 0; i < channel.components; ++i) {
        const double got = channel.path == AnimationPath::translation ? joint.translation[i]
                           : channel.path == AnimationPath::rotation  ? joint.rotation[i]
                           : channel.path == AnimationPath::scale
                               ? joint.scale[i]
                               : pose.weights[layout.first_weight[node] + static_cast<std::size_t>(i)];
        error = std::max(error, std::abs(got - expected[static_cast<std::size_t>(i)]));
    }
    return error / std::max(gltf_sampling::magnitude(channel), 1e-30);
}

/// The largest relative error of a clip, and that nothing but its channels is written.
double largest_error(const ClipSet& set, const Clip& clip, const assets::Animation& animation) {
    const JointPose untouched{glm::vec3(123.0f), glm::quat(0.5f, 0.5f, 0.5f, 0.5f), glm::vec3(321.0f)};
    Pose pose{std::vector<JointPose>(set.layout.nodes(), untouched), std::vector<float>(set.layout.weights(), 77.0f)};
    SampleCache cache;
    double largest = 0.0;
    for (const double time : moments(animation)) {
        SampleClipJob job{&clip, time, &cache, pose.span()};
        job.validate();
        job.run();
        for (const assets::AnimationChannel& channel : animation.channels)
            largest = std::max(largest, error_at(channel, pose, set.layout, time));
    }
    std::vector<std::uint8_t> parts(set.layout.nodes());
    for (const ClipTarget& target : clip.targets) parts[target.node] = target.parts;
    for (std::size_t n = 0; n < parts.size(); ++n) {
        EXPECT_TRUE((parts[n] & moves_translation) != 0 || pose.joints[n].translation == untouched.translation);
        EXPECT_TRUE((parts[n] & moves_rotation) != 0 || pose.joints[n].rotation == untouched.rotation);
        EXPECT_TRUE((parts[n] & moves_scale) != 0 || pose.joints[n].scale == untouched.scale);
    }
    return largest;
}

TEST(SampleModels, EveryClipAgreesWithTheSpecification) {
    const std::vector<fs::path> files = test::given_gltf_files("characters");
    if (files.empty()) GTEST_SKIP() << "HACHURE_MODELS names no folder with characters";
    std::size_t clips = 0;
    double worst = 0.0;
    for (const fs::path& file : files) {
        const assets::Model model = assets::read_model(file);
        std::vector<std::string> warnings;
        const ClipSet set = compile_clips(model, warnings);
        ASSERT_EQ(set.clips.size(), model.animations.size());
        for (std::size_t i = 0; i < set.clips.size(); ++i, ++clips) {
            EXPECT_EQ(set.clips[i].tracks.size(), model.animations[i].channels.size()) << file << set.clips[i].name;
            EXPECT_EQ(set.clips[i].duration, model.animations[i].duration) << file;
            const double error = largest_error(set, set.clips[i], model.animations[i]);
            EXPECT_LE(error, 1e-5) << file << " " << set.clips[i].name;
            worst = std::max(worst, error);
        }
    }
    EXPECT_GT(clips, 0u);
    RecordProperty("clips", std::to_string(clips));
    RecordProperty("worst_relative_error", std::to_string(worst * 1e6) + "e-6");
}

} // namespace
} // namespace hachure::animation
