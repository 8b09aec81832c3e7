#include <hachure/runtime/geometry/deformed_bounds.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/runtime/parallel.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include "skin_reference.h"

namespace hachure::geometry {
namespace {

using std::numbers::pi;

/// Whether vertices follow the joints of those before them, as a character's do, or any.
enum class Neighbours { alike, unlike };

/// A random mesh in the unit cube that follows random joints, with room for what a job writes.
struct Skinned {
    std::vector<glm::vec3> rest_positions, rest_normals;
    std::vector<glm::vec4> rest_tangents;
    std::vector<reference::VertexJoints> joints;
    std::vector<glm::dmat4> matrices; ///< per joint
    SkinWeights weights;
    std::vector<JointMatrix> palette;
    std::vector<JointMotion> motions;
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec4> tangents;

    Skinned(std::size_t vertices, std::size_t joint_count, int influences, std::uint32_t seed = 1,
            Neighbours neighbours = Neighbours::unlike) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> any(-1.0f, 1.0f), positive(0.01f, 1.0f);
        std::vector<glm::uvec4> sets[2];
        std::vector<glm::vec4> of_sets[2];
        for (std::size_t v = 0; v < vertices; ++v) {
            rest_positions.emplace_back(any(random), any(random), any(random));
            rest_normals.push_back(glm::normalize(glm::vec3(any(random), any(random), any(random) + 2.0f)));
            const glm::vec3 other = glm::normalize(glm::cross(rest_normals.back(), glm::vec3(0.3f, 0.9f, 0.1f)));
            rest_tangents.emplace_back(other, v % 2 == 0 ? 1.0f : -1.0f);
            reference::VertexJoints own;
            const std::size_t any_joint = random(), first = neighbours == Neighbours::alike ? v / 5 : any_joint;
            for (std::size_t k = 0; k < static_cast<std::size_t>(influences); ++k)
                own.emplace_back((first + 3 * k) % joint_count, positive(random));
            for (std::size_t set = 0; set < 2; ++set) {
                glm::uvec4 joint(0);
                glm::vec4 weight(0.0f);
                for (std::size_t k = 4 * set; k < std::min(own.size(), 4 * set + 4); ++k) {
                    joint[static_cast<int>(k - 4 * set)] = static_cast<std::uint32_t>(own[k].first);
                    weight[static_cast<int>(k - 4 * set)] = static_cast<float>(own[k].second);
                }
                sets[set].push_back(joint);
                of_sets[set].push_back(weight);
            }
            joints.push_back(reference::normalised(own));
        }
        weights = pack_skin_weights(vertices, joint_count, sets[0], of_sets[0], sets[1], of_sets[1]);
        for (std::size_t j = 0; j < joint_count; ++j) matrices.push_back(reference::random_rigid(random));
        positions.resize(vertices);
        normals.resize(vertices);
        tangents.resize(vertices);
        pose();
    }

    /// Makes the palettes of `matrices`.
    void pose() {
        palette.resize(weights.palette_size());
        motions.resize(weights.palette_size());
        SkinPaletteJob job{.joints_double = matrices, .palette = palette, .motions = motions};
        job.validate();
        job.run();
    }

    SkinJob job(SkinMethod method) {
        return {.method = method,
                .rest_positions = rest_positions,
                .rest_normals = rest_normals,
                .rest_tangents = rest_tangents,
                .weights = &weights,
                .palette = palette,
                .motions = motions,
                .positions = positions,
                .normals = normals,
                .tangents = tangents};
    }

    /// Everything that a job wrote, bit by bit.
    [[nodiscard]] std::vector<std::uint32_t> bits() const {
        std::vector<std::uint32_t> all(10 * positions.size());
        std::memcpy(all.data(), positions.data(), 12 * positions.size());
        std::memcpy(all.data() + 3 * positions.size(), normals.data(), 12 * positions.size());
        std::memcpy(all.data() + 6 * positions.size(), tangents.data(), 16 * positions.size());
        return all;
    }

    void expect_defined() const {
        for (std::size_t v = 0; v < positions.size(); ++v) {
            for (int i = 0; i < 3; ++i) ASSERT_TRUE(std::isfinite(positions[v][i])) << v;
            ASSERT_NEAR(glm::length(normals[v]), 1.0f, 1e-5f) << v;
            ASSERT_NEAR(glm::length(glm::vec3(tangents[v])), 1.0f, 1e-5f) << v;
            ASSERT_NEAR(glm::dot(normals[v], glm::vec3(tangents[v])), 0.0f, 1e-4f) << v;
            ASSERT_EQ(std::abs(tangents[v].w), 1.0f) << v;
        }
    }
};

using Blend = glm::dmat4 (*)(const reference::VertexJoints&, std::span<const glm::dmat4>);

void expect_like(const Skinned& mesh, Blend blend, double tolerance) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const glm::dmat4 m = blend(mesh.joints[v], mesh.matrices);
        const glm::dvec3 p = reference::point(m, mesh.rest_positions[v]);
        ASSERT_LT(glm::distance(glm::dvec3(mesh.positions[v]), p), tolerance * (1.0 + glm::length(p))) << v;
        if (std::abs(glm::determinant(glm::dmat3(m))) < 1e-2) continue; // nearly collapsed: any error grows
        ASSERT_LT(glm::distance(glm::dvec3(mesh.normals[v]), reference::normal(m, mesh.rest_normals[v])), 1e-4) << v;
        const glm::dvec3 n(mesh.normals[v]), t = glm::dmat3(m) * glm::dvec3(mesh.rest_tangents[v]);
        const glm::dvec3 beside = t - glm::dot(t, n) * n;
        if (glm::length(beside) < 0.1) continue;
        ASSERT_LT(glm::distance(glm::dvec3(mesh.tangents[v]), glm::normalize(beside)), 1e-4) << v;
    }
}

class EveryInstructionSet : public testing::TestWithParam<InstructionSet> {
protected:
    void SetUp() override {
        if (!is_supported(GetParam())) GTEST_SKIP() << "this machine has no such instructions";
    }
};
INSTANTIATE_TEST_SUITE_P(Skin, EveryInstructionSet,
                         testing::Values(InstructionSet::portable, InstructionSet::avx2, InstructionSet::avx512),
                         [](const auto& of) {
                             return std::string(std::array{"portable", "avx2", "avx512"}[static_cast<int>(of.param)]);
                         });

TEST_P(EveryInstructionSet, BlendsAsTheFormulasSay) {
    for (const std::size_t joint_count : {24, 300, 70000}) // indices of one, two and four bytes
        for (const auto& [influences, neighbours] :
             {std::pair(1, Neighbours::unlike), std::pair(4, Neighbours::unlike), std::pair(8, Neighbours::unlike),
              std::pair(1, Neighbours::alike), std::pair(4, Neighbours::alike), std::pair(8, Neighbours::alike)}) {
            Skinned mesh(517, joint_count, influences, 1, neighbours);
            SkinJob job = mesh.job(SkinMethod::linear);
            job.instructions = GetParam();
            job.validate();
            job.run();
            expect_like(mesh, &reference::linear_blend, 1e-6);
            mesh.expect_defined();
            job.method = SkinMethod::dual_quaternion;
            job.validate();
            job.run();
            expect_like(mesh, &reference::dual_quaternion_blend, 4e-6);
            mesh.expect_defined();
        }
}

TEST_P(EveryInstructionSet, ResultsDoNotDependOnRanges) {
    for (const auto& [method, neighbours] :
         {std::pair(SkinMethod::linear, Neighbours::unlike), std::pair(SkinMethod::linear, Neighbours::alike),
          std::pair(SkinMethod::dual_quaternion, Neighbours::unlike)}) {
        Skinned mesh(331, 40, 4, 1, neighbours);
        SkinJob whole = mesh.job(method);
        whole.instructions = GetParam();
        whole.run();
        const auto expected = mesh.bits();
        const Bounds bounds = whole.bounds;
        for (const std::size_t size : {1, 3, 16, 17, 100}) {
            std::ranges::fill(mesh.positions, glm::vec3(0.0f));
            Bounds joined;
            for (std::size_t first = 0; first < 331; first += size) {
                SkinJob part = whole;
                part.range = {first, size};
                part.run();
                joined.include(part.bounds);
            }
            EXPECT_EQ(mesh.bits(), expected) << size;
            EXPECT_EQ(joined.low, bounds.low);
            EXPECT_EQ(joined.high, bounds.high);
        }
        EXPECT_EQ(bounds.low, bounds_of(mesh.positions).low);
        EXPECT_EQ(bounds.high, bounds_of(mesh.positions).high);
    }
}

TEST_P(EveryInstructionSet, StaysDefinedWhateverTheJointsDo) {
    Skinned mesh(400, 30, 4);
    std::mt19937 random(3);
    std::normal_distribution<double> any;
    for (std::size_t j = 0; j < mesh.matrices.size(); ++j) {
        glm::dmat4& m = mesh.matrices[j];
        const double scales[] = {0.0, -1.0, 1e-12, 1e-7, 1e6, 1e14, -1e-3};
        const double s = scales[j % std::size(scales)];
        if (j % 3 == 0) m = glm::scale(m, glm::dvec3(s, 1.0, any(random)));
        if (j % 3 == 1) m = glm::scale(m, glm::dvec3(s));
        if (j % 3 == 2) m[static_cast<int>(j % 4)] = glm::dvec4(std::numeric_limits<double>::quiet_NaN());
    }
    mesh.pose();
    for (const SkinMethod method : {SkinMethod::linear, SkinMethod::dual_quaternion}) {
        SkinJob job = mesh.job(method);
        job.instructions = GetParam();
        job.run();
        mesh.expect_defined();
    }
}

TEST_P(EveryInstructionSet, OneMirroringJointTurnsNoNormalInwards) {
    for (const SkinMethod method : {SkinMethod::linear, SkinMethod::dual_quaternion}) {
        Skinned mesh(64, 5, 1);
        for (glm::dmat4& m : mesh.matrices) m = glm::scale(m, glm::dvec3(-1.5, 0.5, 1.0));
        mesh.pose();
        SkinJob job = mesh.job(method);
        job.instructions = GetParam();
        job.run();
        expect_like(mesh, &reference::linear_blend, 1e-5); // of one influence: both methods are the matrix itself
        for (std::size_t v = 0; v < 64; ++v) EXPECT_EQ(mesh.tangents[v].w, -mesh.rest_tangents[v].w);
    }
}

TEST(Skin, FlattenedJointsKeepTheNormalOfTheirPlane) {
    Skinned mesh(64, 3, 1);
    for (glm::dmat4& m : mesh.matrices) m = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, 0.0));
    mesh.pose();
    mesh.job(SkinMethod::linear).run();
    for (const glm::vec3& n : mesh.normals) EXPECT_NEAR(n.z, 1.0f, 1e-6f); // rest normals all have z > 0
    mesh.expect_defined();
}

TEST(Skin, ATwistBy180DegreesCollapsesLinearBlendingOnly) {
    Skinned mesh(64, 2, 2);
    for (auto& own : mesh.joints) own = {{0, 0.5}, {1, 0.5}};
    const std::vector<glm::u16vec4> joints(64, {0, 1, 0, 0});
    const std::vector<glm::vec4> halves(64, {0.5f, 0.5f, 0.0f, 0.0f});
    mesh.weights = pack_skin_weights(64, 2, joints, halves);
    mesh.matrices = {glm::dmat4(1.0), glm::rotate(glm::dmat4(1.0), pi, glm::dvec3(0, 1, 0))};
    mesh.pose();
    mesh.job(SkinMethod::linear).run();
    mesh.expect_defined();
    for (std::size_t v = 0; v < 64; ++v) EXPECT_NEAR(mesh.positions[v].x, 0.0f, 1e-6f);
    mesh.job(SkinMethod::dual_quaternion).run();
    mesh.expect_defined();
    for (std::size_t v = 0; v < 64; ++v)
        EXPECT_NEAR(glm::length(mesh.positions[v]), glm::length(mesh.rest_positions[v]), 1e-5f);
}

TEST(Skin, NegatedQuaternionsAreTheSameRotation) {
    Skinned mesh(200, 20, 4);
    SkinJob job = mesh.job(SkinMethod::dual_quaternion);
    job.run();
    const auto expected = mesh.positions;
    for (std::size_t j = 0; j < mesh.motions.size(); j += 2) {
        mesh.motions[j].real = -mesh.motions[j].real;
        mesh.motions[j].dual = -mesh.motions[j].dual;
    }
    job.run();
    for (std::size_t v = 0; v < 200; ++v) EXPECT_LT(glm::distance(mesh.positions[v], expected[v]), 1e-5f);
}

TEST(Skin, VerticesWithoutJointsStayAtRest) {
    Skinned mesh(50, 3, 4);
    mesh.weights = pack_skin_weights(50, 3, std::span<const glm::u16vec4>(), {});
    for (const SkinMethod method : {SkinMethod::linear, SkinMethod::dual_quaternion}) {
        mesh.job(method).run();
        EXPECT_EQ(mesh.positions, mesh.rest_positions);
    }
}

TEST(Skin, PositionsAlone) {
    Skinned mesh(50, 3, 4);
    SkinJob all = mesh.job(SkinMethod::linear);
    all.run();
    const auto expected = mesh.positions;
    SkinJob job{.rest_positions = mesh.rest_positions,
                .weights = &mesh.weights,
                .palette = mesh.palette,
                .positions = mesh.positions};
    std::ranges::fill(mesh.positions, glm::vec3(0.0f));
    job.validate();
    job.run();
    EXPECT_EQ(mesh.positions, expected);
}

TEST(Skin, ThreadsChangeNothing) {
    Skinned mesh(50000, 60, 4);
    SkinJob job = mesh.job(SkinMethod::linear);
    job.run();
    const auto expected = mesh.bits();
    const int before = thread_limit();
    for (const int threads : {1, 2, 5}) {
        set_thread_limit(threads);
        std::ranges::fill(mesh.positions, glm::vec3(0.0f));
        SkinJob parallel = mesh.job(SkinMethod::linear);
        skin_in_parallel(parallel);
        EXPECT_EQ(mesh.bits(), expected);
        EXPECT_EQ(parallel.bounds.high, job.bounds.high);
    }
    set_thread_limit(before);
}

TEST(Skin, JobsAcceptNoRangeBeyondTheMesh) {
    Skinned mesh(20, 3, 4);
    SkinJob job = mesh.job(SkinMethod::linear);
    job.range = {25, 10};
    job.run();
    EXPECT_TRUE(job.bounds.empty());
    EXPECT_EQ(mesh.positions[19], glm::vec3(0.0f));
    job.range = {18, std::numeric_limits<std::size_t>::max()};
    job.run();
    EXPECT_NE(mesh.positions[19], glm::vec3(0.0f));
    EXPECT_EQ(mesh.positions[17], glm::vec3(0.0f));
    job.palette = job.palette.first(2);
    EXPECT_DEATH(job.validate(), "palette entry");
}

TEST(DeformedBounds, HoldEveryVertexWithoutTouchingIt) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        Skinned mesh(300, 7, 4, seed);
        SkinJob job = mesh.job(SkinMethod::linear);
        job.run();
        const Bounds box = deformed_bounds(rest_joint_bounds(mesh.weights, mesh.rest_positions), mesh.palette);
        for (int i = 0; i < 3; ++i) {
            EXPECT_LE(box.low[i], job.bounds.low[i]);
            EXPECT_GE(box.high[i], job.bounds.high[i]);
        }
        EXPECT_LT(box.radius(), 4.0f * job.bounds.radius());
    }
    EXPECT_TRUE(deformed_bounds(std::vector<Bounds>(3), std::vector<JointMatrix>(3)).empty());
}

} // namespace
} // namespace hachure::geometry
