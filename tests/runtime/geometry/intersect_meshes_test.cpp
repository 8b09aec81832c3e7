#include <hachure/runtime/assets/read_model.h>
#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/intersect_meshes.h>
#include <hachure/runtime/geometry/orientation.h>
#include <hachure/runtime/parallel.h>
#include <hachure/tests/support/given_models.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <set>

#include "line_chains.h"
#include "reference.h"

namespace hachure::geometry {
namespace {

using Segments = std::vector<SurfaceSegment>;
using reference::chains;
using reference::closed_chains;
using reference::ends_agree;

Segments between(const Shape& a, const Shape& b, const glm::mat4& a_from_b) {
    return mesh_intersections(a.positions, a.indices, b.positions, b.indices, a_from_b);
}

Segments within(const Shape& shape) { return self_intersections(shape.positions, shape.indices); }

Shape joined(Shape a, const Shape& b, const glm::mat4& a_from_b) {
    const auto first = static_cast<std::uint32_t>(a.positions.size());
    for (const glm::vec3& p : b.positions) a.positions.emplace_back(glm::dmat4(a_from_b) * glm::dvec4(p, 1.0));
    for (const std::uint32_t i : b.indices) a.indices.push_back(first + i);
    return a;
}

__extension__ using Wide = __int128;

TEST(Orientation, IsThatOfTheDeterminantInIntegers) {
    std::mt19937 random(3);
    for (int i = 0; i < 200000; ++i) {
        // Points of a small lattice are often in one plane; moved far away, doubles round their determinant.
        const bool far = i % 2 == 1;
        std::int64_t p[4][3];
        for (auto& point : p)
            for (auto& x : point) x = static_cast<std::int64_t>(random() % 5) + (far ? (1 << 22) : 0);
        if (far) // a direction in which differences grow large, too
            for (auto& point : p) point[0] = static_cast<std::int64_t>(random() % 3) * 5000011 % (1 << 23);
        glm::vec3 v[4];
        for (int k = 0; k < 4; ++k) v[k] = glm::vec3(p[k][0], p[k][1], p[k][2]);
        Wide d[3][3];
        for (int k = 0; k < 3; ++k)
            for (int m = 0; m < 3; ++m) d[k][m] = p[k][m] - p[3][m];
        const Wide determinant = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) +
                                 d[0][1] * (d[1][2] * d[2][0] - d[1][0] * d[2][2]) +
                                 d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
        ASSERT_EQ(orientation(v[0], v[1], v[2], v[3]), determinant < 0 ? 1 : determinant > 0 ? -1 : 0);
    }
}

TEST(Orientation, SeesTheLastBit) {
    const glm::vec3 a(0.1f, 0.1f, 0.1f), b(1000.3f, 0.7f, 0.2f), c(0.4f, 999.0f, 0.6f);
    // b - a and c - a span the plane; a point on its line through a and b by construction: a itself, and a moved by one
    // unit in the last place to both sides.
    EXPECT_EQ(orientation(a, b, c, a), 0);
    EXPECT_EQ(orientation(a, b, c, {a.x, a.y, std::nextafter(a.z, 1.0f)}), 1);
    EXPECT_EQ(orientation(a, b, c, {a.x, a.y, std::nextafter(a.z, 0.0f)}), -1);
    EXPECT_EQ(orientation({1e-30f, 0, 0}, {0, 1e-30f, 0}, {0, 0, 1e30f}, {1e-30f, 1e-30f, 1e30f}), 1);
}

TEST(IntersectMeshes, TwoSpheresMeetInACircle) {
    const Shape sphere = icosphere(1.0, 4);
    const glm::dvec3 offset(0.9, 0.31, 0.17);
    const Segments segments = between(sphere, sphere, glm::translate(glm::mat4(1.0f), glm::vec3(offset)));
    const double radius = std::sqrt(1.0 - 0.25 * glm::dot(offset, offset));
    EXPECT_TRUE(ends_agree(segments));
    EXPECT_EQ(chains(segments).size(), 1u);
    EXPECT_EQ(closed_chains(segments), 1u);
    EXPECT_NEAR(reference::length(segments), 2.0 * std::numbers::pi * radius, 0.02);
    for (const SurfaceSegment& s : segments) {
        const glm::dvec3 p(s.start);
        // Between facets and sphere: facets of 5120 lie up to 0.0016 inside.
        EXPECT_NEAR(glm::length(p), 0.9992, 0.0009);
        EXPECT_NEAR(glm::length(p - offset), 0.9992, 0.0009);
    }
}

TEST(IntersectMeshes, ASphereMeetsAPlaneInACircle) {
    const Shape sphere = icosphere(1.0, 4), floor = plane(4.0, 7);
    const Segments segments = between(sphere, floor, glm::translate(glm::mat4(1.0f), {0.013f, 0.6f, 0.027f}));
    EXPECT_EQ(closed_chains(segments), 1u);
    EXPECT_EQ(chains(segments).size(), 1u);
    EXPECT_NEAR(reference::length(segments), 2.0 * std::numbers::pi * 0.8, 0.01);
    for (const SurfaceSegment& s : segments) EXPECT_NEAR(s.end.y, 0.6f, 1e-6f);
}

TEST(IntersectMeshes, TwoCubesMeetInAHexagonOfEdges) {
    const Shape box = cube(1.0);
    const Segments segments = between(box, box, glm::translate(glm::mat4(1.0f), {0.5f, 0.25f, 0.125f}));
    EXPECT_TRUE(ends_agree(segments));
    EXPECT_EQ(chains(segments).size(), 1u);
    EXPECT_EQ(closed_chains(segments), 1u);
    EXPECT_NEAR(reference::length(segments), 2.0 * (0.5 + 0.75 + 0.875), 1e-6);
}

TEST(IntersectMeshes, ABodyThatStandsOnAnotherHasTheLineOfContact) {
    const Shape ground = cube(2.0), box = cube(0.5);
    const glm::vec3 up(0.0f, 1.25f, 0.0f); // its corners are on the diagonal of the ground's top
    for (const glm::vec3& aside : {glm::vec3(0.0f), glm::vec3(0.25f, 0.0f, 0.125f), glm::vec3(0.3f, 0.0f, 0.1f)}) {
        const Segments segments = between(ground, box, glm::translate(glm::mat4(1.0f), up + aside));
        EXPECT_NEAR(reference::length(segments), 2.0, 1e-6);
        for (const SurfaceSegment& s : segments) EXPECT_EQ(s.start.y, 1.0f);
        EXPECT_TRUE(between(ground, box, glm::translate(glm::mat4(1.0f), 1.01f * up + aside)).empty());
    }
}

/// Independent of the code under test: intervals on the common line of both planes (Moller 1997), in double; nothing
/// where a distance is too small to trust.
std::optional<bool> pass_through(const glm::dvec3 (&a)[3], const glm::dvec3 (&b)[3]) {
    const auto normal = [](const glm::dvec3(&t)[3]) { return glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0])); };
    const glm::dvec3 na = normal(a), nb = normal(b), line = glm::cross(na, nb);
    double intervals[2][2];
    for (int side = 0; side < 2; ++side) {
        const auto& own = side == 0 ? a : b;
        double d[3];
        for (int k = 0; k < 3; ++k) {
            d[k] = side == 0 ? glm::dot(nb, own[k] - b[0]) : glm::dot(na, own[k] - a[0]);
            if (std::abs(d[k]) < 1e-9) return std::nullopt;
        }
        int count = 0;
        for (int k = 0; k < 3; ++k) {
            const int n = (k + 1) % 3;
            if ((d[k] > 0) == (d[n] > 0)) continue;
            const glm::dvec3 p = own[k] + d[k] / (d[k] - d[n]) * (own[n] - own[k]);
            intervals[side][count++] = glm::dot(line, p);
        }
        if (count == 0) return false;
        if (intervals[side][0] > intervals[side][1]) std::swap(intervals[side][0], intervals[side][1]);
    }
    const double low = std::max(intervals[0][0], intervals[1][0]), high = std::min(intervals[0][1], intervals[1][1]);
    if (std::abs(high - low) < 1e-9) return std::nullopt;
    return low < high;
}

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

TEST(IntersectMeshes, IsAllPairsThatPassThroughEachOther) {
    const Shape a = irregular_torus(1.0, 0.4, 40, 20, 0.4, 3), b = irregular_torus(0.9, 0.3, 36, 16, 0.4, 8);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    std::size_t found = 0;
    for (int round = 0; round < 4; ++round) {
        glm::mat4 place = glm::translate(glm::mat4(1.0f), {any(random), 0.3f * any(random), any(random)});
        place = glm::rotate(place, 3.0f * any(random), glm::normalize(glm::vec3(any(random), any(random), 1.5f)));
        place = glm::scale(place, {1.0f, round == 3 ? -0.8f : 1.2f, 0.9f});
        Pairs expected, undecided, got;
        std::vector<glm::vec3> moved;
        for (const glm::vec3& p : b.positions) moved.emplace_back(glm::dmat4(place) * glm::dvec4(p, 1.0));
        for (std::uint32_t f = 0; f < a.indices.size() / 3; ++f)
            for (std::uint32_t g = 0; g < b.indices.size() / 3; ++g) {
                glm::dvec3 s[3], t[3];
                for (std::size_t k = 0; k < 3; ++k) {
                    s[k] = a.positions[a.indices[3 * f + k]];
                    t[k] = moved[b.indices[3 * g + k]];
                }
                if (const auto through = pass_through(s, t); !through)
                    undecided.emplace(f, g);
                else if (*through)
                    expected.emplace(f, g);
            }
        const Segments segments = between(a, b, place);
        for (const SurfaceSegment& s : segments)
            if (!undecided.contains({s.face, s.other_face})) got.emplace(s.face, s.other_face);
        EXPECT_LT(undecided.size(), 5u);
        EXPECT_EQ(got, expected);
        EXPECT_TRUE(ends_agree(segments));
        EXPECT_EQ(closed_chains(segments), chains(segments).size()) << "closed bodies meet in closed lines";
        found += expected.size();
        // One mesh of both has the same lines, and none besides.
        EXPECT_NEAR(reference::length(within(joined(a, b, place))), reference::length(segments), 1e-4);
    }
    EXPECT_GT(found, 500u);
}

TEST(SelfIntersections, SurfacesThatDoNotFoldHaveNone) {
    for (const Shape& shape : {icosphere(1.0, 4), uv_sphere(1.0, 40, 20), torus(1.0, 0.4, 50, 20), cube(1.0),
                               irregular_torus(1.0, 0.4, 80, 40, 0.45, 2), cylinder(1.0, 2.0, 50), cone(1.0, 1.0, 30)})
        EXPECT_TRUE(within(shape).empty());
}

TEST(SelfIntersections, ATrianglePassesThroughOneThatSharesACorner) {
    Shape shape;
    shape.positions = {{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {1, 0, -1}, {1, 0, 1}};
    shape.indices = {0, 1, 2, 0, 3, 4};
    const Segments segments = within(shape);
    ASSERT_EQ(segments.size(), 1u);
    EXPECT_EQ(segments[0].start, glm::vec3(0.0f));
    EXPECT_EQ(segments[0].end, glm::vec3(1.0f, 0.0f, 0.0f));
    shape.positions[3] = {-1, 0, -1}; // now they touch at the corner alone
    shape.positions[4] = {-1, 0, 1};
    EXPECT_TRUE(within(shape).empty());
    shape.positions[3] = {1, 0, 1}; // and here one stands on one side of the other
    shape.positions[4] = {1, 0.5f, 1};
    EXPECT_TRUE(within(shape).empty());
}

TEST(SelfIntersections, DoNotDependOnThreads) {
    const Shape a = irregular_torus(1.0, 0.4, 60, 30, 0.4, 3);
    const Shape both = joined(a, a, glm::translate(glm::mat4(1.0f), {0.8f, 0.1f, 0.05f}));
    const int threads = thread_limit();
    set_thread_limit(1);
    const Segments one = within(both);
    set_thread_limit(4);
    EXPECT_EQ(within(both), one);
    set_thread_limit(threads);
    EXPECT_GT(one.size(), 100u);
}

class BrokenModels : public test::GivenModelTest {};

TEST_P(BrokenModels, HaveFiniteLinesWithinThem) {
    const assets::Model model = assets::read_model(file());
    const assets::Primitive& mesh = model.meshes.at(0).primitives.at(0);
    const Segments segments = self_intersections(mesh.positions, mesh.indices);
    const Bounds bounds = bounds_of(mesh.positions);
    RecordProperty("triangles", std::to_string(mesh.indices.size() / 3));
    RecordProperty("segments", std::to_string(segments.size()));
    EXPECT_TRUE(ends_agree(segments));
    for (const SurfaceSegment& s : segments)
        for (const glm::vec3& p : {s.start, s.end})
            for (int i = 0; i < 3; ++i) {
                ASSERT_GE(p[i], bounds.low[i]);
                ASSERT_LE(p[i], bounds.high[i]);
            }
}

INSTANTIATE_TEST_SUITE_P(Given, BrokenModels,
                         testing::Values("broken/manifold/self_intersectA.obj", "broken/manifold/Offset1.obj"),
                         test::given_model_name);

} // namespace
} // namespace hachure::geometry
