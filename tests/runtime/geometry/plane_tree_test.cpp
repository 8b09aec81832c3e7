#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/creases.h>
#include <hachure/runtime/geometry/select_edges.h>
#include <hachure/runtime/geometry/select_edges_by_tree.h>
#include <hachure/runtime/parallel.h>
#include <hachure/tests/support/given_models.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "line_mesh.h"

namespace hachure::geometry {
namespace {

using reference::LineMesh;

/// A mesh whose edges are chosen by the plain loop and by the tree.
struct Both {
    LineMesh mesh;
    std::vector<ChosenEdge> features;
    PlaneTree tree;
    std::vector<std::uint8_t> front;
    std::vector<ChosenEdge> chosen;
    SelectEdgesJob loop;
    SelectEdgesByTreeJob by_tree;

    explicit Both(LineMesh given) : mesh(std::move(given)), front(mesh.planes.size()), chosen(mesh.table.edges.size()) {
        const std::vector<std::uint8_t> creases =
            find_creases(mesh.positions, mesh.table.edges, mesh.planes, 0.8f, 0.0f);
        features = feature_edges(mesh.table.edges, creases, {});
        tree = edge_tree(mesh.table.edges, mesh.planes);
        loop = {.edges = mesh.table.edges,
                .planes = mesh.planes,
                .features = features,
                .closed = is_closed(mesh.table.edges),
                .front = front,
                .chosen = chosen};
        by_tree = {.edges = mesh.table.edges,
                   .planes = mesh.planes,
                   .features = features,
                   .tree = &tree,
                   .closed = loop.closed};
        loop.validate();
        by_tree.validate();
    }
    Both(const Both&) = delete;
    Both& operator=(const Both&) = delete;

    /// Whether they agree from an eye; how many edges there are.
    testing::AssertionResult agree(const glm::vec4& eye) {
        loop.eye = by_tree.eye = eye;
        loop.run();
        by_tree.run();
        const std::span<const ChosenEdge> expected = std::span(chosen).first(loop.count);
        if (std::ranges::equal(expected, by_tree.chosen)) return testing::AssertionSuccess();
        return testing::AssertionFailure() << loop.count << " and " << by_tree.chosen.size() << " edges from " << eye.x
                                           << " " << eye.y << " " << eye.z << " " << eye.w;
    }
};

/// Some triangles turned round, some taken away.
Shape battered(Shape shape, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> indices;
    for (std::size_t f = 0; f < shape.indices.size(); f += 3) {
        if (random() % 100 < 10) continue;
        const bool turn = random() % 100 < 20;
        for (const std::size_t k : {0, 1, 2}) indices.push_back(shape.indices[f + (turn ? 2 - k : k)]);
    }
    shape.indices = indices;
    return shape;
}

/// Triangles of any size anywhere, many on common edges, some without an area.
Shape tangle(std::uint32_t seed, float where) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> at(-1.0f, 1.0f);
    Shape shape;
    for (std::uint32_t i = 0; i < 60; ++i)
        shape.positions.emplace_back(where + at(random), where + at(random) * at(random), at(random));
    for (std::uint32_t i = 0; i < 10; ++i)
        shape.positions.push_back(0.5f * (shape.positions[i] + shape.positions[i + 1]));
    for (std::uint32_t i = 0; i < 900; ++i) shape.indices.push_back(static_cast<std::uint32_t>(random() % 70));
    for (std::uint32_t i = 0; i < 10; ++i) shape.indices.insert(shape.indices.end(), {i, 60 + i, i + 1});
    return shape;
}

std::vector<Shape> tree_shapes() {
    return {icosphere(1.0, 4),
            torus(1.0, 0.4, 40, 24),
            irregular_torus(1.0, 0.4, 60, 30, 0.4, 5),
            cube(1.0),
            plane(1.0, 1),
            cone(0.7, 1.3, 17),
            battered(irregular_torus(1.0, 0.4, 60, 30, 0.4, 5), 3),
            tangle(1, 0.0f),
            tangle(2, 1000.0f),
            Shape{}};
}

std::vector<glm::vec4> random_eyes(int count, std::uint32_t seed) {
    std::vector<glm::vec4> eyes{glm::vec4(0.0f), {0, 0, 0, 1}, {0, 1, 0, 0}, {0.5f, 0.5f, 0.5f, 1}, {1e30f, 1, 1, 1}};
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 at(normal(random), normal(random), normal(random));
        if (i % 4 == 0) eyes.emplace_back(at, 0.0f);
        if (i % 4 == 1) eyes.emplace_back(at, 1.0f); // near and within
        if (i % 4 == 2) eyes.emplace_back(3.0f * at, 1.0f);
        if (i % 4 == 3) eyes.emplace_back(std::pow(10.0f, 2.0f * normal(random)) * at, normal(random));
    }
    return eyes;
}

TEST(PlaneTree, ChoosesWhatThePlainLoopChooses) {
    for (const Shape& shape : tree_shapes()) {
        Both both{LineMesh(shape)};
        std::uint32_t masks = 0;
        for (const glm::vec4& eye : random_eyes(600, 3)) {
            both.loop.wanted = both.by_tree.wanted = masks++ % 3 == 0 ? masks % 16 : ~0u;
            ASSERT_TRUE(both.agree(eye));
        }
    }
}

TEST(PlaneTree, ChoosesTheSameWhileTheEyeMovesByDegrees) {
    Both both{LineMesh(irregular_torus(1.0, 0.4, 100, 50, 0.33, 5))};
    std::size_t found = 0;
    for (int degree = 0; degree < 3600; ++degree) {
        const double angle = degree * std::numbers::pi / 180.0, height = 0.3 + degree / 1800.0;
        ASSERT_TRUE(both.agree({2.5 * std::cos(angle), height, 2.5 * std::sin(angle), 1.0}));
        found += both.by_tree.chosen.size();
    }
    EXPECT_GT(found, 3600u * 200u);
}

TEST(PlaneTree, LooksAtFewOfTheEdges) {
    Both both{LineMesh(icosphere(1.0, 6))};
    for (const glm::vec4& eye : {glm::vec4(2, 1, 1, 1), glm::vec4(0, 1, 0, 0), glm::vec4(0.9f, 0.7f, 0.6f, 1)}) {
        ASSERT_TRUE(both.agree(eye));
        EXPECT_GT(both.by_tree.chosen.size(), 150u);
        EXPECT_LT(both.by_tree.scratch.tested_items, both.mesh.table.edges.size() / 20);
    }
    ASSERT_TRUE(both.agree({0, 0, 0, 1})); // sees every face from behind
    EXPECT_EQ(both.by_tree.scratch.tested_items, 0u);
}

TEST(PlaneTree, AnEyeInThePlaneOfAFaceIsDecidedAlike) {
    Both both{LineMesh(cube(1.0))};
    for (const float x : {0.5f, std::nextafter(0.5f, 0.0f), std::nextafter(0.5f, 1.0f)})
        for (const float y : {0.5f, -0.5f, 3.0f}) ASSERT_TRUE(both.agree({x, y, 2.0f, 1.0f}));
}

// From a vertex, what side of its faces is seen hangs on how their planes were rounded: boxes must leave room for that.
TEST(PlaneTree, AnEyeOnTheSurfaceIsDecidedAlike) {
    Shape shape = irregular_torus(1.0, 0.4, 60, 30, 0.4, 5);
    for (glm::vec3& p : shape.positions) p += glm::vec3(1000.0f, -300.0f, 50.0f);
    Both both{LineMesh(shape)};
    for (const glm::vec3& p : shape.positions) ASSERT_TRUE(both.agree({p, 1.0f}));
}

TEST(PlaneTree, WhatIsNoNumberIsDecidedAlike) {
    Both both{LineMesh(battered(icosphere(1.0, 2), 3))};
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const glm::vec4& eye : {glm::vec4(nan, 0, 0, 1), glm::vec4(0, infinity, 0, 1), glm::vec4(1, 1, 1, nan)})
        ASSERT_TRUE(both.agree(eye));
}

TEST(PlaneTree, FollowsAMeshThatDeforms) {
    for (const Shape& shape : {irregular_torus(1.0, 0.4, 80, 40, 0.33, 5), battered(icosphere(1.0, 4), 9)}) {
        Both both{LineMesh(shape)};
        std::mt19937 random(5);
        for (int frame = 0; frame < 40; ++frame) {
            for (glm::vec3& p : both.mesh.positions)
                p += 0.05f *
                     glm::vec3(std::sin(3.0f * p.y + static_cast<float>(frame)), std::cos(2.0f * p.x), p.z * p.x);
            face_planes(both.mesh.positions, both.mesh.indices, both.mesh.planes);
            both.tree.refit(both.mesh.planes);
            for (const glm::vec4& eye : random_eyes(20, static_cast<std::uint32_t>(random())))
                ASSERT_TRUE(both.agree(eye));
        }
    }
}

TEST(SelectEdges, IsTheSameOnSeveralThreads) {
    const int threads = thread_limit();
    set_thread_limit(4);
    Both both{LineMesh(battered(irregular_torus(1.0, 0.4, 300, 150, 0.33, 5), 4))};
    std::vector<glm::vec4> planes(both.mesh.planes.size());
    face_planes_in_parallel(both.mesh.positions, both.mesh.indices, planes);
    EXPECT_EQ(planes, both.mesh.planes);
    for (const glm::vec4& eye : random_eyes(20, 6)) {
        ASSERT_TRUE(both.agree(eye));
        const std::vector<ChosenEdge> expected(both.chosen.begin(),
                                               both.chosen.begin() + static_cast<std::ptrdiff_t>(both.loop.count));
        std::ranges::fill(both.chosen, ChosenEdge{});
        select_in_parallel(both.loop);
        ASSERT_TRUE(std::ranges::equal(expected, std::span(both.chosen).first(both.loop.count)));
    }
    set_thread_limit(threads);
}

TEST(PlaneTree, IsTheSameOnAnyNumberOfThreads) {
    const int threads = thread_limit();
    std::vector<std::size_t> looked_at;
    for (const int limit : {1, 4}) {
        set_thread_limit(limit);
        Both both{LineMesh(irregular_torus(1.0, 0.4, 200, 100, 0.33, 5))};
        ASSERT_TRUE(both.agree({2, 1, 1, 1}));
        looked_at.push_back(both.by_tree.scratch.tested_items);
    }
    set_thread_limit(threads);
    EXPECT_EQ(looked_at[0], looked_at[1]);
}

class PlaneTreeOfModels : public test::GivenModelTest {};

TEST_P(PlaneTreeOfModels, ChoosesWhatThePlainLoopChooses) {
    Both both{LineMesh::read(file())};
    const Bounds bounds = bounds_of(both.mesh.positions);
    for (glm::vec4 eye : random_eyes(200, 17)) {
        eye = glm::vec4(bounds.radius() * glm::vec3(eye) + eye.w * bounds.center(), eye.w);
        ASSERT_TRUE(both.agree(eye));
    }
}

INSTANTIATE_TEST_SUITE_P(Given, PlaneTreeOfModels,
                         testing::Values("meshes/stanford-dragon/dragon_vrip_res3.ply.gz",
                                         "broken/manifold/self_intersectA.obj", "broken/manifold/Offset1.obj"),
                         test::given_model_name);

} // namespace
} // namespace hachure::geometry
