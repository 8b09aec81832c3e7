#include <hachure/runtime/geometry/mesh_health.h>

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "reference.h"

namespace hachure::geometry {
namespace {

using std::numbers::pi;

struct Closed {
    std::string name;
    Shape shape;
    double volume, area; ///< of the mesh, in closed form, or of the smooth shape
    double tolerance;    ///< relative
};

/// Volume of the polygon that a circle of `n` corners is, over that of the circle.
double polygon_ratio(double n) { return std::sin(2 * pi / n) / (2 * pi / n); }

std::vector<Closed> closed_shapes() {
    const double side = std::hypot(2.0, 1.0 * std::cos(pi / 24)); // of the cone's slices
    return {
        {"uv_sphere", uv_sphere(2.0, 96, 64), 4.0 / 3.0 * pi * 8.0, 16.0 * pi, 4e-3},
        {"icosphere", icosphere(2.0, 5), 4.0 / 3.0 * pi * 8.0, 16.0 * pi, 2e-3},
        {"torus", torus(2.0, 0.5, 128, 64), 2.0 * pi * pi * 2.0 * 0.25, 4.0 * pi * pi, 3e-3},
        {"irregular_torus", irregular_torus(2.0, 0.5, 128, 64, 0.4, 3), 2.0 * pi * pi * 0.5, 4.0 * pi * pi, 6e-3},
        {"cylinder", cylinder(1.5, 3.0, 24), pi * 2.25 * 3.0 * polygon_ratio(24),
         2.0 * pi * 2.25 * polygon_ratio(24) + 24.0 * 3.0 * 2.0 * 1.5 * std::sin(pi / 24), 1e-6},
        {"cone", cone(1.0, 2.0, 24), pi * 2.0 / 3.0 * polygon_ratio(24),
         pi * polygon_ratio(24) + 24.0 * std::sin(pi / 24) * side, 1e-6},
        {"cube", cube(2.0), 8.0, 24.0, 1e-7},
    };
}

TEST(Shapes, AreClosedAndFaceOutwards) {
    for (const Closed& c : closed_shapes()) {
        const MeshHealth health = geometry::inspect(c.shape.positions, c.shape.indices);
        EXPECT_TRUE(health.watertight()) << c.name;
        EXPECT_EQ(health.components, 1u) << c.name;
        EXPECT_EQ(health.degenerate_triangles + health.sliver_triangles, 0u) << c.name;
    }
}

TEST(Shapes, HaveTheirVolumeAndArea) {
    for (const Closed& c : closed_shapes()) {
        EXPECT_NEAR(reference::volume(c.shape.positions, c.shape.indices), c.volume, c.tolerance * c.volume) << c.name;
        EXPECT_NEAR(reference::area(c.shape.positions, c.shape.indices), c.area, c.tolerance * c.area) << c.name;
    }
}

TEST(Shapes, HaveUnitNormalsOnTheFrontOfTheirTriangles) {
    std::vector<Closed> shapes = closed_shapes();
    shapes.push_back({"plane", plane(3.0, 4), 0.0, 9.0, 0.0});
    for (const auto& [name, shape, volume, area, tolerance] : shapes) {
        ASSERT_EQ(shape.normals.size(), shape.positions.size()) << name;
        ASSERT_EQ(shape.texcoords.size(), shape.positions.size()) << name;
        for (std::size_t c = 0; c < shape.indices.size(); ++c) {
            const glm::dvec3 front = glm::normalize(reference::area_normal(shape.positions, shape.indices, c / 3));
            const glm::dvec3 normal(shape.normals[shape.indices[c]]);
            ASSERT_NEAR(glm::length(normal), 1.0, 1e-6) << name;
            // Facets lean away from the surface where the jitter makes their corners obtuse.
            ASSERT_GT(glm::dot(front, normal), name == "irregular_torus" ? 0.0 : 0.9) << name << " corner " << c;
        }
    }
}

TEST(Shapes, PutVerticesOnTheirSurface) {
    for (const Shape& sphere : {uv_sphere(2.0, 12, 8), icosphere(2.0, 2)})
        for (std::size_t v = 0; v < sphere.positions.size(); ++v) {
            EXPECT_NEAR(glm::length(glm::dvec3(sphere.positions[v])), 2.0, 1e-6);
            EXPECT_NEAR(glm::distance(sphere.positions[v], 2.0f * sphere.normals[v]), 0.0f, 1e-6f);
        }
    const Shape ring = irregular_torus(2.0, 0.5, 20, 10, 0.45, 1);
    for (std::size_t v = 0; v < ring.positions.size(); ++v) {
        const glm::dvec3 p(ring.positions[v]);
        const double from_tube = std::hypot(std::hypot(p.x, p.z) - 2.0, p.y);
        EXPECT_NEAR(from_tube, 0.5, 1e-6);
    }
}

TEST(Shapes, CountWhatTheyPromise) {
    EXPECT_EQ(icosphere(1.0, 3).indices.size() / 3, 20u * 64u);
    EXPECT_EQ(icosphere(1.0, 3).positions.size(), 642u);
    EXPECT_EQ(uv_sphere(1.0, 8, 4).indices.size() / 3, 8u * 3u * 2u);
    EXPECT_EQ(torus(2.0, 1.0, 9, 7).indices.size() / 3, 9u * 7u * 2u);
    EXPECT_EQ(irregular_torus(2.0, 1.0, 9, 7, 0.3, 1).positions.size(), 63u);
    EXPECT_EQ(plane(1.0, 5).indices.size() / 3, 50u);
    EXPECT_EQ(cube(1.0).positions.size(), 24u);
}

TEST(Shapes, TheIrregularTorusFollowsItsSeed) {
    EXPECT_EQ(irregular_torus(2.0, 1.0, 9, 7, 0.3, 1).positions, irregular_torus(2.0, 1.0, 9, 7, 0.3, 1).positions);
    EXPECT_NE(irregular_torus(2.0, 1.0, 9, 7, 0.3, 1).positions, irregular_torus(2.0, 1.0, 9, 7, 0.3, 2).positions);
}

} // namespace
} // namespace hachure::geometry
