#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/weld.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "reference.h"

namespace hachure::geometry {
namespace {

using testing::ElementsAreArray;

constexpr NormalWeight all_weights[] = {NormalWeight::area, NormalWeight::angle, NormalWeight::angle_area,
                                        NormalWeight::max1999};
constexpr float half_pi = std::numbers::pi_v<float> / 2.0f;

double torus_error(const Shape& shape, NormalWeight weight) {
    return reference::rms_degrees(vertex_normals(shape.positions, shape.indices, {.weight = weight}).normals,
                                  shape.normals);
}

// readings.md of the project's papers: angle x area 1.17 degrees, Max 1999 .40, on an irregular torus of 10k vertices.
TEST(VertexNormals, MaxIsTheBestOnACleanIrregularTorus) {
    const Shape shape = irregular_torus(1.0, 0.4, 160, 64, 0.4, 5);
    const double angle_area = torus_error(shape, NormalWeight::angle_area);
    const double max1999 = torus_error(shape, NormalWeight::max1999);
    RecordProperty("angle_area_degrees", std::to_string(angle_area));
    RecordProperty("max1999_degrees", std::to_string(max1999));
    EXPECT_GT(angle_area, 0.6);
    EXPECT_LT(angle_area, 1.8);
    EXPECT_GT(max1999, 0.2);
    EXPECT_LT(max1999, 0.6);
    EXPECT_LT(max1999, 0.5 * angle_area);
    EXPECT_LT(max1999, torus_error(shape, NormalWeight::angle));
    EXPECT_LT(max1999, torus_error(shape, NormalWeight::area));
}

TEST(VertexNormals, TheOrderReversesUnderNoise) {
    Shape shape = irregular_torus(1.0, 0.4, 160, 64, 0.4, 5);
    std::mt19937 random(1);
    std::normal_distribution<float> noise(0.0f, 0.05f * 0.04f); // 5 % of an edge
    for (std::size_t v = 0; v < shape.positions.size(); ++v) shape.positions[v] += noise(random) * shape.normals[v];
    EXPECT_LT(torus_error(shape, NormalWeight::angle_area), torus_error(shape, NormalWeight::max1999));
}

TEST(VertexNormals, MaxIsExactOnASphere) {
    Shape shape = icosphere(1.0, 3);
    std::mt19937 random(2);
    std::normal_distribution<float> noise(0.0f, 0.02f);
    for (glm::vec3& p : shape.positions) p = glm::normalize(p + glm::vec3(noise(random), noise(random), noise(random)));
    shape.normals = shape.positions;
    EXPECT_LT(torus_error(shape, NormalWeight::max1999), 1e-4);
    EXPECT_GT(torus_error(shape, NormalWeight::angle_area), 0.1); // the mesh is irregular enough to tell
}

// A corner at the origin between axes of different lengths: every weight in closed form.
TEST(VertexNormals, WeightsFollowTheirFormulas) {
    const std::vector<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 0, 4}};
    const std::vector<std::uint32_t> indices{0, 1, 2, 0, 3, 4};
    // First triangle: normal +Z, area 1, angle 90 degrees, edges 1 and 2. Second: normal +Y, area 1.5, edges 3 and
    // sqrt 17, and a corner with tangent 1/4.
    const double angle = std::atan2(1.0, 4.0), sine = 1.0 / std::sqrt(17.0);
    const std::pair<NormalWeight, glm::dvec3> expected[] = {
        {NormalWeight::area, {0, 1.5, 1.0}},
        {NormalWeight::angle, {0, angle, std::numbers::pi / 2}},
        {NormalWeight::angle_area, {0, 1.5 * angle, std::numbers::pi / 2}},
        {NormalWeight::max1999, {0, sine / (3.0 * std::sqrt(17.0)), 1.0 / 2.0}},
    };
    for (const auto& [weight, sum] : expected) {
        const glm::dvec3 n(vertex_normals(p, indices, {.weight = weight}).normals[0]);
        EXPECT_NEAR(glm::distance(n, glm::normalize(sum)), 0.0, 1e-6) << static_cast<int>(weight);
    }
}

TEST(VertexNormals, DoNotDependOnTheScale) {
    const Shape shape = irregular_torus(1.0, 0.4, 12, 8, 0.3, 1);
    for (const NormalWeight weight : all_weights)
        for (const float scale : {1e-18f, 1e-6f, 1e15f}) {
            std::vector<glm::vec3> scaled = shape.positions;
            for (glm::vec3& p : scaled) p *= scale;
            const auto a = vertex_normals(shape.positions, shape.indices, {.weight = weight});
            const auto b = vertex_normals(scaled, shape.indices, {.weight = weight});
            EXPECT_LT(reference::rms_degrees(a.normals, b.normals), 1e-4) << scale << " " << static_cast<int>(weight);
        }
}

TEST(VertexNormals, AreSharedAcrossSeams) {
    const Shape shape = torus(2.0, 0.5, 24, 12); // with its seams repeated
    const auto result = vertex_normals(shape.positions, shape.indices);
    const std::vector<std::uint32_t> place = reference::weld(shape.positions);
    EXPECT_EQ(result.normals.size(), shape.positions.size());
    for (std::size_t v = 0; v < place.size(); ++v) EXPECT_EQ(result.normals[v], result.normals[place[v]]);
}

TEST(VertexNormals, StayHardOnACubeOfEightVertices) {
    std::vector<glm::vec3> p;
    for (int i = 0; i < 8; ++i) p.emplace_back(i & 1, (i >> 1) & 1, i >> 2);
    const std::vector<std::uint32_t> indices{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                             2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    const auto hard = vertex_normals(p, indices, {.crease_angle = half_pi * 0.5f});
    EXPECT_EQ(hard.normals.size(), 24u); // three for each corner
    ASSERT_EQ(hard.source.size(), 24u);
    for (std::size_t c = 0; c < indices.size(); ++c) {
        EXPECT_EQ(hard.source[hard.indices[c]], indices[c]);
        const glm::dvec3 flat = glm::normalize(reference::area_normal(p, indices, c / 3));
        EXPECT_NEAR(glm::distance(glm::dvec3(hard.normals[hard.indices[c]]), flat), 0.0, 1e-6);
    }
    const auto soft = vertex_normals(p, indices, {.crease_angle = half_pi * 1.01f});
    EXPECT_EQ(soft.normals.size(), 8u);
    EXPECT_THAT(soft.indices, ElementsAreArray(indices));
}

TEST(VertexNormals, SplitACylinderAtItsRimsOnly) {
    const Shape shape = cylinder(1.0, 2.0, 32);
    const auto result = vertex_normals(shape.positions, shape.indices, {.crease_angle = 0.6f});
    std::vector<glm::vec3> expected;
    for (const std::uint32_t v : result.source) expected.push_back(shape.normals[v]);
    EXPECT_EQ(result.normals.size(), shape.positions.size()); // its vertices are split where they should be
    EXPECT_LT(reference::rms_degrees(result.normals, expected), 0.1);
}

TEST(VertexNormals, SmoothIsTheLimitOfALargeCreaseAngle) {
    const Shape shape = irregular_torus(1.0, 0.4, 30, 20, 0.4, 5);
    const auto smooth = vertex_normals(shape.positions, shape.indices);
    const auto creased = vertex_normals(shape.positions, shape.indices, {.crease_angle = 3.0f});
    EXPECT_EQ(creased.normals.size(), smooth.normals.size());
    EXPECT_LT(reference::rms_degrees(smooth.normals, creased.normals), 1e-5);
}

TEST(VertexNormals, ADegenerateTriangleAddsNothing) {
    const std::vector<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {5, 5, 5}};
    const std::vector<std::uint32_t> indices{0, 1, 2, 0, 1, 3, 1, 1, 2};
    for (const float crease : {0.5f, std::numbers::pi_v<float>})
        for (const NormalWeight weight : all_weights) {
            const auto result = vertex_normals(p, indices, {weight, crease});
            ASSERT_EQ(result.normals.size(), 5u);
            for (const int v : {0, 1, 2}) EXPECT_EQ(result.normals[static_cast<std::size_t>(v)], glm::vec3(0, 0, 1));
            EXPECT_EQ(result.normals[3], default_normal); // used by the degenerate triangle only
            EXPECT_EQ(result.normals[4], default_normal); // isolated
            EXPECT_THAT(result.indices, ElementsAreArray(indices));
        }
}

TEST(VertexNormals, AVertexOfDegenerateTrianglesTakesANormalOfItsPlace) {
    // Vertex 3 lies on vertex 0 and belongs to a triangle without an area.
    const std::vector<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    const std::vector<std::uint32_t> indices{0, 1, 2, 3, 3, 1};
    EXPECT_EQ(vertex_normals(p, indices, {.crease_angle = 0.5f}).normals[3], glm::vec3(0, 0, 1));
    EXPECT_EQ(vertex_normals(p, indices).normals[3], glm::vec3(0, 0, 1));
}

TEST(VertexNormals, ManyTrianglesOnOneEdgeAreNoTrouble) {
    std::vector<glm::vec3> p{{0, 0, 0}, {0, 0, 1}};
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        p.emplace_back(std::cos(0.001 * i), std::sin(0.001 * i), 0.5);
        indices.insert(indices.end(), {0, 1, i + 2});
    }
    for (const glm::vec3& n : vertex_normals(p, indices, {.crease_angle = 0.5f}).normals)
        ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
}

TEST(SmoothNormalsJob, GivesVertexNormalsWithoutAllocatingAgain) {
    Shape shape = torus(2.0, 0.5, 24, 12);
    const std::vector<std::uint32_t> place = weld_positions(shape.positions);
    std::vector<glm::vec3> normals(shape.positions.size());
    SmoothNormalsJob job{shape.positions, shape.indices, place, NormalWeight::angle, normals};
    job.validate();
    job.run();
    EXPECT_EQ(normals, vertex_normals(shape.positions, shape.indices, {.weight = NormalWeight::angle}).normals);
    const void* scratch = job.sums.data();
    for (glm::vec3& p : shape.positions) p.y *= 2.0f;
    job.run();
    EXPECT_EQ(normals, vertex_normals(shape.positions, shape.indices, {.weight = NormalWeight::angle}).normals);
    EXPECT_EQ(job.sums.data(), scratch);
}

TEST(SmoothNormalsJobDeathTest, RefusesSizesThatDisagree) {
    const Shape shape = cube(1.0);
    const std::vector<std::uint32_t> place = weld_positions(shape.positions);
    std::vector<glm::vec3> normals(3);
    SmoothNormalsJob job{shape.positions, shape.indices, place, NormalWeight::area, normals};
    EXPECT_DEATH(job.validate(), "one element per vertex");
}

} // namespace
} // namespace hachure::geometry
