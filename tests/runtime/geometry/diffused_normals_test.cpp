#include <hachure/runtime/geometry/diffused_normals.h>
#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/geometry/weld.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace hachure::geometry {
namespace {

std::vector<glm::vec3> diffused(const Shape& shape, double radius, std::span<const glm::vec3> normals) {
    const std::vector<std::uint32_t> weld = weld_positions(shape.positions);
    std::vector<glm::vec3> result(shape.positions.size());
    DiffusedNormalsJob job{.positions = shape.positions,
                           .normals = normals,
                           .indices = shape.indices,
                           .weld = weld,
                           .radius = radius,
                           .diffused = result};
    job.validate();
    job.run();
    return result;
}

double angle(const glm::vec3& a, const glm::vec3& b) {
    return std::atan2(glm::length(glm::cross(glm::dvec3(a), glm::dvec3(b))), glm::dot(glm::dvec3(a), glm::dvec3(b)));
}

/// The same by another way: linear elements from the gradients of hat functions, a full matrix, Gauss with pivots.
std::vector<glm::dvec3> solve_densely(const Shape& shape, double radius) {
    const std::size_t n = shape.positions.size();
    std::vector<std::vector<double>> matrix(n, std::vector<double>(n, 0.0));
    std::vector<double> mass(n, 0.0);
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        const std::uint32_t* v = &shape.indices[i];
        const glm::dvec3 p[3] = {glm::dvec3(shape.positions[v[0]]), glm::dvec3(shape.positions[v[1]]),
                                 glm::dvec3(shape.positions[v[2]])};
        const glm::dvec3 area_normal = 0.5 * glm::cross(p[1] - p[0], p[2] - p[0]);
        const double area = glm::length(area_normal);
        glm::dvec3 gradient[3];
        for (int k = 0; k < 3; ++k)
            gradient[k] = glm::cross(area_normal / area, p[(k + 2) % 3] - p[(k + 1) % 3]) / (2.0 * area);
        for (int a = 0; a < 3; ++a) {
            mass[v[a]] += area / 3.0;
            for (int b = 0; b < 3; ++b)
                matrix[v[a]][v[b]] += radius * radius * area * glm::dot(gradient[a], gradient[b]);
        }
    }
    std::vector<glm::dvec3> x(n);
    for (std::size_t i = 0; i < n; ++i) {
        matrix[i][i] += mass[i];
        x[i] = mass[i] * glm::dvec3(shape.normals[i]);
    }
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < n; ++i)
            if (std::abs(matrix[i][k]) > std::abs(matrix[pivot][k])) pivot = i;
        std::swap(matrix[k], matrix[pivot]);
        std::swap(x[k], x[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = matrix[i][k] / matrix[k][k];
            for (std::size_t j = k; j < n; ++j) matrix[i][j] -= factor * matrix[k][j];
            x[i] -= factor * x[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) x[k] -= matrix[k][j] * x[j];
        x[k] /= matrix[k][k];
    }
    for (glm::dvec3& normal : x) normal = glm::normalize(normal);
    return x;
}

TEST(DiffusedNormals, SolveTheEquation) {
    const Shape torus = irregular_torus(1.0, 0.4, 16, 9, 0.4, 5);
    for (const double radius : {0.05, 0.3, 2.0}) {
        const std::vector<glm::vec3> found = diffused(torus, radius, torus.normals);
        const std::vector<glm::dvec3> expected = solve_densely(torus, radius);
        double worst = 0.0;
        for (std::size_t i = 0; i < found.size(); ++i)
            worst = std::max(worst, glm::distance(glm::dvec3(found[i]), expected[i]));
        EXPECT_LT(worst, 1e-4) << radius;
        RecordProperty("radius " + std::to_string(radius), std::to_string(worst));
    }
}

/// On a unit sphere, spherical harmonics of degree l shrink to 1 / (1 + l (l + 1) r^2): the normals themselves are of
/// degree 1, a ripple on them of degree 4. What is left of the ripple is the same on any mesh.
TEST(DiffusedNormals, ShrinkWavesAsTheHeatEquationDoes) {
    const double ripple = 0.1, radius = 0.3;
    const double left = ripple * (1.0 + 2.0 * radius * radius) / (1.0 + 20.0 * radius * radius);
    for (const std::uint32_t level : {3u, 5u}) {
        const Shape sphere = icosphere(1.0, level);
        const auto rippled = [&](double size) {
            std::vector<glm::vec3> normals = sphere.normals;
            for (glm::vec3& n : normals) {
                const double z = n.z, wave = (35.0 * z * z * z * z - 30.0 * z * z + 3.0) / 8.0;
                n = glm::vec3(glm::normalize(glm::dvec3(n) + size * wave * glm::dvec3(1, 0, 0)));
            }
            return normals;
        };
        const std::vector<glm::vec3> before = rippled(ripple), expected = rippled(left);
        const std::vector<glm::vec3> after = diffused(sphere, radius, before);
        double worst = 0.0, worst_before = 0.0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            worst = std::max(worst, angle(after[i], expected[i]));
            worst_before = std::max(worst_before, angle(before[i], expected[i]));
        }
        EXPECT_GT(worst_before, 0.05);
        EXPECT_LT(worst, level == 3 ? 0.008 : 0.005) << level; // the normals are made unit again, which is not linear
    }
}

TEST(DiffusedNormals, SeamsAndHardEdgesAreOneSurface) {
    const Shape box = cube(2.0);
    const std::vector<glm::vec3> normals = diffused(box, 0.0, box.normals);
    // Corners average three faces, of which one may have two triangles there.
    for (std::size_t i = 0; i < normals.size(); ++i) {
        EXPECT_LT(angle(normals[i], glm::normalize(box.positions[i])), 0.4) << i;
        for (std::size_t j = 0; j < i; ++j) {
            if (box.positions[i] != box.positions[j]) continue;
            EXPECT_EQ(normals[i], normals[j]);
        }
    }
}

TEST(DiffusedNormals, WhatHasNoAreaKeepsItsNormal) {
    Shape odd = icosphere(1.0, 1);
    const auto count = static_cast<std::uint32_t>(odd.positions.size());
    odd.positions.insert(odd.positions.end(), {{5, 0, 0}, {5, 1, 0}, {5, 2, 0}, {7, 7, 7}});
    odd.normals.insert(odd.normals.end(), {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, -1, 0}});
    odd.indices.insert(odd.indices.end(), {count, count + 1, count + 2}); // on one line
    const std::vector<glm::vec3> normals = diffused(odd, 0.5, odd.normals);
    for (std::size_t i = count; i < odd.positions.size(); ++i) EXPECT_EQ(normals[i], odd.normals[i]);
    for (std::size_t i = 0; i < count; ++i) EXPECT_LT(angle(normals[i], odd.normals[i]), 1e-3);
}

TEST(DiffusedNormals, AllocateNothingOnASecondRun) {
    const Shape torus = irregular_torus(1.0, 0.4, 12, 8, 0.3, 1);
    const std::vector<std::uint32_t> weld = weld_positions(torus.positions);
    std::vector<glm::vec3> result(torus.positions.size());
    DiffusedNormalsJob job{.positions = torus.positions,
                           .normals = torus.normals,
                           .indices = torus.indices,
                           .weld = weld,
                           .radius = 0.2,
                           .diffused = result};
    job.run();
    const std::vector<glm::vec3> first = result;
    const void* kept[] = {job.triangles.data(), job.areas.data(), job.solution.data(), job.product.data()};
    job.run();
    EXPECT_EQ(result, first);
    EXPECT_GT(job.steps, 0u);
    const void* after[] = {job.triangles.data(), job.areas.data(), job.solution.data(), job.product.data()};
    EXPECT_TRUE(std::ranges::equal(kept, after));
}

} // namespace
} // namespace hachure::geometry
