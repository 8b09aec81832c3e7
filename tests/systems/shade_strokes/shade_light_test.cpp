#include <hachure/runtime/parallel.h>
#include <hachure/tests/support/shade_rig.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace hachure::test {
namespace {

constexpr ShadeTone linear{.full_shade = 0.0f, .no_shade = 1.0f};

/// The need of every cell of a rig against a formula of place and normal on the unit sphere, at the cell's middle.
template <class Formula> void expect_needs(const ShadeRig& rig, double tolerance, const Formula& light) {
    double worst = 0.0;
    for (std::uint32_t c = 0; c < rig.mesh().cell_count(); ++c) {
        double sum = 0.0;
        const std::size_t first = rig.mesh().first_sample[c], end = rig.mesh().first_sample[c + 1];
        for (std::size_t i = first; i < end; ++i) {
            const glm::dvec3 place = rig.mesh().at(rig.mesh().samples[i].point);
            sum += 1.0 - std::clamp(light(place, glm::normalize(place)), 0.0, 1.0);
        }
        worst = std::max(worst, std::abs(sum / static_cast<double>(end - first) - rig.needed()[c]));
    }
    EXPECT_LT(worst, tolerance);
}

class ShadeLightTest : public ::testing::Test {
protected:
    ShadeLightTest() { rig_.light.tone = linear; }
    ShadeRig rig_{geometry::icosphere(1.0, 5), 1500};
};

TEST_F(ShadeLightTest, DirectionalIsLambert) {
    const glm::vec3 towards = glm::normalize(glm::vec3(1, 2, 3));
    rig_.step({shade_sun(towards)});
    expect_needs(rig_, 2e-3, [&](const glm::dvec3&, const glm::dvec3& n) { return glm::dot(n, glm::dvec3(towards)); });
}

TEST_F(ShadeLightTest, PointWithRange) {
    const glm::dvec3 place(0, 3, 0);
    rig_.step({{.position = glm::vec4(0, 3, 0, 1), .range = 3.0f}});
    expect_needs(rig_, 4e-3, [&](const glm::dvec3& p, const glm::dvec3& n) {
        const double share = glm::dot(place - p, place - p) / 9.0;
        return std::clamp(1.0 - share * share, 0.0, 1.0) * std::max(0.0, glm::dot(n, glm::normalize(place - p)));
    });
}

TEST_F(ShadeLightTest, SpotWithCone) {
    const glm::dvec3 place(0, 0, 4);
    rig_.step({{.position = glm::vec4(0, 0, 4, 1),
                .direction = {0, 0, -1},
                .spot = true,
                .inner_cone = 0.05f,
                .outer_cone = 0.2f}});
    expect_needs(rig_, 1e-2, [&](const glm::dvec3& p, const glm::dvec3& n) {
        const double cosine = glm::normalize(p - place).z * -1.0;
        const double inside = std::clamp((cosine - std::cos(0.2)) / (std::cos(0.05) - std::cos(0.2)), 0.0, 1.0);
        return inside * inside * std::max(0.0, glm::dot(n, glm::normalize(place - p)));
    });
}

/// Seen along its axis a gaze light is a directional one; beside it, it has turned with the line of sight.
TEST_F(ShadeLightTest, GazeTurnsWithTheSight) {
    ShadingLight light = shade_sun({1, 0, 0});
    light.gaze = true;
    const glm::dvec3 eye(0, 0, 3);
    rig_.light.eye = {.place = {0, 0, 3}, .axis = {0, 0, 1}, .perspective = true};
    rig_.step({light});
    expect_needs(rig_, 3e-3, [&](const glm::dvec3& p, const glm::dvec3& n) {
        // The turn that takes +Z to the sight, by Rodrigues' formula.
        const glm::dvec3 axis(0, 0, 1), sight = glm::normalize(eye - p), turn = glm::cross(axis, sight);
        const double sine = glm::length(turn), cosine = glm::dot(axis, sight);
        const glm::dvec3 k = sine > 0.0 ? turn / sine : glm::dvec3(0, 1, 0), l(1, 0, 0);
        return glm::dot(n, l * cosine + glm::cross(k, l) * sine + k * glm::dot(k, l) * (1.0 - cosine));
    });
    rig_.light.eye.perspective = false;
    rig_.step({light});
    expect_needs(rig_, 2e-3, [](const glm::dvec3&, const glm::dvec3& n) { return n.x; });
}

TEST_F(ShadeLightTest, LightsAddUpAndToneShapes) {
    rig_.light.tone = {.full_shade = 0.1f, .no_shade = 0.6f, .contrast = 2.0f};
    rig_.step({shade_sun({1, 0, 0}, 0.5f), shade_sun({0, 1, 0}, 0.3f)});
    expect_needs(rig_, 1e-2, [](const glm::dvec3&, const glm::dvec3& n) {
        const double light = 0.5 * std::max(0.0, n.x) + 0.3 * std::max(0.0, n.y);
        return 1.0 - std::pow(std::clamp((0.6 - light) / 0.5, 0.0, 1.0), 2.0);
    });
}

/// The place of the mesh in the world counts, with normals turned as surfaces turn.
TEST_F(ShadeLightTest, MeshesStandInTheWorld) {
    const glm::mat4 world = glm::scale(glm::translate(glm::mat4(1.0f), {5, 0, 0}), glm::vec3(1, 1, 0.5f));
    rig_.light.world_from_mesh = world;
    rig_.step({{.position = glm::vec4(5, 4, 0, 1)}});
    expect_needs(rig_, 6e-3, [](const glm::dvec3& p, const glm::dvec3&) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(p.x, p.y, 2.0 * p.z));
        return glm::dot(normal, glm::normalize(glm::dvec3(0, 4, 0) - glm::dvec3(p.x, p.y, 0.5 * p.z)));
    });
}

TEST_F(ShadeLightTest, WithoutLightAllIsDark) {
    rig_.step({});
    for (const float need : rig_.needed()) EXPECT_EQ(need, 1.0f);
}

TEST_F(ShadeLightTest, LightInsideLightsNothing) {
    rig_.step({{.position = glm::vec4(0.1f, 0, 0, 1)}});
    for (const float need : rig_.needed()) EXPECT_EQ(need, 1.0f);
}

TEST_F(ShadeLightTest, LightsThatAreNoNumbersAreLeftOut) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const ShadingLight sun = shade_sun({0, 1, 0});
    rig_.step({sun});
    const std::vector<float> alone = rig_.needed();
    ShadingLight place = sun, color = sun, cone = sun;
    place.position.x = nan;
    color.color.g = std::numeric_limits<float>::infinity();
    cone.spot = true;
    cone.outer_cone = nan;
    rig_.step({place, sun, color, cone});
    EXPECT_EQ(rig_.light.ignored_lights, 3u);
    EXPECT_EQ(rig_.needed(), alone);
    EXPECT_FALSE(rig_.light.swept) << "nothing that counts has changed";
}

TEST_F(ShadeLightTest, SweepsOnlyWhenSomethingMoved) {
    const std::vector<ShadingLight> sun{shade_sun({0, 1, 0})};
    const auto sweeps = [&] {
        rig_.step(sun);
        return rig_.light.swept;
    };
    EXPECT_TRUE(sweeps());
    EXPECT_FALSE(sweeps());
    rig_.light.eye.place = {1, 2, 3};
    EXPECT_FALSE(sweeps()) << "no light turns with the gaze";
    rig_.light.version = 1;
    EXPECT_TRUE(sweeps());
    rig_.light.world_from_mesh[3][0] = 1.0f;
    EXPECT_TRUE(sweeps());
    EXPECT_FALSE(sweeps());
}

TEST_F(ShadeLightTest, ThreadsChangeNothing) {
    set_thread_limit(1);
    rig_.step_sun(30.0);
    const std::vector<float> one = rig_.needed();
    set_thread_limit(2);
    rig_.light.version = 1;
    rig_.step_sun(30.0);
    EXPECT_TRUE(rig_.light.swept);
    EXPECT_EQ(rig_.needed(), one);
}

} // namespace
} // namespace hachure::test
