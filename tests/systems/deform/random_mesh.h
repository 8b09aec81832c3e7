#pragma once

#include <hachure/components/transform.h>
#include <hachure/runtime/geometry/morph.h>
#include <hachure/runtime/geometry/skin_weights.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstdint>
#include <random>
#include <vector>

// Meshes that deform in every way, with nothing to them that looks like a character.
namespace hachure::test {

/// The same numbers on every run.
class Random {
public:
    float in(float low, float high) { return low + (high - low) * static_cast<float>(bits_()) / 4294967296.0f; }
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(bits_()) % count; }
    glm::vec3 vector(float most) { return {in(-most, most), in(-most, most), in(-most, most)}; }
    glm::vec3 unit() {
        for (;;) {
            const glm::vec3 v = vector(1.0f);
            if (glm::length(v) > 0.1f) return glm::normalize(v);
        }
    }

private:
    std::mt19937 bits_{20260917};
};

/// What a random mesh is to be like.
struct Kind {
    std::uint32_t vertices = 500;
    std::uint32_t joints = 20;
    int influences = 4;
    int targets = 0;        ///< dense and sparse ones in turn
    int unweighted = 0;     ///< every so manyth vertex follows no joint
    bool one_joint = false; ///< each vertex follows one only
};

inline geometry::SkinWeights random_weights(Random& random, const Kind& kind) {
    std::vector<glm::uvec4> joints[2];
    std::vector<glm::vec4> weights[2];
    for (std::uint32_t v = 0; v < kind.vertices; ++v)
        for (int set = 0; set < kind.influences / 4; ++set) {
            const bool none = kind.unweighted > 0 && v % static_cast<std::uint32_t>(kind.unweighted) == 0;
            glm::uvec4 joint(0);
            glm::vec4 weight(0.0f);
            for (int k = 0; k < (kind.one_joint ? 1 : 4); ++k) {
                joint[k] = random.below(kind.joints);
                weight[k] = none ? 0.0f : random.in(0.05f, 1.0f);
            }
            joints[set].push_back(joint);
            weights[set].push_back(weight);
        }
    return geometry::pack_skin_weights(kind.vertices, kind.joints, joints[0], weights[0], joints[1], weights[1]);
}

inline geometry::MorphTargets random_targets(Random& random, const Kind& kind) {
    std::vector<std::vector<glm::vec3>> arrays;
    for (int i = 0; i < 3 * kind.targets; ++i) {
        std::vector<glm::vec3>& array = arrays.emplace_back(kind.vertices, glm::vec3(0.0f));
        for (glm::vec3& delta : array)
            if (i / 3 % 2 == 0 || random.below(10) == 0) delta = random.vector(0.3f);
    }
    std::vector<geometry::MorphDeltas> deltas;
    for (std::size_t t = 0; t < arrays.size(); t += 3)
        deltas.push_back({arrays[t], arrays[t + 1], t == 3 ? std::span<const glm::vec3>() : arrays[t + 2]});
    return {kind.vertices, deltas};
}

inline SurfaceMesh random_mesh(Random& random, const Kind& kind) {
    SurfaceMesh mesh;
    mesh.name = "random";
    for (std::uint32_t v = 0; v < kind.vertices; ++v) {
        const glm::vec3 normal = random.unit();
        mesh.positions.push_back(random.vector(1.0f));
        mesh.normals.push_back(normal);
        mesh.tangents.emplace_back(glm::normalize(glm::cross(normal, random.unit())), v % 2 ? 1.0f : -1.0f);
        if (v >= 2) mesh.indices.insert(mesh.indices.end(), {v - 2, v - 1, v});
    }
    mesh.submeshes = {{0, static_cast<std::uint32_t>(mesh.indices.size()), {}}};
    if (kind.joints > 0) mesh.skin = random_weights(random, kind);
    if (kind.targets > 0) mesh.morphs = random_targets(random, kind);
    return mesh;
}

inline Transform random_joint(Random& random) {
    return {.translation = random.vector(0.5f),
            .rotation = glm::angleAxis(random.in(-1.0f, 1.0f), random.unit()),
            .scale = {random.in(0.7f, 1.4f), random.in(0.7f, 1.4f), random.in(0.7f, 1.4f)}};
}

} // namespace hachure::test
