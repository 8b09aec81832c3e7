#include <hachure/runtime/geometry/tangents.h>

#include <glm/gtc/constants.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "reference.h"

namespace hachure::geometry {
namespace {

ComputedTangents tangents_of(const Shape& shape) {
    return vertex_tangents(shape.positions, shape.normals, shape.texcoords, shape.indices);
}

double angle(const glm::dvec3& a, const glm::dvec3& b) { return std::atan2(glm::length(glm::cross(a, b)), dot(a, b)); }

glm::dvec3 bitangent(const ComputedTangents& computed, const Shape& shape, std::size_t v) {
    const glm::dvec3 n(shape.normals[computed.source[v]]), t(computed.tangents[v]);
    return static_cast<double>(computed.tangents[v].w) * glm::cross(n, t);
}

/// What holds of every mesh: tangents are unit and perpendicular to their normals, and triangles keep their corners.
void expect_sound(const ComputedTangents& computed, const Shape& shape) {
    ASSERT_EQ(computed.tangents.size(), computed.source.size());
    ASSERT_GE(computed.source.size(), shape.positions.size());
    for (std::uint32_t v = 0; v < shape.positions.size(); ++v) ASSERT_EQ(computed.source[v], v);
    for (std::size_t v = 0; v < computed.source.size(); ++v) {
        const glm::dvec3 t(computed.tangents[v]), n(shape.normals[computed.source[v]]);
        ASSERT_NEAR(glm::length(t), 1.0, 1e-6) << v;
        ASSERT_NEAR(glm::dot(t, n), 0.0, 2e-6) << v;
        ASSERT_EQ(std::abs(computed.tangents[v].w), 1.0f) << v;
    }
    ASSERT_EQ(computed.indices.size(), shape.indices.size());
    for (std::size_t c = 0; c < shape.indices.size(); ++c)
        ASSERT_EQ(computed.source[computed.indices[c]], shape.indices[c]) << c;
}

/// Texture coordinates of the shapes grow upwards, so that pictures on them are mirrored: w = -1.
TEST(VertexTangents, AreExactOnAPlane) {
    const Shape shape = plane(3.0, 5);
    const ComputedTangents computed = tangents_of(shape);
    expect_sound(computed, shape);
    EXPECT_EQ(computed.source.size(), shape.positions.size());
    for (const glm::vec4& tangent : computed.tangents) {
        EXPECT_NEAR(tangent.x, 1.0f, 1e-6f);
        EXPECT_EQ(tangent.w, -1.0f);
    }
}

/// Directions of growing u around +Y, and of falling v.
glm::dvec3 around(const glm::vec3& n) { return glm::normalize(glm::dvec3(n.z, 0.0, -n.x)); }
glm::dvec3 down(const glm::vec3& n) { return glm::cross(around(n), glm::dvec3(n)); }

TEST(VertexTangents, AreExactOnTheSideOfACylinder) {
    const Shape shape = cylinder(0.7, 2.0, 24);
    const ComputedTangents computed = tangents_of(shape);
    expect_sound(computed, shape);
    int checked = 0;
    for (std::size_t v = 0; v < computed.source.size(); ++v) {
        const glm::vec3 n = shape.normals[computed.source[v]];
        if (n.y != 0.0f) continue;
        EXPECT_LT(angle(glm::dvec3(computed.tangents[v]), around(n)), 1e-6);
        EXPECT_LT(angle(bitangent(computed, shape, v), down(n)), 1e-6);
        ++checked;
    }
    EXPECT_EQ(checked, 50);
}

/// The largest angle to the closed form off the poles, where u has no direction. Vertices at the seam have their
/// triangles on one side only.
double sphere_error(std::uint32_t slices) {
    const Shape shape = uv_sphere(2.0, slices, slices / 2);
    const ComputedTangents computed = tangents_of(shape);
    expect_sound(computed, shape);
    double error = 0.0;
    for (std::size_t v = 0; v < computed.source.size(); ++v) {
        const glm::vec3 n = shape.normals[computed.source[v]];
        if (std::abs(n.y) > 0.99f) continue;
        error = std::max(error, angle(glm::dvec3(computed.tangents[v]), around(n)));
        error = std::max(error, angle(bitangent(computed, shape, v), down(n)));
    }
    return error;
}

TEST(VertexTangents, ConvergeOnASphere) {
    const double coarse = sphere_error(48), fine = sphere_error(96);
    EXPECT_LT(coarse, glm::pi<double>() / 48); // a chord is turned by half a slice, and seen obliquely
    EXPECT_NEAR(coarse / fine, 2.0, 0.3);
}

struct Corner {
    std::uint32_t vertex;
    glm::dvec3 u;  ///< unit, in the plane of the normal
    double weight; ///< the corner's angle in that plane
    bool mirrored;
};

/// Corners as the definition has them: the derivative by u solves a linear system, angles come from cosines.
std::vector<Corner> reference_corners(const Shape& s) {
    std::vector<Corner> corners;
    for (std::size_t c = 0; c < s.indices.size(); ++c) {
        const std::size_t first = c - c % 3;
        const std::uint32_t i = s.indices[c], j = s.indices[first + (c + 1) % 3], k = s.indices[first + (c + 2) % 3];
        const glm::dvec3 n(s.normals[i]), p(s.positions[i]);
        const glm::dvec3 a = glm::dvec3(s.positions[j]) - p, b = glm::dvec3(s.positions[k]) - p;
        const glm::dmat2 uv(glm::dvec2(s.texcoords[j]) - glm::dvec2(s.texcoords[i]),
                            glm::dvec2(s.texcoords[k]) - glm::dvec2(s.texcoords[i]));
        const glm::dvec2 along_u = glm::inverse(uv) * glm::dvec2(1.0, 0.0);
        const auto flat = [&](const glm::dvec3& v) { return glm::normalize(v - n * glm::dot(n, v)); };
        corners.push_back({i, flat(along_u.x * a + along_u.y * b), std::acos(glm::dot(flat(a), flat(b))),
                           glm::determinant(uv) > 0.0});
    }
    return corners;
}

// The texture coordinates of this torus wrap within the triangles of its seams, which are mirrored therefore.
TEST(VertexTangents, AreTheAngleWeightedMeanOfEachHand) {
    const Shape shape = irregular_torus(1.0, 0.4, 20, 12, 0.35, 7);
    const ComputedTangents computed = tangents_of(shape);
    expect_sound(computed, shape);
    EXPECT_GT(computed.source.size(), shape.positions.size());
    const std::vector<Corner> corners = reference_corners(shape);
    for (std::size_t v = 0; v < computed.source.size(); ++v) {
        glm::dvec3 sum(0.0);
        for (const Corner& corner : corners)
            if (corner.vertex == computed.source[v] && corner.mirrored == (computed.tangents[v].w < 0.0f))
                sum += corner.weight * corner.u;
        EXPECT_LT(angle(glm::dvec3(computed.tangents[v]), sum), 1e-6) << v;
    }
    for (std::size_t c = 0; c < corners.size(); ++c)
        EXPECT_EQ(computed.tangents[computed.indices[c]].w < 0.0f, corners[c].mirrored) << c;
}

/// Two quads side by side, the right one with the mirror image of the left one's texture.
Shape mirrored_pair() {
    Shape shape;
    for (int y = 0; y < 2; ++y)
        for (int x = -1; x <= 1; ++x) {
            shape.positions.emplace_back(x, y, 0);
            shape.texcoords.emplace_back(std::abs(x), 1 - y);
        }
    shape.normals.assign(6, {0, 0, 1});
    shape.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
    return shape;
}

TEST(VertexTangents, VerticesBetweenHandsAreSplit) {
    const Shape shape = mirrored_pair();
    const ComputedTangents computed = tangents_of(shape);
    expect_sound(computed, shape);
    EXPECT_THAT(computed.source, testing::ElementsAre(0, 1, 2, 3, 4, 5, 1, 4));
    EXPECT_THAT(computed.indices, testing::ElementsAre(0, 1, 4, 0, 4, 3, 6, 2, 5, 6, 5, 7));
    for (std::size_t c = 0; c < 12; ++c) // u grows outwards on both sides, and v downwards: the left is the mirror
        EXPECT_EQ(computed.tangents[computed.indices[c]], c < 6 ? glm::vec4(-1, 0, 0, -1) : glm::vec4(1, 0, 0, 1)) << c;
    for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(bitangent(computed, shape, v), glm::dvec3(0, 1, 0));
}

TEST(VertexTangents, DoNotDependOnSharedVertices) {
    const Shape shape = irregular_torus(1.0, 0.4, 20, 12, 0.35, 7);
    Shape loose;
    for (const std::uint32_t i : shape.indices) {
        loose.indices.push_back(static_cast<std::uint32_t>(loose.positions.size()));
        loose.positions.push_back(shape.positions[i]);
        loose.normals.push_back(shape.normals[i]);
        loose.texcoords.push_back(shape.texcoords[i]);
    }
    const ComputedTangents shared = tangents_of(shape), computed = tangents_of(loose);
    EXPECT_EQ(computed.source.size(), loose.positions.size());
    for (std::size_t c = 0; c < shape.indices.size(); ++c)
        EXPECT_EQ(computed.tangents[computed.indices[c]], shared.tangents[shared.indices[c]]) << c;
}

TEST(VertexTangents, TrianglesWithoutTextureAreaTakeTheirNeighbours) {
    Shape shape = mirrored_pair();
    for (glm::vec2& texcoord : shape.texcoords) texcoord.x = std::max(texcoord.x, 0.0f);
    shape.texcoords[2].x = shape.texcoords[5].x = 0.0f; // nothing of u is left on the right
    const ComputedTangents computed = tangents_of(shape);
    expect_sound(computed, shape);
    EXPECT_EQ(computed.source.size(), 6u);
    for (const std::uint32_t v : {0u, 1u, 3u, 4u}) EXPECT_EQ(computed.tangents[v], glm::vec4(-1, 0, 0, -1)) << v;
}

TEST(VertexTangents, AreDefinedForEveryDegenerateTriangle) {
    const float tiny = std::numeric_limits<float>::denorm_min(), huge = std::numeric_limits<float>::max();
    const std::vector<std::vector<glm::vec3>> places = {
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},       {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}},       {{0, 0, 0}, {0, 0, 1}, {0, 0, 3}},
        {{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}}, {{-huge, 0, 0}, {huge, 0, 0}, {0, huge, -huge}}};
    const std::vector<std::vector<glm::vec2>> textures = {
        {{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {0, 0}, {0, 0}},       {{0, 0}, {1, 1}, {3, 3}},
        {{5, 5}, {5, 5}, {6, 7}}, {{0, 0}, {tiny, 0}, {0, tiny}}, {{-huge, 0}, {huge, 0}, {0, huge}}};
    for (const auto& place : places)
        for (const auto& texture : textures)
            for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0.6f, 0, -0.8f)})
                expect_sound(tangents_of({place, {3, normal}, texture, {0, 1, 2}}),
                             {place, {3, normal}, texture, {0, 1, 2}});
}

TEST(VertexTangents, OppositeDirectionsThatCancelLeaveSomeTangent) {
    Shape shape{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                .normals = {5, {0, 0, 1}},
                .texcoords = {{0, 0}, {1, 0}, {0, 1}, {1, 0}, {0, 1}},
                .indices = {0, 1, 2, 0, 3, 4}};
    expect_sound(tangents_of(shape), shape);
}

TEST(VertexTangents, AreDefinedWithoutTriangles) {
    const Shape points{.positions = {{1, 2, 3}}, .normals = {{0, 1, 0}}, .texcoords = {{0, 0}}, .indices = {}};
    expect_sound(tangents_of(points), points);
    EXPECT_TRUE(tangents_of({}).tangents.empty());
}

TEST(VertexTangents, AreSoundOnNoise) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> value(-1.0f, 1.0f);
    Shape shape;
    for (int v = 0; v < 300; ++v) {
        shape.positions.emplace_back(value(random), value(random), value(random));
        shape.normals.push_back(glm::normalize(glm::vec3(value(random), value(random), value(random) + 1.5f)));
        shape.texcoords.emplace_back(std::round(2 * value(random)), std::round(2 * value(random)));
    }
    for (int c = 0; c < 3000; ++c) shape.indices.push_back(static_cast<std::uint32_t>(random() % 300));
    expect_sound(tangents_of(shape), shape);
}

} // namespace
} // namespace hachure::geometry
