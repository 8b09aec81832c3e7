#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/fill_directions.h>
#include <hachure/runtime/parallel.h>
#include <hachure/tests/support/curved_case.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace hachure::geometry {
namespace {

/// Directions of a mesh as the automatic method gives them, and filled.
struct Filled {
    std::vector<glm::vec3> positions, normals, raw, filled;
    std::vector<std::uint32_t> indices, weld;
    std::vector<float> confidences;
    VertexNeighbours neighbours;

    Filled(std::vector<glm::vec3> p, std::vector<std::uint32_t> i)
        : positions(std::move(p)), normals(positions.size()), raw(positions.size()), filled(positions.size()),
          indices(std::move(i)), weld(weld_positions(positions)), confidences(positions.size()) {
        SmoothNormalsJob smooth{.positions = positions, .indices = indices, .weld = weld, .normals = normals};
        smooth.run();
        neighbours.build(indices, weld);
        std::vector<glm::vec2> curvatures(positions.size());
        CurvatureJob curvature{.positions = positions,
                               .normals = normals,
                               .indices = indices,
                               .weld = weld,
                               .curvatures = curvatures,
                               .directions = raw,
                               .confidences = confidences,
                               .method = CurvatureMethod::automatic,
                               .neighbours = &neighbours};
        curvature.run();
        run();
    }

    FillDirectionsJob job() {
        return {.normals = normals,
                .weld = weld,
                .neighbours = &neighbours,
                .directions = raw,
                .confidences = confidences,
                .filled = filled};
    }
    void run() {
        FillDirectionsJob fill = job();
        fill.validate();
        fill.run();
        for (std::size_t v = 0; v < filled.size(); ++v) {
            ASSERT_NEAR(glm::length(filled[v]), 1.0f, 1e-5f) << v;
            ASSERT_NEAR(glm::dot(filled[v], normals[weld[v]]), 0.0f, 1e-5f) << v;
        }
    }
};

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::acos(std::min(1.0, std::abs(glm::dot(a, b)))) * 180.0 / std::numbers::pi;
}

/// Each coordinate of each vertex to the next float, up or down.
std::vector<glm::vec3> by_one_bit(std::vector<glm::vec3> positions) {
    std::mt19937 random(8);
    for (glm::vec3& p : positions)
        for (int i = 0; i < 3; ++i) p[i] = std::nextafter(p[i], random() % 2 == 0 ? 2.0f : -2.0f);
    return positions;
}

TEST(FillDirections, TheLeastChangeAtUmbilicsTurnsNothing) {
    // A sphere is all umbilics, an ellipsoid has four, and a monkey saddle a flat one.
    const Shape ball = icosphere(1.0, 4);
    const test::CurvedCase ellipsoid(test::CurvedKind::ellipsoid, {.irregular = false, .cells = 32});
    const test::CurvedCase saddle(test::CurvedKind::monkey_saddle, {.cells = 32});
    const std::vector<std::pair<std::vector<glm::vec3>, std::vector<std::uint32_t>>> meshes{
        {ball.positions, ball.indices}, {ellipsoid.positions, ellipsoid.indices}, {saddle.positions, saddle.indices}};
    for (const auto& [positions, indices] : meshes) {
        const Filled before(positions, indices), after(by_one_bit(positions), indices);
        double most = 0.0, most_raw = 0.0;
        for (std::size_t v = 0; v < positions.size(); ++v) {
            most = std::max(most, degrees_between(before.filled[v], after.filled[v]));
            most_raw = std::max(most_raw, degrees_between(before.raw[v], after.raw[v]));
        }
        EXPECT_LT(most, 3.0);
        if (&positions == &meshes[0].first) {
            EXPECT_GT(most_raw, 45.0); // without the filling they do turn about
        }
    }
}

TEST(FillDirections, SureDirectionsStay) {
    const test::CurvedCase tube(test::CurvedKind::cylinder, {.cells = 32});
    const Filled mesh(tube.positions, tube.indices);
    for (std::size_t v = 0; v < mesh.filled.size(); ++v)
        EXPECT_LT(degrees_between(mesh.filled[v], mesh.raw[v]), 0.5) << v;
}

TEST(FillDirections, OpenPartsFollowThoseAround) {
    // A plane with a known direction on its rim only.
    const Shape flat = plane(1.0, 40);
    Filled mesh(flat.positions, flat.indices);
    const glm::vec3 slanted = glm::normalize(glm::vec3(1.0f, 0.0f, 2.0f));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const float out = std::max(std::abs(mesh.positions[v].x), std::abs(mesh.positions[v].z));
        mesh.confidences[v] = out > 0.45f ? 1.0f : 0.0f;
        mesh.raw[v] = out > 0.45f ? slanted : glm::vec3(0.0f, 0.0f, 1.0f);
    }
    mesh.run();
    for (const glm::vec3& direction : mesh.filled) EXPECT_LT(degrees_between(direction, slanted), 6.0);
}

TEST(FillDirections, FieldOfABallIsSmooth) {
    const Shape ball = icosphere(1.0, 4);
    const Filled mesh(ball.positions, ball.indices);
    std::size_t rough = 0, edges = 0;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
        for (const std::uint32_t other : mesh.neighbours.of(v)) {
            ++edges;
            if (degrees_between(mesh.filled[v], mesh.filled[other]) > 25.0) ++rough;
        }
    EXPECT_LT(rough, edges / 50); // some must be: a ball's field of lines has singularities
}

TEST(FillDirections, ThreadsChangeNoBitAndOutputMayBeInput) {
    const Shape ball = icosphere(1.0, 4);
    const int before = thread_limit();
    set_thread_limit(1);
    Filled one(ball.positions, ball.indices);
    set_thread_limit(4);
    Filled four(ball.positions, ball.indices);
    set_thread_limit(before);
    EXPECT_EQ(one.filled, four.filled);
    FillDirectionsJob in_place = four.job();
    in_place.filled = four.raw;
    in_place.run();
    EXPECT_EQ(one.filled, four.raw);
}

TEST(FillDirections, BrokenMeshesAreDefined) {
    const Filled nothing({}, {}), point({{1, 2, 3}}, {}), one({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
    const Filled broken({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {9, 9, 9}, {1, 1e-9f, 0}, {0, -1, 1}, {0, -1, -1}},
                        {0, 1, 2, 0, 1, 5, 0, 0, 3, 0, 1, 3, 0, 1, 6, 0, 1, 7, 0, 3, 1});
}

} // namespace
} // namespace hachure::geometry
