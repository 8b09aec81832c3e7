#include <hachure/runtime/geometry/weld.h>
#include <hachure/tests/runtime/geometry/striped.h>

#include <numbers>

namespace hachure::geometry {
namespace {

using std::numbers::pi;

/// Frames of a coordinate that is given; vertices at one place have one.
std::vector<glm::vec4> frames_of(const Shape& shape, const std::vector<float>& u) {
    std::vector<glm::vec4> frames(shape.positions.size());
    const std::vector<std::uint32_t> weld = weld_normals(shape.positions, shape.normals);
    const std::vector<std::uint8_t> mirrored(frames.size(), 0);
    StripeFramesJob job{.positions = shape.positions,
                        .normals = shape.normals,
                        .indices = shape.indices,
                        .coordinate = u,
                        .stands_for = weld,
                        .mirrored = mirrored,
                        .frames = frames};
    job.validate();
    job.run();
    return frames;
}

std::vector<float> column(const Shape& shape, int axis, float scale) {
    std::vector<float> u;
    for (const glm::vec2& t : shape.texcoords) u.push_back(scale * t[axis]);
    return u;
}

TEST(StripeFrames, OfATorusAreTheClosedForm) {
    constexpr double major = 1.0, minor = 0.4, sets = 3.0;
    const Shape shape = torus(major, minor, 160, 64);
    for (const int axis : {0, 1}) {
        const std::vector<glm::vec4> frames = frames_of(shape, column(shape, axis, sets));
        double most = 0.0, most_degrees = 0.0;
        std::size_t around_tube = 0;
        for (std::size_t v = 0; v < frames.size(); ++v) {
            const glm::dvec3 p(shape.positions[v]), around = glm::normalize(glm::dvec3(p.x, 0.0, p.z));
            const glm::dvec3 n = (p - major * around) / minor, parallel = glm::cross(glm::dvec3(0.0, 1.0, 0.0), around);
            const glm::dvec3 x(glm::vec3(frames[v].x, frames[v].y, frames[v].z));
            EXPECT_NEAR(glm::length(x), 1.0, 1e-6);
            const double from_parallel = line_degrees(x, parallel);
            const bool tube = from_parallel > 45.0;
            around_tube += tube ? 1 : 0;
            most_degrees = std::max(most_degrees, tube ? 90.0 - from_parallel : from_parallel);
            // A full turn of the normal around the tube; around the axis only its part outwards turns.
            const double turn = 2.0 * pi / sets * (tube ? 1.0 : glm::dot(n, around));
            most = std::max(most, std::abs(frames[v].w - turn));
        }
        EXPECT_TRUE(around_tube == 0 || around_tube == frames.size());
        EXPECT_LT(most_degrees, 0.05);
        EXPECT_LT(most, 0.01);
    }
}

TEST(StripeFrames, FindTheLightOnACylinder) {
    const Shape bent = cylinder(1.0, 2.0, 64);
    std::vector<float> u = column(bent, 0, 2.0f);
    const std::vector<glm::vec4> frames = frames_of(bent, u);
    const glm::dvec3 light = glm::normalize(glm::dvec3(1.0, 0.3, 0.4));
    std::vector<double> at;
    for (std::size_t v = 0; v < frames.size(); ++v) {
        const glm::dvec3 n(bent.normals[v]), x(frames[v].x, frames[v].y, frames[v].z);
        if (std::abs(n.y) > 0.5) continue;
        at.push_back(u[v] + std::atan2(glm::dot(light, x), glm::dot(light, n)) / double{frames[v].w});
    }
    for (const double value : at) {
        const double turns = 0.5 * (value - at[0]);
        EXPECT_NEAR(turns, std::round(turns), 1e-3); // 64 facets turn by their chords
    }
}

TEST(StripeFrames, FollowADeformation) {
    Striped striped(cylinder(0.5, 2.0, 64));
    // Twice as thick: the turning per set stays, and X too.
    const std::vector<glm::vec4> before = striped.frames;
    for (glm::vec3& p : striped.positions) p *= glm::vec3(2.0f, 1.0f, 2.0f);
    StripeFramesJob job = striped.job();
    job.run();
    for (std::size_t v = 0; v < before.size(); ++v) {
        if (std::abs(striped.normals[v].y) > 0.5f) continue;
        EXPECT_NEAR(striped.frames[v].w, before[v].w, 1e-4f);
        EXPECT_NEAR(std::abs(striped.frames[v].w), pi, 0.01);
        EXPECT_GT(glm::dot(glm::vec3(striped.frames[v]), glm::vec3(before[v])), 0.9999f);
    }
    const StripeFramesJob::Sum* scratch = job.sums.data();
    job.run();
    EXPECT_EQ(scratch, job.sums.data()); // nothing was allocated
}

TEST(StripeFrames, AreDefinedWhereNothingIs) {
    const Shape shape = plane(1.0, 2);
    const std::vector<glm::vec4> frames = frames_of(shape, std::vector<float>(shape.positions.size(), 0.7f));
    for (const glm::vec4& frame : frames) {
        EXPECT_EQ(frame.w, 0.0f);
        EXPECT_NEAR(glm::length(glm::vec3(frame)), 1.0f, 1e-6f);
        EXPECT_NEAR(frame.y, 0.0f, 1e-6f);
    }
    Shape point = plane(1.0, 1);
    for (glm::vec3& p : point.positions) p = glm::vec3(0.0f);
    for (const glm::vec4& frame : frames_of(point, {0.0f, 1.0f, 2.0f, 3.0f}))
        for (int k = 0; k < 4; ++k) EXPECT_TRUE(std::isfinite(frame[k]));
}

} // namespace
} // namespace hachure::geometry
