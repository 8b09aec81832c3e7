#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/tests/support/given_models.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "skin_reference.h"

namespace hachure::geometry {
namespace {

/// Position of a time among keys, without trust in their order: the last key not after it.
std::size_t key_before(const std::vector<float>& times, float time) {
    std::size_t key = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
        if (times[i] <= time) key = i;
    return key;
}

/// The values of a channel at a time: blended linearly, which is plenty for a pose to test with.
std::vector<double> sample(const assets::AnimationChannel& channel, float time) {
    const auto n = static_cast<std::size_t>(channel.components);
    const bool cubic = channel.interpolation == assets::Interpolation::cubic_spline;
    const std::size_t a = key_before(channel.times, time), b = std::min(a + 1, channel.times.size() - 1);
    const double span = static_cast<double>(channel.times[b]) - channel.times[a];
    const double t = span > 0.0 ? std::clamp((time - channel.times[a]) / span, 0.0, 1.0) : 0.0;
    const auto value = [&](std::size_t key, std::size_t i) {
        return static_cast<double>(channel.values[(cubic ? 3 * key + 1 : key) * n + i]);
    };
    std::vector<double> result(n);
    for (std::size_t i = 0; i < n; ++i) result[i] = (1.0 - t) * value(a, i) + t * value(b, i);
    return result;
}

/// A model's nodes in some pose.
struct ModelPose {
    std::vector<assets::Node> nodes;

    void play(const assets::Animation& clip, float time) {
        for (const assets::AnimationChannel& channel : clip.channels) {
            if (channel.node < 0 || channel.times.empty()) continue;
            assets::Node& node = nodes[static_cast<std::size_t>(channel.node)];
            const std::vector<double> v = sample(channel, time);
            if (channel.path == assets::AnimationPath::translation) node.translation = {v[0], v[1], v[2]};
            if (channel.path == assets::AnimationPath::scale) node.scale = {v[0], v[1], v[2]};
            if (channel.path == assets::AnimationPath::rotation)
                node.rotation = glm::quat(glm::normalize(glm::dquat(v[3], v[0], v[1], v[2])));
        }
    }

    void turn_at_random(const assets::Skin& skin, std::uint32_t seed) {
        std::mt19937 random(seed);
        std::normal_distribution<float> any;
        for (const std::int32_t joint : skin.joints)
            nodes[static_cast<std::size_t>(joint)].rotation =
                glm::normalize(glm::quat(any(random), any(random), any(random), any(random)));
    }

    [[nodiscard]] glm::dmat4 world(std::int32_t index) const {
        const assets::Node& node = nodes[static_cast<std::size_t>(index)];
        glm::dmat4 own = glm::translate(glm::dmat4(1.0), glm::dvec3(node.translation)) *
                         glm::mat4_cast(glm::dquat(node.rotation)) *
                         glm::scale(glm::dmat4(1.0), glm::dvec3(node.scale));
        if (node.matrix) own = glm::dmat4(*node.matrix);
        return node.parent < 0 ? own : world(node.parent) * own;
    }
};

/// The influences of a vertex as the file has them.
reference::VertexJoints influences(const assets::Primitive& primitive, std::size_t vertex) {
    reference::VertexJoints joints;
    for (int set = 0; set < 2; ++set)
        for (int k = 0; k < 4 && !primitive.joints[set].empty(); ++k)
            if (primitive.weights[set][vertex][k] > 0.0f)
                joints.emplace_back(primitive.joints[set][vertex][k], primitive.weights[set][vertex][k]);
    return reference::normalised(joints);
}

struct SkinErrors {
    double position = 0.0; ///< largest, over the size of the posed mesh
    double normal = 0.0;   ///< largest, radians
    std::size_t vertices = 0;
};

void compare(const assets::Primitive& primitive, const assets::Skin& skin, const ModelPose& pose, SkinErrors& errors) {
    std::vector<glm::dmat4> worlds, matrices;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
        worlds.push_back(pose.world(skin.joints[j]));
        matrices.push_back(worlds[j] * glm::dmat4(skin.inverse_bind[j]));
    }
    std::vector<JointMatrix> palette(worlds.size() + 1);
    SkinPaletteJob palette_job{.joints_double = worlds, .inverse_bind = skin.inverse_bind, .palette = palette};
    palette_job.validate();
    palette_job.run();
    EXPECT_EQ(palette_job.repaired, 0u);
    const std::size_t count = primitive.positions.size();
    const SkinWeights weights = pack_skin_weights(count, skin.joints.size(), primitive.joints[0], primitive.weights[0],
                                                  primitive.joints[1], primitive.weights[1]);
    std::vector<glm::vec3> positions(count), normals(count);
    SkinJob job{.rest_positions = primitive.positions,
                .rest_normals = primitive.normals,
                .weights = &weights,
                .palette = palette,
                .positions = positions,
                .normals = normals};
    job.validate();
    job.run();
    const double size = glm::length(glm::dvec3(job.bounds.extent()));
    for (std::size_t v = 0; v < count; ++v) {
        const glm::dmat4 m = reference::linear_blend(influences(primitive, v), matrices);
        const glm::dvec3 p = reference::point(m, primitive.positions[v]);
        errors.position = std::max(errors.position, glm::distance(p, glm::dvec3(positions[v])) / size);
        const glm::dmat3 linear(m);
        const double scale = std::cbrt(glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]));
        if (!(std::abs(glm::determinant(linear)) > 1e-2 * scale * scale * scale)) continue; // a fold: errors grow
        const glm::dvec3 n = reference::normal(m, glm::normalize(glm::dvec3(primitive.normals[v])));
        errors.normal = std::max(errors.normal, glm::distance(n, glm::dvec3(normals[v])));
    }
    errors.vertices += count;
}

void compare_model(const assets::Model& model, const ModelPose& pose, SkinErrors& errors) {
    for (const assets::Node& node : model.nodes) {
        if (node.mesh < 0 || node.skin < 0) continue;
        for (const assets::Primitive& primitive : model.meshes[static_cast<std::size_t>(node.mesh)].primitives)
            if (!primitive.joints[0].empty())
                compare(primitive, model.skins[static_cast<std::size_t>(node.skin)], pose, errors);
    }
}

// The accuracy that was asked for: 1e-5 of the size of the mesh, for each character, at rest, in clips, and with every
// joint turned at random.
TEST(SkinModels, FollowTheReference) {
    if (test::given_models().empty()) GTEST_SKIP() << test::no_given_models;
    SkinErrors errors;
    std::size_t characters = 0;
    for (const std::filesystem::path& file : test::given_gltf_files("characters")) {
        const assets::Model model = assets::read_model(file);
        if (model.skins.empty()) continue;
        ++characters;
        SkinErrors own;
        compare_model(model, {model.nodes}, own);
        for (std::size_t c = 0; c < std::min<std::size_t>(model.animations.size(), 3); ++c) {
            ModelPose pose{model.nodes};
            pose.play(model.animations[c], 0.37f * model.animations[c].duration);
            compare_model(model, pose, own);
        }
        ModelPose turned{model.nodes};
        for (const assets::Skin& skin : model.skins) turned.turn_at_random(skin, 5);
        compare_model(model, turned, own);
        EXPECT_LT(own.position, 1e-5) << file;
        EXPECT_LT(own.normal, 1e-4) << file;
        errors.position = std::max(errors.position, own.position);
        errors.normal = std::max(errors.normal, own.normal);
        errors.vertices += own.vertices;
    }
    RecordProperty("characters", std::to_string(characters));
    RecordProperty("largest_position_error", std::to_string(errors.position * 1e6) + "e-6");
    EXPECT_GT(characters, 10u);
    EXPECT_GT(errors.vertices, 10000u);
}

// What blocks of vertices are for: of the characters, nearly all list their joints, few each.
TEST(SkinModels, NeighboursShareTheirJoints) {
    if (test::given_models().empty()) GTEST_SKIP() << test::no_given_models;
    std::size_t blocks = 0, few = 0, joints = 0;
    for (const std::filesystem::path& file : test::given_gltf_files("characters")) {
        const assets::Model model = assets::read_model(file);
        for (const assets::Node& node : model.nodes) {
            if (node.mesh < 0 || node.skin < 0) continue;
            const std::size_t joint_count = model.skins[static_cast<std::size_t>(node.skin)].joints.size();
            for (const assets::Primitive& primitive : model.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
                const SkinWeights weights =
                    pack_skin_weights(primitive.positions.size(), joint_count, primitive.joints[0],
                                      primitive.weights[0], primitive.joints[1], primitive.weights[1]);
                for (std::size_t b = 0; b < weights.blocks().block_count(); ++b) {
                    const std::size_t own = weights.blocks().joints(b).size();
                    few += own > 0 && own <= 8;
                    joints += own;
                    ++blocks;
                }
            }
        }
    }
    RecordProperty("blocks", std::to_string(blocks));
    RecordProperty("joints_per_100_blocks", std::to_string(100 * joints / blocks));
    RecordProperty("per_cent_with_8_or_fewer", std::to_string(100 * few / blocks));
    EXPECT_GT(10 * few, 9 * blocks);
}

} // namespace
} // namespace hachure::geometry
