#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/parallel.h>
#include <hachure/tests/support/curved_case.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace hachure::geometry {
namespace {

using test::CurvedCase;
using test::CurvedKind;

constexpr CurvatureMethod fitting_methods[] = {CurvatureMethod::quadric, CurvatureMethod::quartic,
                                               CurvatureMethod::automatic};

/// A job on some mesh, with its results.
struct Bent {
    std::vector<glm::vec2> curvatures;
    std::vector<glm::vec3> directions;
    std::vector<float> confidences;
    CurvatureJob job;

    Bent(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
         std::span<const std::uint32_t> indices, std::span<const std::uint32_t> weld, CurvatureMethod method)
        : curvatures(positions.size()), directions(positions.size()),
          confidences(positions.size()), job{.positions = positions,
                                             .normals = normals,
                                             .indices = indices,
                                             .weld = weld,
                                             .curvatures = curvatures,
                                             .directions = directions,
                                             .confidences = confidences,
                                             .method = method} {}
    Bent(const CurvedCase& mesh, CurvatureMethod method)
        : Bent(mesh.positions, mesh.normals, mesh.indices, mesh.weld, method) {}
    Bent(const Bent&) = delete;
    Bent& operator=(const Bent&) = delete;

    Bent& run() {
        job.validate();
        job.run();
        return *this;
    }

    void expect_defined() const {
        for (std::size_t v = 0; v < curvatures.size(); ++v) {
            ASSERT_TRUE(std::isfinite(curvatures[v].x) && std::isfinite(curvatures[v].y)) << v;
            ASSERT_GE(std::abs(curvatures[v].x), std::abs(curvatures[v].y)) << v;
            ASSERT_NEAR(glm::length(directions[v]), 1.0f, 1e-5f) << v;
            ASSERT_NEAR(glm::dot(directions[v], job.normals[job.weld[v]]), 0.0f, 1e-5f) << v;
            ASSERT_TRUE(confidences[v] >= 0.0f && confidences[v] <= 1.0f) << v;
        }
    }
};

CurvedCase::Errors errors_of(const CurvedCase& mesh, CurvatureMethod method, std::uint32_t rings = 0) {
    Bent bent(mesh, method);
    bent.job.rings = rings;
    bent.run().expect_defined();
    return mesh.errors(bent.curvatures, bent.directions);
}

/// What is published for an irregular torus of 10k vertices (RMS %, degrees), with room for another noise.
struct Row {
    CurvatureMethod method;
    std::uint32_t rings;
    double rms[3], degrees[3]; ///< clean, with 1 % and 5 % of noise
};

TEST(CurvatureMethods, AreAsAccurateAsPublishedOnAnIrregularTorus) {
    constexpr Row rows[] = {{CurvatureMethod::one_ring, 0, {4.0, 11.0, 55.0}, {2.6, 7.5, 43.0}},
                            {CurvatureMethod::quadric, 2, {1.5, 4.9, 23.0}, {1.2, 2.8, 14.0}},
                            {CurvatureMethod::quadric, 5, {5.0, 5.0, 5.3}, {1.3, 1.4, 1.7}},
                            {CurvatureMethod::quartic, 3, {0.07, 6.6, 32.0}, {0.05, 3.2, 19.0}}};
    constexpr double room = 1.1, noises[] = {0.0, 0.01, 0.05};
    for (std::size_t i = 0; i < 3; ++i) {
        const CurvedCase mesh(CurvedKind::torus, {.noise = noises[i]});
        double best_rms = std::numeric_limits<double>::max(), best_degrees = best_rms;
        for (const Row& row : rows) {
            const CurvedCase::Errors errors = errors_of(mesh, row.method, row.rings);
            EXPECT_LT(100.0 * errors.rms, room * row.rms[i]) << static_cast<int>(row.method) << ' ' << noises[i];
            EXPECT_LT(errors.degrees95, room * row.degrees[i]) << static_cast<int>(row.method) << ' ' << noises[i];
            best_rms = std::min(best_rms, row.rms[i]);
            best_degrees = std::min(best_degrees, row.degrees[i]);
        }
        // The automatic choice: the best row at every noise, without being told of it.
        const CurvedCase::Errors chosen = errors_of(mesh, CurvatureMethod::automatic);
        RecordProperty("automatic_rms_percent_" + std::to_string(i), std::to_string(100.0 * chosen.rms));
        RecordProperty("automatic_degrees95_" + std::to_string(i), std::to_string(chosen.degrees95));
        EXPECT_LE(100.0 * chosen.rms, best_rms);
        EXPECT_LE(chosen.degrees95, best_degrees);
    }
}

TEST(CurvatureMethods, AutomaticFollowsTheClosedFormsOfAllSurfaces) {
    constexpr double noises[] = {0.0, 0.01, 0.05}, most_rms[] = {0.004, 0.03, 0.09}, most_degrees[] = {0.3, 2.0, 6.0};
    for (const CurvedKind kind : {CurvedKind::sphere, CurvedKind::torus, CurvedKind::ellipsoid, CurvedKind::cylinder,
                                  CurvedKind::monkey_saddle})
        for (const bool irregular : {false, true})
            for (std::size_t i = 0; i < (irregular ? 3u : 2u); ++i) {
                const CurvedCase mesh(kind, {.irregular = irregular, .noise = noises[i], .cells = 40});
                const CurvedCase::Errors errors = errors_of(mesh, CurvatureMethod::automatic);
                EXPECT_LT(errors.rms, most_rms[i]) << static_cast<int>(kind) << irregular << noises[i];
                EXPECT_LT(errors.degrees95, most_degrees[i]) << static_cast<int>(kind) << irregular << noises[i];
            }
}

TEST(CurvatureMethods, AutomaticIsNearTheBestSingleFit) {
    for (const double noise : {0.0, 0.003, 0.02}) {
        const CurvedCase mesh(CurvedKind::torus, {.noise = noise, .cells = 40});
        double best = 1.0;
        for (const std::uint32_t rings : CurvatureFits::level_rings)
            best = std::min(best, errors_of(mesh, CurvatureMethod::quartic, rings).rms);
        Bent bent(mesh, CurvatureMethod::automatic);
        bent.job.tolerance = 0.0;
        bent.run();
        EXPECT_LT(mesh.errors(bent.curvatures, bent.directions).rms, 1.2 * best + 1e-4) << noise;
    }
}

TEST(CurvatureMethods, QuarticConvergesWithTheFourthPower) {
    const auto rms = [](std::uint32_t cells) {
        return errors_of(CurvedCase(CurvedKind::torus, {.cells = cells}), CurvatureMethod::quartic).rms;
    };
    EXPECT_LT(rms(64), rms(32) / 10.0);
}

TEST(CurvatureMethods, CylindersBendOneWayOnly) {
    for (const bool irregular : {false, true}) {
        const CurvedCase mesh(CurvedKind::cylinder, {.irregular = irregular});
        for (const CurvatureMethod method : fitting_methods) {
            Bent bent(mesh, method);
            bent.run();
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                ASSERT_NEAR(bent.curvatures[v].y, 0.0f, mesh.border[v] ? 2e-2f : 4e-3f) << v; // of k1 = 2
                ASSERT_NEAR(bent.curvatures[v].x, 2.0f, 0.05f) << v;
                ASSERT_NEAR(bent.directions[v].y, 0.0f, 0.02f) << v;
                ASSERT_GT(bent.confidences[v], 0.9f) << v;
            }
        }
    }
}

TEST(CurvatureMethods, AnyUnitOfLengthGivesTheSame) {
    const CurvedCase mesh(CurvedKind::torus, {.noise = 0.02, .cells = 24});
    for (const CurvatureMethod method : fitting_methods) {
        Bent metres(mesh, method);
        metres.run();
        for (const float scale : {1024.0f, 1.0f / 1048576.0f}) { // exact in floats
            std::vector<glm::vec3> positions = mesh.positions;
            for (glm::vec3& p : positions) p *= scale;
            Bent scaled(positions, mesh.normals, mesh.indices, mesh.weld, method);
            scaled.run();
            for (std::size_t v = 0; v < positions.size(); ++v)
                ASSERT_NEAR(scaled.curvatures[v].x * scale, metres.curvatures[v].x, 1e-4) << v;
        }
    }
}

TEST(CurvatureMethods, ARadiusTakesTheVerticesWithin) {
    const CurvedCase mesh(CurvedKind::torus, {.noise = 0.01});
    Bent near(mesh, CurvatureMethod::quartic), far(mesh, CurvatureMethod::quartic);
    near.job.radius = 4.0 * mesh.edge;
    far.job.radius = 6.0 * mesh.edge;
    near.run().expect_defined();
    far.run().expect_defined();
    const double near_rms = mesh.errors(near.curvatures, near.directions).rms;
    EXPECT_LT(mesh.errors(far.curvatures, far.directions).rms, 0.6 * near_rms);
    Bent tiny(mesh, CurvatureMethod::quadric);
    tiny.job.radius = 1e-6; // nothing but the vertex
    tiny.run().expect_defined();
    for (const glm::vec2& k : tiny.curvatures) ASSERT_EQ(k, glm::vec2(0.0f));
}

TEST(CurvatureMethods, SeamsAreNoBorders) {
    const CurvedCase mesh(CurvedKind::torus, {.irregular = false, .noise = 0.01, .cells = 24});
    for (const CurvatureMethod method : fitting_methods) {
        Bent bent(mesh, method);
        bent.run();
        for (std::size_t v = 0; v < mesh.weld.size(); ++v) {
            ASSERT_EQ(bent.curvatures[v], bent.curvatures[mesh.weld[v]]);
            ASSERT_EQ(bent.directions[v], bent.directions[mesh.weld[v]]);
        }
    }
}

TEST(CurvatureMethods, ThreadsChangeNoBit) {
    const CurvedCase mesh(CurvedKind::monkey_saddle, {.noise = 0.02});
    const int before = thread_limit();
    for (const CurvatureMethod method : fitting_methods) {
        set_thread_limit(1);
        Bent one(mesh, method);
        one.run();
        set_thread_limit(4);
        Bent four(mesh, method);
        four.run();
        EXPECT_EQ(one.curvatures, four.curvatures);
        EXPECT_EQ(one.directions, four.directions);
        EXPECT_EQ(one.confidences, four.confidences);
    }
    set_thread_limit(before);
}

TEST(CurvatureMethods, AJobThatRanBeforeGivesTheSameAsANewOne) {
    CurvedCase mesh(CurvedKind::torus, {.noise = 0.05, .cells = 24});
    VertexNeighbours neighbours;
    neighbours.build(mesh.indices, mesh.weld);
    for (const CurvatureMethod method : fitting_methods) {
        Bent used(mesh, method);
        used.job.neighbours = &neighbours;
        used.run();
        // It deforms: the topology stays, and noise falls to nothing.
        const CurvedCase other(CurvedKind::torus, {.cells = 24});
        used.job.positions = other.positions;
        used.job.normals = other.normals;
        used.run();
        Bent fresh(other, method);
        fresh.run();
        EXPECT_EQ(used.curvatures, fresh.curvatures);
        EXPECT_EQ(used.directions, fresh.directions);
        EXPECT_EQ(used.confidences, fresh.confidences);
    }
}

// The choice of rings must not show while a mesh deforms: half the step, half the change.
TEST(CurvatureMethods, AutomaticChangesNoFasterThanTheMesh) {
    const CurvedCase clean(CurvedKind::torus, {.cells = 32}), noisy(CurvedKind::torus, {.noise = 0.02, .cells = 32});
    const auto at = [&](float t) {
        std::vector<glm::vec3> positions = clean.positions;
        for (std::size_t v = 0; v < positions.size(); ++v)
            positions[v] += t * (noisy.positions[v] - clean.positions[v]);
        Bent bent(positions, noisy.normals, clean.indices, clean.weld, CurvatureMethod::automatic);
        bent.run();
        return bent.curvatures;
    };
    const auto change = [&](float step) {
        const std::vector<glm::vec2> a = at(0.6f), b = at(0.6f + step);
        float sum = 0.0f;
        for (std::size_t v = 0; v < a.size(); ++v) sum += glm::distance(a[v], b[v]);
        return sum / static_cast<float>(a.size());
    };
    const float whole = change(0.04f), half = change(0.02f), quarter = change(0.01f);
    EXPECT_LT(half, 0.65f * whole);
    EXPECT_LT(quarter, 0.65f * half);
}

TEST(CurvatureMethods, ConfidenceTellsDirectionsFromNoise) {
    const CurvedCase ball(CurvedKind::sphere, {.noise = 0.02, .cells = 32}),
        tube(CurvedKind::cylinder, {.noise = 0.02, .cells = 32});
    Bent of_ball(ball, CurvatureMethod::automatic), of_tube(tube, CurvatureMethod::automatic);
    of_ball.run();
    of_tube.run();
    EXPECT_LT(std::ranges::count_if(of_ball.confidences, [](float c) { return c > 0.1f; }), 20);
    EXPECT_GT(std::ranges::count_if(of_tube.confidences, [](float c) { return c > 0.9f; }),
              static_cast<long>(0.9 * static_cast<double>(tube.positions.size())));
}

/// A mesh of its own normals.
void expect_defined(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices) {
    const std::vector<std::uint32_t> weld = weld_positions(positions);
    std::vector<glm::vec3> normals(positions.size());
    SmoothNormalsJob smooth{.positions = positions, .indices = indices, .weld = weld, .normals = normals};
    smooth.run();
    for (const CurvatureMethod method : fitting_methods) {
        Bent bent(positions, normals, indices, weld, method);
        bent.run().expect_defined();
        bent.job.radius = 0.3;
        bent.run().expect_defined();
    }
}

TEST(CurvatureMethods, BrokenMeshesAreDefined) {
    expect_defined({}, {});
    expect_defined({{1, 2, 3}}, {});
    expect_defined({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
    // No area, a needle, a vertex that nothing uses, three triangles on an edge, a triangle and its back, one twice.
    expect_defined({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {9, 9, 9}, {1, 1e-9f, 0}, {0, -1, 1}, {0, -1, -1}},
                   {0, 1, 2, 0, 1, 5, 0, 0, 3, 0, 1, 3, 0, 1, 6, 0, 1, 7, 0, 3, 1, 0, 1, 3});
    const Shape box = cube(1.0), tip = cone(1.0, 1.0, 4000), can = cylinder(0.5, 1.0, 3);
    expect_defined(box.positions, box.indices);
    expect_defined(tip.positions, tip.indices); // 4000 triangles at a vertex
    expect_defined(can.positions, can.indices);
    // A sheet folded onto itself, and vertices all at one place but for the last bits.
    Shape fold = plane(1.0, 12), speck = icosphere(1e-30, 2);
    for (glm::vec3& p : fold.positions) p = {std::abs(p.x), 1e-3f * p.x, p.z};
    expect_defined(fold.positions, fold.indices);
    expect_defined(speck.positions, speck.indices);
    for (glm::vec3& p : speck.positions) p *= 1e30f, p += glm::vec3(1e6f);
    expect_defined(speck.positions, speck.indices);
}

TEST(CurvatureMethods, CoarseBallsAreRound) {
    for (const std::uint32_t level : {0u, 1u, 2u}) {
        const Shape ball = icosphere(2.0, level);
        const std::vector<std::uint32_t> weld = weld_positions(ball.positions);
        for (const CurvatureMethod method : fitting_methods) {
            Bent bent(ball.positions, ball.normals, ball.indices, weld, method);
            bent.run();
            for (const glm::vec2& k : bent.curvatures) {
                EXPECT_NEAR(k.x, 0.5f, level == 0 ? 0.25f : 0.1f);
                EXPECT_NEAR(k.y, 0.5f, level == 0 ? 0.25f : 0.1f);
            }
        }
    }
}

TEST(CurvatureMethods, PlanesHaveNone) {
    Shape flat = plane(2.0, 8);
    const std::vector<std::uint32_t> weld = weld_positions(flat.positions);
    for (const CurvatureMethod method : fitting_methods) {
        Bent bent(flat.positions, flat.normals, flat.indices, weld, method);
        bent.run().expect_defined();
        for (const glm::vec2& k : bent.curvatures) EXPECT_EQ(k, glm::vec2(0.0f));
        for (const float c : bent.confidences) EXPECT_EQ(c, 0.0f);
    }
}

} // namespace
} // namespace hachure::geometry
