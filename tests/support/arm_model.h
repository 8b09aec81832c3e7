#pragma once

#include <hachure/runtime/assets/model.h>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace hachure::test {

inline assets::AnimationChannel channel(std::int32_t node, assets::AnimationPath path, std::vector<float> times,
                                        std::vector<float> values) {
    assets::AnimationChannel result{.node = node, .path = path, .times = std::move(times), .values = std::move(values)};
    result.components = static_cast<std::int32_t>(result.values.size() / result.times.size());
    return result;
}

/// A square arm of two metres along y, skinned to two joints with a soft elbow at 1 m, with a morph target "fat" and
/// three clips of one second: "bend" turns the elbow from 0 to 90 degrees about z, "walk" moves the shoulder two metres
/// along x, "swell" takes the target from 0 to 1. Nodes: 0 the mesh, 1 shoulder, 2 elbow.
inline assets::Model arm_model() {
    constexpr int rings = 20;
    assets::Primitive arm;
    assets::MorphTarget fat{.name = "fat"};
    for (int ring = 0; ring <= rings; ++ring)
        for (int side = 0; side < 4; ++side) {
            const float height = 2.0f * static_cast<float>(ring) / rings;
            const float angle = glm::half_pi<float>() * static_cast<float>(side);
            const glm::vec3 out(std::cos(angle), 0.0f, std::sin(angle));
            arm.positions.push_back(0.2f * out + glm::vec3(0.0f, height, 0.0f));
            arm.normals.push_back(out);
            fat.positions.push_back(0.1f * out);
            const float elbow = glm::smoothstep(0.7f, 1.3f, height);
            arm.joints[0].emplace_back(0, 1, 0, 0);
            arm.weights[0].emplace_back(1.0f - elbow, elbow, 0.0f, 0.0f);
        }
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t side = 0; side < 4; ++side) {
            const std::uint32_t a = 4 * ring + side, b = 4 * ring + (side + 1) % 4;
            arm.indices.insert(arm.indices.end(), {a, a + 4, b, b, a + 4, b + 4});
        }
    arm.morph_targets = {fat};
    assets::Model model;
    model.meshes.push_back({"arm", {arm}, {0.0f}});
    model.nodes.resize(3);
    model.nodes[0] = {.name = "arm", .mesh = 0, .skin = 0};
    model.nodes[1] = {.name = "shoulder", .children = {2}};
    model.nodes[2] = {.name = "elbow", .parent = 1, .translation = {0, 1, 0}};
    model.skins.push_back({.name = "arm",
                           .joints = {1, 2},
                           .inverse_bind = {glm::mat4(1.0f), glm::translate(glm::mat4(1.0f), {0, -1, 0})}});
    const float half = std::sqrt(0.5f);
    using Path = assets::AnimationPath;
    model.animations.push_back({"bend", {channel(2, Path::rotation, {0, 1}, {0, 0, 0, 1, 0, 0, half, half})}, 1.0f});
    model.animations.push_back({"walk", {channel(1, Path::translation, {0, 1}, {0, 0, 0, 2, 0, 0})}, 1.0f});
    model.animations.push_back({"swell", {channel(0, Path::weights, {0, 1}, {0, 1})}, 1.0f});
    model.scenes.push_back({"scene", {0, 1}});
    return model;
}

} // namespace hachure::test
