#include <hachure/runtime/geometry/morph.h>
#include <hachure/runtime/parallel.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace hachure::geometry {
namespace {

/// A random mesh with targets of which some move everything, some a few vertices, some nothing.
struct Morphed {
    std::vector<glm::vec3> base_positions, base_normals;
    std::vector<glm::vec4> base_tangents;
    std::vector<std::vector<glm::vec3>> deltas; ///< three arrays per target
    MorphTargets targets;
    std::vector<float> weights;
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec4> tangents;

    Morphed(std::size_t vertices, std::size_t target_count) {
        std::mt19937 random(4);
        std::uniform_real_distribution<float> any(-1.0f, 1.0f);
        const auto vector = [&] { return glm::vec3(any(random), any(random), any(random)); };
        for (std::size_t v = 0; v < vertices; ++v) {
            base_positions.push_back(vector());
            base_normals.push_back(glm::normalize(vector()));
            base_tangents.emplace_back(glm::normalize(vector()), v % 2 == 0 ? 1.0f : -1.0f);
        }
        for (std::size_t a = 0; a < 3 * target_count; ++a) {
            std::vector<glm::vec3> array(vertices, glm::vec3(0.0f));
            const std::size_t stride = a / 3 % 3 == 0 ? 1 : 13;
            for (std::size_t v = a; v < vertices && a / 3 % 3 != 2; v += stride) array[v] = 0.2f * vector();
            deltas.push_back(array);
        }
        std::vector<MorphDeltas> given;
        for (std::size_t t = 0; t < target_count; ++t) {
            given.push_back({deltas[3 * t], deltas[3 * t + 1], deltas[3 * t + 2]});
            weights.push_back(any(random));
        }
        targets = MorphTargets(vertices, given);
        positions.resize(vertices);
        normals.resize(vertices);
        tangents.resize(vertices);
    }

    MorphJob job() {
        return {.base_positions = base_positions,
                .base_normals = base_normals,
                .base_tangents = base_tangents,
                .targets = &targets,
                .weights = weights,
                .positions = positions,
                .normals = normals,
                .tangents = tangents};
    }

    /// base + sum of weight * delta in double; `array` 0 positions, 1 normals, 2 tangents.
    [[nodiscard]] glm::dvec3 sum(const glm::dvec3& base, std::size_t array, std::size_t v) const {
        glm::dvec3 result = base;
        for (std::size_t t = 0; t < weights.size(); ++t)
            result += static_cast<double>(weights[t]) * glm::dvec3(deltas[3 * t + array][v]);
        return result;
    }
};

TEST(Morph, AddsWeightedDisplacements) {
    Morphed mesh(3000, 7);
    MorphJob job = mesh.job();
    job.validate();
    job.run();
    for (std::size_t v = 0; v < 3000; ++v) {
        EXPECT_LT(glm::distance(glm::dvec3(mesh.positions[v]), mesh.sum(mesh.base_positions[v], 0, v)), 1e-6);
        EXPECT_LT(glm::distance(glm::dvec3(mesh.normals[v]), glm::normalize(mesh.sum(mesh.base_normals[v], 1, v))),
                  2e-6);
        EXPECT_LT(glm::distance(glm::dvec3(mesh.tangents[v]), glm::normalize(mesh.sum(mesh.base_tangents[v], 2, v))),
                  2e-6);
        EXPECT_EQ(mesh.tangents[v].w, mesh.base_tangents[v].w);
    }
    EXPECT_EQ(job.bounds.low, bounds_of(mesh.positions).low);
}

TEST(Morph, StoresWhatMoves) {
    Morphed mesh(1300, 3);
    EXPECT_EQ(mesh.targets[0].positions.deltas.size(), 1300u);
    EXPECT_TRUE(mesh.targets[0].positions.vertices.empty()); // dense is smaller
    EXPECT_EQ(mesh.targets[1].positions.vertices.size(), 100u);
    EXPECT_TRUE(mesh.targets[2].positions.deltas.empty());
    EXPECT_LT(mesh.targets.bytes(), 3 * (1300 + 101) * 16u);
}

TEST(Morph, WeightsOfZeroLeaveTheBase) {
    Morphed mesh(500, 4);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    mesh.weights = {0.0f, -0.0f, nan, std::numeric_limits<float>::infinity()};
    mesh.job().run();
    EXPECT_EQ(mesh.positions, mesh.base_positions);
    EXPECT_EQ(mesh.normals, mesh.base_normals); // to the bit: not even made unit again
    EXPECT_EQ(mesh.tangents, mesh.base_tangents);
}

TEST(Morph, ACancelledNormalIsTheBases) {
    const glm::vec3 base{0, 0, 1}, delta{0, 0, -1};
    const glm::vec3 position(0.0f);
    const std::vector<MorphDeltas> given{{.positions = {}, .normals = {&delta, 1}}};
    const MorphTargets targets(1, given);
    const float one = 1.0f;
    glm::vec3 moved, normal;
    MorphJob job{.base_positions = {&position, 1},
                 .base_normals = {&base, 1},
                 .targets = &targets,
                 .weights = {&one, 1},
                 .positions = {&moved, 1},
                 .normals = {&normal, 1}};
    job.validate();
    job.run();
    EXPECT_EQ(normal, base);
}

TEST(Morph, RangesAndThreadsChangeNothing) {
    Morphed mesh(20000, 6);
    MorphJob whole = mesh.job();
    whole.run();
    const auto positions = mesh.positions, normals = mesh.normals;
    const auto clear = [&] { std::ranges::fill(mesh.positions, glm::vec3(0.0f)); };
    clear();
    for (std::size_t first = 0; first < 20000; first += 777) {
        MorphJob part = mesh.job();
        part.range = {first, 777};
        part.run();
    }
    EXPECT_EQ(mesh.positions, positions);
    clear();
    MorphJob parallel = mesh.job();
    morph_in_parallel(parallel);
    EXPECT_EQ(mesh.positions, positions);
    EXPECT_EQ(mesh.normals, normals);
    EXPECT_EQ(parallel.bounds.high, whole.bounds.high);
    mesh.weights.pop_back();
    EXPECT_DEATH(mesh.job().validate(), "one weight per target");
}

} // namespace
} // namespace hachure::geometry
