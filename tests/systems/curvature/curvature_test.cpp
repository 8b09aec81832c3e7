#include <hachure/components/curvature.h>
#include <hachure/components/deformed.h>
#include <hachure/components/rig.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/systems/curvature/curvature.h>
#include <hachure/systems/deform/deform.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/transform/transform.h>
#include <hachure/tests/support/arm_model.h>
#include <hachure/tests/support/bent_cylinder.h>
#include <hachure/tests/support/curved_case.h>
#include <hachure/tests/support/drawn_scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

namespace hachure::test {
namespace {

using geometry::CurvatureMethod;

/// Of lines.
double degrees(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), std::abs(glm::dot(a, b))) * 180.0 / std::numbers::pi;
}

struct CurvatureTest : ::testing::Test {
    CurvatureTest() {
        register_transform(app);
        register_deform(app);
        register_curvature(app);
    }
    World& world() { return app.world(); }
    const CurvatureCounts& counts() { return world().resource<CurvatureCounts>(); }

    Entity add(const geometry::Shape& shape) {
        const std::uint32_t mesh = world().resource_mutable<MeshStore>().add(surface_mesh(shape));
        return world().create_with(Transform{}, Surface{mesh});
    }
    const PrincipalCurvatures& compute(Entity entity, const Curvature& wanted) {
        world().add(entity, wanted);
        app.run_frame();
        return world().get<PrincipalCurvatures>(entity);
    }

    App app;
};

TEST_F(CurvatureTest, OfASphereIsOneOverItsRadius) {
    const Entity ball = add(geometry::icosphere(0.5, 4));
    app.run_frame();
    EXPECT_FALSE(world().has<PrincipalCurvatures>(ball)) << "nobody asked";
    world().add(ball, Curvature{});
    app.run_frame();
    EXPECT_EQ(counts().recomputed, 1u);
    for (const glm::vec2& curvature : world().get<PrincipalCurvatures>(ball).curvatures) {
        EXPECT_NEAR(curvature.x, 2.0, 0.05);
        EXPECT_NEAR(curvature.y, 2.0, 0.05);
    }
    app.run_frame();
    EXPECT_EQ(counts().recomputed, 0u) << "nothing moved";
    world().remove<Curvature>(ball);
    app.run_frame();
    EXPECT_FALSE(world().has<PrincipalCurvatures>(ball)) << "nobody asks any more";
}

TEST_F(CurvatureTest, FollowsTheShape) {
    const SpawnedModel arm = spawn_model(world(), arm_model());
    const Entity surface = arm.surfaces[0];
    for (const CurvatureSource source : {CurvatureSource::recomputed, CurvatureSource::carried}) {
        world().add(surface, Curvature{source});
        app.run_frame();
        const std::vector<glm::vec3> rest = world().get<PrincipalCurvatures>(surface).directions;
        const Entity shoulder = world().get<Rig>(arm.root).nodes[1];
        world().get_mutable<Transform>(shoulder).rotation *= glm::angleAxis(1.0f, glm::vec3(0, 0, 1));
        app.run_frame();
        const PrincipalCurvatures& turned = world().get<PrincipalCurvatures>(surface);
        EXPECT_EQ(turned.version, world().get<Deformed>(surface).version);
        EXPECT_EQ(counts().carried, source == CurvatureSource::carried ? 1u : 0u);
        EXPECT_EQ(counts().recomputed, source == CurvatureSource::carried ? 0u : 1u);
        // The whole arm turned stiffly: so did the directions, up to their sign.
        const glm::quat turn = glm::angleAxis(1.0f, glm::vec3(0, 0, 1));
        for (std::size_t i = 0; i < rest.size(); ++i)
            EXPECT_NEAR(std::abs(glm::dot(turn * rest[i], turned.directions[i])), 1.0, 1e-3) << i;
    }
}

TEST_F(CurvatureTest, IsAsExactAsItsMethod) {
    const CurvedCase torus(CurvedKind::torus, {.cells = 32});
    const Entity entity = add({torus.positions, torus.normals, {}, torus.indices});
    const auto error = [&](CurvatureMethod method) {
        const PrincipalCurvatures& result = compute(entity, {.method = method});
        EXPECT_EQ(counts().recomputed, 1u) << "another method";
        EXPECT_TRUE(result.confidences.empty()) << "nobody asked";
        return torus.errors(result.curvatures, result.directions).rms;
    };
    const double one_ring = error(CurvatureMethod::one_ring), quadric = error(CurvatureMethod::quadric),
                 quartic = error(CurvatureMethod::quartic), automatic = error(CurvatureMethod::automatic);
    EXPECT_LT(one_ring, 0.06);
    EXPECT_GT(one_ring, 0.02);
    EXPECT_LT(quadric, 0.07);
    EXPECT_LT(quartic, 0.02);
    EXPECT_LT(automatic, 0.02);
}

TEST_F(CurvatureTest, FollowsABendByEveryMethod) {
    const CylinderMesh tube(72);
    const BentCylinder bent{.angle = std::numbers::pi / 3.0};
    const Entity entity = add({tube.positions, tube.normals, {}, tube.indices});
    Deformed shape{.version = 7};
    for (std::size_t v = 0; v < tube.positions.size(); ++v)
        shape.positions.emplace_back(bent.point(tube.longitude(v), tube.height(v)));
    const auto error = [&](CurvatureMethod method) {
        const PrincipalCurvatures& result = compute(entity, {.method = method, .fill = true});
        EXPECT_EQ(result.version, shape.version);
        double square = 0.0, count = 0.0;
        for (std::size_t v = 0; v < tube.positions.size(); ++v) {
            // The bend's own curvature jumps at the ends of the joint zone, where no polynomial follows it.
            if (std::abs(tube.height(v)) > 0.7 * BentCylinder::zone) continue;
            const BentCylinder::Exact exact = bent.exact(tube.longitude(v), tube.height(v));
            const auto [greater, less] = std::minmax(exact.k1, exact.k2, std::greater());
            const glm::dvec2 k(result.curvatures[v]);
            square += std::pow(std::max(k.x, k.y) - greater, 2) + std::pow(std::min(k.x, k.y) - less, 2);
            count += 2.0;
            // Sure directions are those of the surface, whatever is filled in beside them.
            if (result.confidences[v] > 0.95f) {
                EXPECT_LT(degrees(result.directions[v], exact.direction[0]), 6.0) << v;
            }
        }
        return std::sqrt(square / count);
    };
    compute(entity, {.fill = true}); // of the rest pose, so that what follows is a change of the shape
    world().add(entity, shape);
    EXPECT_LT(error(CurvatureMethod::one_ring), 0.06);
    EXPECT_LT(error(CurvatureMethod::quartic), 0.02);
    EXPECT_LT(error(CurvatureMethod::automatic), 0.02);
}

TEST_F(CurvatureTest, FillsDirectionsWhereThereAreNone) {
    // A ball is all umbilics: raw directions are those of noise, from vertex to vertex.
    const geometry::Shape ball = geometry::icosphere(0.5, 4);
    const Entity entity = add(ball);
    for (const CurvatureMethod method : {CurvatureMethod::one_ring, CurvatureMethod::automatic}) {
        const auto rough_edges = [&](bool fill) {
            const PrincipalCurvatures& result = compute(entity, {.method = method, .fill = fill});
            EXPECT_EQ(result.confidences.size(), fill ? ball.positions.size() : 0u);
            std::size_t rough = 0;
            for (std::size_t i = 0; i < ball.indices.size(); ++i) {
                const std::uint32_t a = ball.indices[i], b = ball.indices[i % 3 == 2 ? i - 2 : i + 1];
                if (degrees(result.directions[a], result.directions[b]) > 25.0) ++rough;
                EXPECT_NEAR(glm::dot(result.directions[a], glm::normalize(ball.positions[a])), 0.0f, 0.02f);
            }
            return double(rough) / double(ball.indices.size());
        };
        EXPECT_GT(rough_edges(false), 0.05);
        EXPECT_LT(rough_edges(true), 0.02) << "some must be: a field of lines on a ball has singularities";
        const std::vector<float>& confidences = world().get<PrincipalCurvatures>(entity).confidences;
        EXPECT_LT(*std::ranges::max_element(confidences), 0.5f);
    }
}

TEST_F(CurvatureTest, CarriesWhatIsWantedOfTheRestPose) {
    const SpawnedModel arm = spawn_model(world(), arm_model());
    const Entity surface = arm.surfaces[0];
    app.run_frame();
    for (const CurvatureMethod method : {CurvatureMethod::one_ring, CurvatureMethod::quartic})
        for (const bool fill : {false, true}) {
            const PrincipalCurvatures fresh =
                compute(surface, {.source = CurvatureSource::recomputed, .method = method, .fill = fill});
            const PrincipalCurvatures& carried =
                compute(surface, {.source = CurvatureSource::carried, .method = method, .fill = fill});
            EXPECT_EQ(counts().carried, 1u);
            ASSERT_EQ(carried.confidences, fresh.confidences);
            for (std::size_t v = 0; v < fresh.curvatures.size(); ++v) {
                EXPECT_NEAR(carried.curvatures[v].x, fresh.curvatures[v].x, 1e-4) << v;
                EXPECT_LT(degrees(carried.directions[v], fresh.directions[v]), 0.1) << v;
            }
        }
}

} // namespace
} // namespace hachure::test
