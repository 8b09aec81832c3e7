#include <hachure/runtime/geometry/curvature_derivative.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact_torus.h"
#include "line_mesh.h"

namespace hachure::geometry {
namespace {

using reference::ExactTorus;
using reference::LineMesh;

/// RMS over the vertices of the four numbers' distance to the closed form, and RMS of the latter.
struct Errors {
    double error, size;
};

Errors torus_errors(std::uint32_t around, std::uint32_t across, double jitter) {
    const ExactTorus exact{1.0, 0.4};
    const Shape shape =
        jitter > 0.0 ? irregular_torus(1.0, 0.4, around, across, jitter, 5) : torus(1.0, 0.4, around, across);
    const LineMesh mesh(shape, true);
    Errors sum{0.0, 0.0};
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const ExactTorus::Place at = exact.nearest(glm::dvec3(mesh.positions[v]));
        // Only k2 changes, and along the section alone: d(k2)/ds = -sin * major / (minor * ring^2).
        const double change = -std::sin(at.across) * exact.major / (exact.minor * exact.ring(at) * exact.ring(at));
        const double turn = glm::dot(glm::dvec3(mesh.directions[v]), exact.across(at)) < 0.0 ? -1.0 : 1.0;
        const glm::dvec4 difference = glm::dvec4(mesh.derivatives[v]) - glm::dvec4(0.0, 0.0, turn * change, 0.0);
        sum.error += glm::dot(difference, difference);
        sum.size += change * change;
    }
    const auto count = static_cast<double>(mesh.positions.size());
    return {std::sqrt(sum.error / count), std::sqrt(sum.size / count)};
}

TEST(CurvatureDerivative, IsThatOfARegularTorusAndConvergesThere) {
    const Errors coarse = torus_errors(120, 48, 0.0), fine = torus_errors(240, 96, 0.0);
    RecordProperty("coarse", std::to_string(coarse.error / coarse.size));
    RecordProperty("fine", std::to_string(fine.error / fine.size));
    EXPECT_LT(coarse.error, 0.02 * coarse.size);
    EXPECT_LT(fine.error, 0.35 * coarse.error);
}

TEST(CurvatureDerivative, IsRoughlyThatOfAnIrregularTorus) {
    // Normals of such a mesh are off by what its triangles make of them, and each derivative multiplies that.
    const Errors errors = torus_errors(160, 64, 0.1);
    RecordProperty("irregular", std::to_string(errors.error / errors.size));
    EXPECT_LT(errors.error, 0.4 * errors.size);
}

TEST(CurvatureDerivative, ScalesWithTheInverseSquareOfTheSize) {
    const LineMesh small(torus(1e-3, 4e-4, 60, 24), true), large(torus(1.0, 0.4, 60, 24), true);
    for (std::size_t v = 0; v < small.positions.size(); ++v) {
        // The direction of k1 may be turned round; then so are the odd ones.
        const float turn = glm::dot(small.directions[v], large.directions[v]) < 0.0f ? -1.0f : 1.0f;
        for (int i = 0; i < 4; ++i) ASSERT_NEAR(turn * 1e-6f * small.derivatives[v][i], large.derivatives[v][i], 2e-2f);
    }
}

TEST(CurvatureDerivative, SpheresAndPlanesHaveNone) {
    for (const Shape& shape : {icosphere(1.0, 4), plane(2.0, 8)}) {
        const LineMesh mesh(shape, true);
        double sum = 0.0;
        for (const glm::vec4& c : mesh.derivatives) sum += static_cast<double>(glm::dot(c, c));
        EXPECT_LT(std::sqrt(sum / static_cast<double>(mesh.derivatives.size())), 0.2);
    }
}

TEST(CurvatureDerivative, BrokenMeshesAreDefined) {
    LineMesh mesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {9, 9, 9}, {1, 1e-9f, 0}, {0, -1, 1}, {0, -1, -1}},
                  {0, 1, 2, 0, 1, 5, 0, 0, 3, 0, 1, 3, 0, 1, 6, 0, 1, 7, 0, 3, 1}, true);
    for (const glm::vec4& c : mesh.derivatives)
        for (int i = 0; i < 4; ++i) EXPECT_TRUE(std::isfinite(c[i]));
    EXPECT_EQ(mesh.derivatives[4], glm::vec4(0.0f));
    mesh.indices[1] = 99;
    EXPECT_DEATH(mesh.derivative_job().validate(), "in range");
}

} // namespace
} // namespace hachure::geometry
