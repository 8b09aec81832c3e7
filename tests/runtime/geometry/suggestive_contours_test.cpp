#include <hachure/runtime/geometry/suggestive_contours.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact_torus.h"
#include "line_chains.h"
#include "line_mesh.h"

namespace hachure::geometry {
namespace {

using reference::ExactTorus;
using reference::LineMesh;

SuggestiveContoursJob job_of(const LineMesh& mesh, const glm::vec4& eye, const SuggestiveOptions& options) {
    return {.positions = mesh.positions,
            .normals = mesh.normals,
            .indices = mesh.indices,
            .weld = mesh.weld,
            .curvatures = mesh.curvatures,
            .directions = mesh.directions,
            .derivatives = mesh.derivatives,
            .eye = eye,
            .options = options};
}

std::vector<glm::vec4> eyes_around() {
    return {{2.5f, 1.9f, 0.7f, 1.0f}, {-1.2f, 3.0f, 2.2f, 1.0f}, {0.6f, 0.3f, 0.74f, 0.0f}, {0.1f, 2.4f, 0.3f, 1.0f}};
}

/// What a place of the exact surface says: is there a line?
struct Exact {
    double offset;            ///< metres from the place to where the radial curvature is zero, by its gradient
    double derivative, angle; ///< as SuggestiveOptions has them, for a size of 1
};

Exact exact_at(const ExactTorus& torus, const ExactTorus::Place& at, const glm::dvec4& eye) {
    const ExactTorus::View view = torus.view(at, eye);
    const double h = 1e-6;
    glm::dvec2 gradient;
    for (int i = 0; i < 2; ++i) {
        const glm::dvec3 step = h * (i == 0 ? torus.across(at) : torus.around(at));
        gradient[i] =
            (torus.view(torus.moved(at, step), eye).curvature - torus.view(torus.moved(at, -step), eye).curvature) /
            (2.0 * h);
    }
    return {view.curvature / glm::length(gradient), view.sine * torus.radial_derivative(at, eye),
            std::acos(std::clamp(view.cosine, -1.0, 1.0))};
}

double distance_to(const SurfaceSegment& s, const glm::dvec3& p) {
    const glm::dvec3 a(s.start), b(s.end);
    const double square = glm::dot(b - a, b - a);
    const double t = square > 0.0 ? std::clamp(glm::dot(p - a, b - a) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, glm::mix(a, b, t));
}

TEST(SuggestiveContours, AreWhereTheRadialCurvatureOfATorusVanishes) {
    const ExactTorus torus_surface{1.0, 0.4};
    const LineMesh mesh(torus(1.0, 0.4, 240, 96), true);
    const SuggestiveOptions options{.angle = 0.3f, .derivative = 0.5f};
    std::size_t checked = 0, wanted = 0;
    for (const glm::vec4& eye : eyes_around()) {
        SuggestiveContoursJob job = job_of(mesh, eye, options);
        job.validate();
        job.run();
        EXPECT_TRUE(reference::ends_agree(job.segments));
        for (const SurfaceSegment& s : job.segments) { // nothing but what is there
            const Exact exact = exact_at(torus_surface, torus_surface.nearest(glm::dvec3(s.start)), glm::dvec4(eye));
            ASSERT_LT(std::abs(exact.offset), 0.008); // a third of a cell
            ASSERT_GT(exact.derivative, 0.45);
            ASSERT_GT(exact.angle, 0.29);
            ASSERT_LT(exact.angle, std::numbers::pi / 2 + 0.02);
            ++checked;
        }
        // And all of it: along many circles about the axis, each change of sign.
        const int steps = 720;
        for (double across = 0.013; across < 2.0 * std::numbers::pi; across += 0.05)
            for (int i = 0; i < steps; ++i) {
                const auto at = [&](double step) {
                    return ExactTorus::Place{2.0 * std::numbers::pi * step / steps, across};
                };
                const auto value = [&](double step) { return torus_surface.view(at(step), glm::dvec4(eye)).curvature; };
                double low = i, high = i + 1;
                if ((value(low) > 0.0) == (value(high) > 0.0)) continue;
                for (int k = 0; k < 40; ++k) {
                    const double middle = 0.5 * (low + high);
                    ((value(middle) > 0.0) == (value(low) > 0.0) ? low : high) = middle;
                }
                const Exact exact = exact_at(torus_surface, at(low), glm::dvec4(eye));
                if (exact.derivative < 0.55 || exact.angle < 0.31 || exact.angle > std::numbers::pi / 2 - 0.02)
                    continue;
                const glm::dvec3 place = torus_surface.position(at(low));
                double nearest = 1e9;
                for (const SurfaceSegment& s : job.segments) nearest = std::min(nearest, distance_to(s, place));
                ASSERT_LT(nearest, 0.006);
                ++wanted;
            }
    }
    EXPECT_GT(checked, 150u);
    EXPECT_GT(wanted, 40u);
}

TEST(SuggestiveContours, WeightsRiseWithDerivativeAndAngle) {
    const ExactTorus torus_surface{1.0, 0.4};
    const LineMesh mesh(torus(1.0, 0.4, 240, 96), true);
    const SuggestiveOptions options{.angle = 0.4f, .angle_fade = 0.5f, .derivative = 0.5f, .derivative_fade = 1.5f};
    std::size_t between = 0;
    for (const glm::vec4& eye : eyes_around()) {
        SuggestiveContoursJob job = job_of(mesh, eye, options);
        job.run();
        for (const SurfaceSegment& s : job.segments) {
            const Exact exact = exact_at(torus_surface, torus_surface.nearest(glm::dvec3(s.end)), glm::dvec4(eye));
            const double weight =
                std::clamp((exact.derivative - 0.5) / 1.5, 0.0, 1.0) * std::clamp((exact.angle - 0.4) / 0.5, 0.0, 1.0);
            ASSERT_NEAR(s.end_weight, weight, 0.06);
            between += s.end_weight > 0.1f && s.end_weight < 0.9f ? 1 : 0;
        }
        for (const Chain& chain : reference::chains(job.segments)) EXPECT_EQ(chain.closed, 0u);
    }
    EXPECT_GT(between, 50u);
}

TEST(SuggestiveContours, FewerTrianglesToLookAtChangeNothing) {
    const LineMesh mesh(irregular_torus(1.0, 0.4, 160, 64, 0.2, 3), true);
    const std::vector<std::uint32_t> candidates = suggestive_candidates(mesh.indices, mesh.weld, mesh.curvatures);
    EXPECT_LT(candidates.size(), mesh.indices.size() / 3 * 7 / 10);
    const std::vector<std::uint32_t> vertices = candidate_vertices(candidates, mesh.indices, mesh.weld);
    EXPECT_LT(vertices.size(), mesh.positions.size() * 8 / 10);
    std::size_t found = 0;
    for (const glm::vec4& eye : eyes_around()) {
        SuggestiveContoursJob all = job_of(mesh, eye, {.angle = 0.1f, .derivative = 0.1f}), some = all;
        some.candidates = candidates;
        some.vertices = vertices;
        some.validate();
        all.run();
        some.run();
        EXPECT_EQ(all.segments, some.segments);
        found += all.segments.size();
    }
    EXPECT_GT(found, 100u);
}

TEST(SuggestiveContours, ConvexBodiesHaveNone) {
    const LineMesh mesh(icosphere(1.0, 4), true);
    for (const glm::vec4& eye : eyes_around()) {
        SuggestiveContoursJob job = job_of(mesh, eye, {.angle = 0.0f, .derivative = 0.0f});
        job.run();
        EXPECT_TRUE(job.segments.empty());
    }
}

} // namespace
} // namespace hachure::geometry
