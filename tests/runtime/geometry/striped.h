#pragma once

#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/geometry/stripe_frames.h>
#include <hachure/runtime/geometry/stripe_mesh.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace hachure::geometry {

/// A mesh with its stripes and their frames.
struct Striped {
    std::vector<glm::vec3> positions, normals; ///< of the stripe mesh
    StripeMesh mesh;
    std::vector<glm::vec4> frames;

    Striped(std::vector<glm::vec3> p, std::vector<glm::vec3> n, const std::vector<std::uint32_t>& indices,
            const StripeSettings& settings = {})
        : mesh(make_stripe_mesh(p, n, indices, settings)) {
        for (const std::uint32_t v : mesh.source_vertex) {
            positions.push_back(p[v]);
            normals.push_back(n.empty() ? glm::vec3(0.0f, 1.0f, 0.0f) : n[v]);
        }
        frames.resize(positions.size());
        StripeFramesJob job = this->job();
        job.validate();
        job.run();
    }
    explicit Striped(const Shape& shape, const StripeSettings& settings = {})
        : Striped(shape.positions, shape.normals, shape.indices, settings) {}

    StripeFramesJob job() {
        return {.positions = positions,
                .normals = normals,
                .indices = mesh.indices,
                .coordinate = mesh.coordinate,
                .stands_for = mesh.stands_for,
                .mirrored = mesh.mirrored,
                .frames = frames};
    }

    [[nodiscard]] glm::dvec3 direction(std::size_t vertex) const { return glm::dvec3(glm::vec3(frames[vertex])); }

    /// What is drawn at a coordinate, in [0, 1].
    [[nodiscard]] static double folded(double u) { return std::abs(u - 2.0 * std::round(0.5 * u)); }

    /// Sizes, ranges, finite numbers; and that the mesh lies on the one it is made of.
    void expect_sound(std::size_t vertices, const std::vector<std::uint32_t>& indices) const {
        const std::size_t count = mesh.source_vertex.size();
        ASSERT_GE(count, vertices);
        ASSERT_EQ(mesh.indices.size(), indices.size());
        ASSERT_EQ(mesh.coordinate.size(), count);
        ASSERT_EQ(mesh.weight.size(), count);
        ASSERT_EQ(mesh.stands_for.size(), count);
        ASSERT_EQ(mesh.mirrored.size(), count);
        ASSERT_EQ(mesh.lean.size(), count);
        ASSERT_EQ(mesh.clarity.size(), count);
        for (std::size_t v = 0; v < count; ++v) {
            ASSERT_TRUE(std::isfinite(mesh.coordinate[v]) && std::abs(mesh.coordinate[v]) <= 1e5f) << v;
            ASSERT_TRUE(mesh.weight[v] >= 0.0f && mesh.weight[v] <= 1.0f) << v;
            ASSERT_LT(mesh.stands_for[v], count);
            ASSERT_LE(mesh.mirrored[v], 1);
            ASSERT_NEAR(glm::length(mesh.lean[v]), 1.0f, 1e-5f) << v;
            ASSERT_TRUE(mesh.clarity[v] >= 0.0f && mesh.clarity[v] <= 1.0f) << v;
            if (v < vertices) {
                ASSERT_EQ(mesh.source_vertex[v], v);
            } else {
                ASSERT_LT(mesh.source_vertex[v], vertices);
            }
            for (int k = 0; k < 4; ++k) ASSERT_TRUE(std::isfinite(frames[v][k])) << v;
        }
        for (std::size_t i = 0; i < indices.size(); ++i)
            ASSERT_EQ(mesh.source_vertex.at(mesh.indices[i]), indices[i]) << i;
    }
};

inline double line_degrees(const glm::dvec3& a, const glm::dvec3& b) {
    const double lengths = glm::length(a) * glm::length(b);
    return lengths > 0.0 ? glm::degrees(std::acos(std::min(1.0, std::abs(glm::dot(a, b)) / lengths))) : 90.0;
}

/// The value below which this part of them lies.
inline double quantile(std::vector<double> values, double part) {
    if (values.empty()) return std::nan("");
    std::ranges::sort(values);
    return values[std::min(values.size() - 1, static_cast<std::size_t>(part * static_cast<double>(values.size())))];
}

} // namespace hachure::geometry
