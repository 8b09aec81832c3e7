#include <hachure/runtime/geometry/fitted_normals.h>
#include <hachure/runtime/geometry/shapes.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hachure::geometry {
namespace {

/// A shape stretched along its axes, then turned and moved; with its normals.
Shape placed(Shape shape, const glm::dvec3& scale, const glm::dquat& turn, const glm::dvec3& move) {
    for (std::size_t i = 0; i < shape.positions.size(); ++i) {
        shape.positions[i] = glm::vec3(turn * (scale * glm::dvec3(shape.positions[i])) + move);
        shape.normals[i] = glm::vec3(glm::normalize(turn * (glm::dvec3(shape.normals[i]) / scale)));
    }
    return shape;
}

std::vector<glm::vec3> fitted(const Shape& shape, FittedShape kind, const std::vector<glm::vec3>& normals) {
    std::vector<glm::vec3> result(shape.positions.size());
    FittedNormalsJob job{
        .shape = kind, .positions = shape.positions, .normals = normals, .indices = shape.indices, .fitted = result};
    job.validate();
    job.run();
    return result;
}

double worst_angle(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, std::acos(std::min(1.0, glm::dot(glm::dvec3(a[i]), glm::dvec3(b[i])))));
    return worst;
}

const glm::dquat turn = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1, -2, 0.5)));
const glm::dvec3 move(40.0, -3.0, 7.0);

/// Of a box of half sides (a, b, c): the mean of x^2 over its faces, by hand.
TEST(SurfaceMoments, OfABox) {
    const double a = 3.0, b = 2.0, c = 1.0;
    const SurfaceMoments moments =
        surface_moments(placed(cube(2.0), {a, b, c}, turn, move).positions, cube(2.0).indices);
    EXPECT_LT(glm::distance(moments.center, move), 1e-5);
    const double x_faces = b * c, y_faces = a * c, z_faces = a * b, all = x_faces + y_faces + z_faces;
    EXPECT_NEAR(moments.variances.x, a * a * (x_faces + (y_faces + z_faces) / 3.0) / all, 1e-4);
    EXPECT_NEAR(moments.variances.y, b * b * (y_faces + (x_faces + z_faces) / 3.0) / all, 1e-4);
    EXPECT_NEAR(moments.variances.z, c * c * (z_faces + (x_faces + y_faces) / 3.0) / all, 1e-4);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = 1.0;
        EXPECT_NEAR(std::abs(glm::dot(moments.axes[i], turn * axis)), 1.0, 1e-6);
    }
}

TEST(SurfaceMoments, DoNotDependOnTheTriangles) {
    const Shape coarse = plane(2.0, 1), fine = plane(2.0, 16);
    const SurfaceMoments a = surface_moments(coarse.positions, coarse.indices),
                         b = surface_moments(fine.positions, fine.indices);
    EXPECT_LT(glm::distance(a.variances, b.variances), 1e-6);
    EXPECT_NEAR(a.variances.x, 4.0 / 12.0, 1e-6);
    EXPECT_NEAR(a.variances.z, 0.0, 1e-12);
}

TEST(FittedNormals, OfASphereAndACylinderAreTheirOwn) {
    const Shape ball = placed(icosphere(2.0, 3), glm::dvec3(1.0), turn, move);
    EXPECT_LT(worst_angle(fitted(ball, FittedShape::sphere, ball.normals), ball.normals), 1e-3);
    EXPECT_LT(worst_angle(fitted(ball, FittedShape::ellipsoid, ball.normals), ball.normals), 0.02);
    Shape tube = cylinder(0.5, 4.0, 64);
    std::vector<glm::vec3> radial;
    for (glm::vec3 p : tube.positions)
        radial.push_back(glm::length(glm::vec2(p.x, p.z)) > 0.1f ? glm::normalize(glm::vec3(p.x, 0.0f, p.z))
                                                                 : glm::vec3(0, 1, 0));
    tube.normals = radial;
    const Shape lying = placed(tube, glm::dvec3(1.0), turn, move);
    EXPECT_LT(worst_angle(fitted(lying, FittedShape::cylinder, lying.normals), lying.normals), 1e-3);
}

/// Exact only for the sphere: areas of an ellipsoid's surface lie more where it is flat.
TEST(FittedNormals, OfAnEllipsoidAreNearlyItsOwn) {
    const Shape egg = placed(icosphere(1.0, 4), {2.0, 1.2, 1.0}, turn, move);
    EXPECT_LT(worst_angle(fitted(egg, FittedShape::ellipsoid, egg.normals), egg.normals), 0.15);
    EXPECT_GT(worst_angle(fitted(egg, FittedShape::sphere, egg.normals), egg.normals), 0.3);
}

TEST(FittedNormals, AreUnitForAnySurface) {
    const Shape flat = plane(2.0, 4);
    const Shape point{.positions = {{1, 1, 1}}, .normals = {{0, 1, 0}}, .texcoords = {}, .indices = {}};
    const Shape line{.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                     .normals = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}},
                     .texcoords = {},
                     .indices = {0, 1, 2}};
    const Shape huge = placed(icosphere(1.0, 2), glm::dvec3(1e12), turn, glm::dvec3(0.0));
    const Shape tiny = placed(icosphere(1.0, 2), glm::dvec3(1e-12), turn, glm::dvec3(0.0));
    for (const Shape* shape : {&flat, &point, &line, &huge, &tiny})
        for (const FittedShape kind : {FittedShape::ellipsoid, FittedShape::sphere, FittedShape::cylinder})
            for (const glm::vec3& normal : fitted(*shape, kind, shape->normals))
                EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f);
    EXPECT_EQ(fitted(point, FittedShape::sphere, point.normals)[0], point.normals[0]);
}

} // namespace
} // namespace hachure::geometry
