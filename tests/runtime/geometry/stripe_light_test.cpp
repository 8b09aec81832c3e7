#include <hachure/tests/runtime/geometry/striped.h>

#include <glm/gtc/quaternion.hpp>

#include <numbers>
#include <random>

namespace hachure::geometry {
namespace {

constexpr double major = 1.0, minor = 0.25;

/// A torus whose normals, not its places, are bumpy: every one is turned by up to `bump` radians.
Shape bumpy_torus(double bump) {
    Shape shape = torus(major, minor, 160, 48);
    std::mt19937 random(11);
    std::uniform_real_distribution<float> noise(static_cast<float>(-bump), static_cast<float>(bump));
    for (glm::vec3& n : shape.normals)
        n = glm::normalize(n + 0.57f * glm::vec3(noise(random), noise(random), noise(random)));
    return shape;
}

/// Frames with the smooth normals of the mesh.
struct Lit {
    std::vector<glm::vec4> frames, normals;

    explicit Lit(Striped& striped) : frames(striped.frames.size()), normals(frames.size()) {
        StripeFramesJob job = striped.job();
        job.lean = striped.mesh.lean;
        job.smooth_normals = normals;
        job.frames = frames;
        job.validate();
        job.run();
    }
};

double root_mean_square(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

// Near where the tube faces a light, the stripe that faces it is the same all over, at the closed form's angle.
TEST(StripeLight, BumpsDoNotMoveTheLightsStripe) {
    Striped striped(bumpy_torus(0.2));
    const Lit lit(striped);
    const glm::dvec3 light(0.0, 1.0, 0.0);
    std::vector<double> drawn, smooth;
    for (std::size_t v = 0; v < striped.positions.size(); ++v) {
        const glm::dvec3 p(striped.positions[v]);
        const double across = std::hypot(p.x, p.z) - major,
                     angle = std::atan2(across, p.y); // 0 where it faces the light
        if (std::abs(angle) > 0.7) continue;
        const auto off = [&](const glm::vec4& frame, const glm::dvec3& n) {
            const double found = std::atan2(glm::dot(light, glm::dvec3(glm::vec3(frame))), glm::dot(light, n));
            return std::abs(found) - std::abs(angle); // X points either way
        };
        drawn.push_back(off(striped.frames[v], glm::dvec3(striped.normals[v])));
        smooth.push_back(off(lit.frames[v], glm::dvec3(glm::vec3(lit.normals[v]))));
        // The turning is the tube's 1 / minor radians per metre, not the bumps'.
        EXPECT_NEAR(std::abs(lit.normals[v].w), 1.0 / minor, 0.2 / minor);
    }
    ASSERT_GT(smooth.size(), 1000u);
    RecordProperty("drawn_radians", std::to_string(root_mean_square(drawn)));
    RecordProperty("smooth_radians", std::to_string(root_mean_square(smooth)));
    EXPECT_LT(root_mean_square(smooth), 0.25 * root_mean_square(drawn));
}

TEST(StripeLight, OnCylindersNothingIsSmoothed) {
    Striped striped(cylinder(0.5, 2.0, 48));
    const Lit lit(striped);
    for (std::size_t v = 0; v < striped.positions.size(); ++v) {
        EXPECT_LT(glm::length(striped.mesh.lean[v] - glm::vec3(0.0f, 0.0f, 1.0f)), 1e-6f);
        EXPECT_EQ(striped.mesh.clarity[v], 1.0f);
        EXPECT_LT(glm::length(lit.frames[v] - striped.frames[v]), 1e-5f);
        if (std::abs(striped.normals[v].y) < 0.5f) {
            EXPECT_NEAR(std::abs(lit.normals[v].w), 2.0, 0.01);
        }
    }
}

TEST(StripeLight, SmoothNormalsTurnWithTheBody) {
    Striped striped(bumpy_torus(0.2));
    const Lit before(striped);
    const glm::quat turn = glm::angleAxis(1.1f, glm::normalize(glm::vec3(1.0f, 2.0f, -0.5f)));
    for (glm::vec3& p : striped.positions) p = turn * p;
    for (glm::vec3& n : striped.normals) n = turn * n;
    const Lit after(striped);
    for (std::size_t v = 0; v < striped.positions.size(); ++v) {
        EXPECT_LT(glm::length(turn * glm::vec3(before.normals[v]) - glm::vec3(after.normals[v])), 1e-4f);
        EXPECT_LT(glm::length(turn * glm::vec3(before.frames[v]) - glm::vec3(after.frames[v])), 1e-3f);
    }
}

TEST(StripeLight, IsUnclearNearSingularitiesOnly) {
    const Striped striped(uv_sphere(1.0, 64, 32));
    std::size_t unclear = 0;
    for (std::size_t v = 0; v < striped.positions.size(); ++v) {
        if (striped.mesh.weight[v] == 0.0f) {
            EXPECT_EQ(striped.mesh.clarity[v], 0.0f);
        }
        if (std::abs(striped.positions[v].y) < 0.5f) {
            EXPECT_GT(striped.mesh.clarity[v], 0.9f);
        }
        if (striped.mesh.clarity[v] < 0.5f) ++unclear;
    }
    EXPECT_GT(unclear, 0u);
}

} // namespace
} // namespace hachure::geometry
