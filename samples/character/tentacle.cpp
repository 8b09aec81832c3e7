#include "tentacle.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace hachure;

constexpr int joints = 4, rings = 48, sides = 32;
constexpr float length = 2.0f, bone = length / joints; // metres

/// Narrows to a round tip.
float radius_at(float height) {
    const float t = height / length;
    return 0.32f * std::sqrt(std::max(0.0f, 1.0f - t * t * t * t)) * (1.0f - 0.55f * t);
}

/// Two joints share a vertex, by how near they are.
void add_influences(assets::Primitive& primitive, float height) {
    const float at = std::clamp(height / bone - 0.5f, 0.0f, float(joints - 1));
    const int below = std::min(static_cast<int>(at), joints - 2);
    const float above_weight = glm::smoothstep(0.0f, 1.0f, at - static_cast<float>(below));
    primitive.joints[0].emplace_back(below, below + 1, 0, 0);
    primitive.weights[0].emplace_back(1.0f - above_weight, above_weight, 0.0f, 0.0f);
}

assets::Primitive make_tube() {
    assets::Primitive tube;
    for (int ring = 0; ring <= rings; ++ring)
        for (int side = 0; side < sides; ++side) {
            const float height = length * static_cast<float>(ring) / rings, radius = radius_at(height);
            const float angle = 2.0f * glm::pi<float>() * static_cast<float>(side) / sides;
            const float slope =
                (radius_at(std::min(length, height + 0.01f)) - radius_at(std::max(0.0f, height - 0.01f))) / 0.02f;
            tube.positions.emplace_back(radius * std::cos(angle), height, radius * std::sin(angle));
            tube.normals.push_back(glm::normalize(glm::vec3(std::cos(angle), -slope, std::sin(angle))));
            add_influences(tube, height);
        }
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t side = 0; side < sides; ++side) {
            const std::uint32_t a = ring * sides + side, b = ring * sides + (side + 1) % sides;
            tube.indices.insert(tube.indices.end(), {a, a + sides, b, b, a + sides, b + sides});
        }
    tube.material = 0;
    return tube;
}

/// A swing of all joints about an axis: `angle(joint, t)` radians at t in [0, 1] of `seconds`.
template <class F> assets::Animation make_clip(const char* name, float seconds, glm::vec3 axis, F angle) {
    constexpr int keys = 16;
    assets::Animation clip{.name = name, .channels = {}, .duration = seconds};
    for (int joint = 0; joint < joints; ++joint) {
        assets::AnimationChannel channel{.node = 1 + joint, .path = assets::AnimationPath::rotation, .components = 4};
        for (int key = 0; key <= keys; ++key) {
            const float t = static_cast<float>(key) / keys;
            const glm::quat turn = glm::angleAxis(angle(joint, t), axis);
            channel.times.push_back(t * seconds);
            channel.values.insert(channel.values.end(), {turn.x, turn.y, turn.z, turn.w});
        }
        clip.channels.push_back(channel);
    }
    return clip;
}

} // namespace

assets::Model make_tentacle() {
    constexpr float turn = 2.0f * glm::pi<float>();
    assets::Model model;
    model.materials.push_back({.name = "skin", .base_color = {0.45f, 0.12f, 0.18f, 1.0f}, .double_sided = true});
    model.meshes.push_back({"tentacle", {make_tube()}, {}});
    model.nodes.resize(1 + joints);
    model.nodes[0] = {.name = "tentacle", .mesh = 0, .skin = 0};
    assets::Skin skin{.name = "tentacle", .joints = {}, .inverse_bind = {}};
    for (int joint = 0; joint < joints; ++joint) {
        assets::Node& node = model.nodes[static_cast<std::size_t>(1 + joint)];
        node.name = "joint " + std::to_string(joint);
        node.parent = joint == 0 ? -1 : joint;
        node.translation = {0.0f, joint == 0 ? 0.0f : bone, 0.0f};
        if (joint + 1 < joints) node.children = {joint + 2};
        skin.joints.push_back(1 + joint);
        skin.inverse_bind.push_back(glm::translate(glm::mat4(1.0f), {0.0f, -bone * static_cast<float>(joint), 0.0f}));
    }
    model.skins.push_back(skin);
    model.animations.push_back(make_clip("wave", 2.0f, {0, 0, 1}, [](int joint, float t) {
        return 0.35f * std::sin(turn * (t - 0.2f * static_cast<float>(joint)));
    }));
    model.animations.push_back(make_clip("curl", 3.0f, glm::normalize(glm::vec3(1, 0, 0.4f)),
                                         [](int, float t) { return 0.45f * (1.0f - std::cos(turn * t)); }));
    model.scenes.push_back({"scene", {0, 1}});
    return model;
}
