#pragma once

#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/tests/support/bent_cylinder.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace hachure::test {

/// RMS in degrees over the vertices of the joint zone.
struct BentErrors {
    double blended_normals, recomputed_normals;
    /// Of the cross of both principal directions: the line of k1 against the nearer of the exact two, since the order
    /// of curvatures changes within the zone. Without the vertices whose exact curvatures differ by less than 0.1 /
    /// radius: near umbilics every direction is as good.
    double carried_directions, recomputed_directions;
};

/// The cylinder skinned, with normals and curvatures by both ways: blended or carried from rest, and recomputed.
struct BentMesh {
    CylinderMesh rest;
    std::vector<glm::vec3> positions, blended, recomputed;
    std::vector<glm::vec2> rest_curvatures, carried, curvatures;
    std::vector<glm::vec3> rest_directions, carried_directions, directions;
    geometry::SmoothNormalsJob normals_job;
    geometry::CurvatureJob curvature_job;

    explicit BentMesh(std::uint32_t slices) : rest(slices) {
        for (auto* values : {&positions, &blended, &recomputed, &rest_directions, &carried_directions, &directions})
            values->resize(rest.positions.size());
        for (auto* values : {&rest_curvatures, &carried, &curvatures}) values->resize(rest.positions.size());
        normals_job = {.positions = positions, .indices = rest.indices, .weld = rest.weld, .normals = recomputed};
        curvature_job = {.positions = rest.positions,
                         .normals = rest.normals,
                         .indices = rest.indices,
                         .weld = rest.weld,
                         .curvatures = rest_curvatures,
                         .directions = rest_directions};
        curvature_job.validate();
        curvature_job.run();
        curvature_job.positions = positions;
        curvature_job.normals = recomputed;
        curvature_job.curvatures = curvatures;
        curvature_job.directions = directions;
    }

    [[nodiscard]] geometry::SkinJob skin_job(geometry::SkinMethod method) {
        return {.method = method,
                .rest_positions = rest.positions,
                .rest_normals = rest.normals,
                .weights = &rest.weights,
                .palette = rest.palette,
                .motions = rest.motions,
                .positions = positions,
                .normals = blended};
    }

    [[nodiscard]] geometry::CarryCurvatureJob carry_job(geometry::SkinMethod method) {
        return {.method = method,
                .rest_normals = rest.normals,
                .rest_curvatures = rest_curvatures,
                .rest_directions = rest_directions,
                .weights = &rest.weights,
                .palette = rest.palette,
                .motions = rest.motions,
                .curvatures = carried,
                .directions = carried_directions};
    }

    /// Runs all jobs in the pose that `rest` has.
    void run(geometry::SkinMethod method) {
        geometry::SkinJob skin = skin_job(method);
        skin.validate();
        skin.run();
        geometry::CarryCurvatureJob carry = carry_job(method);
        carry.validate();
        carry.run();
        normals_job.run();
        curvature_job.run();
    }

    void twist(geometry::SkinMethod method, int degrees) {
        rest.pose(0.0, std::numbers::pi * degrees / 180.0);
        run(method);
    }

    /// Both joints stretch alike.
    void stretch_all(geometry::SkinMethod method, const glm::dvec3& scale) {
        glm::dmat4 matrix(1.0);
        for (int i = 0; i < 3; ++i) matrix[i][i] = scale[i];
        for (std::size_t j = 0; j < 2; ++j) {
            rest.palette[j] = geometry::to_joint_matrix(matrix);
            rest.motions[j] = geometry::to_joint_motion(matrix);
        }
        run(method);
    }

    /// The largest distance to the axis of the rest pose on the ring between the bones.
    [[nodiscard]] double middle_radius() const {
        double radius = 0.0;
        for (std::size_t v = 0; v < positions.size(); ++v)
            if (std::abs(rest.height(v)) < 1e-9)
                radius = std::max(radius, std::hypot<double, double>(positions[v].x, positions[v].z));
        return radius;
    }

    [[nodiscard]] bool is_defined() const {
        const auto unit = [](const glm::vec3& n) { return std::abs(glm::length(n) - 1.0f) < 1e-5f; };
        for (std::size_t v = 0; v < positions.size(); ++v)
            if (!unit(blended[v]) || !unit(recomputed[v]) || !unit(carried_directions[v]) || !unit(directions[v]) ||
                !std::isfinite(positions[v].x + carried[v].x + carried[v].y + curvatures[v].x + curvatures[v].y))
                return false;
        return true;
    }

    /// Bends, runs all jobs, compares with the exact surface.
    [[nodiscard]] BentErrors errors(geometry::SkinMethod method, int degrees) {
        const BentCylinder exact_surface{method, std::numbers::pi * degrees / 180.0};
        rest.pose(exact_surface.angle);
        run(method);
        BentErrors sum{};
        double count = 0.0, with_directions = 0.0;
        for (std::size_t v = 0; v < positions.size(); ++v) {
            if (!rest.in_zone(v)) continue;
            const BentCylinder::Exact exact = exact_surface.exact(rest.longitude(v), rest.height(v));
            const auto cross = [&](const glm::vec3& direction) {
                return std::min(degrees_between(direction, exact.direction[0], true),
                                degrees_between(direction, exact.direction[1], true));
            };
            sum.blended_normals += std::pow(degrees_between(blended[v], exact.normal, false), 2);
            sum.recomputed_normals += std::pow(degrees_between(recomputed[v], exact.normal, false), 2);
            count += 1.0;
            if (std::abs(exact.k1 - exact.k2) < 0.1) continue;
            sum.carried_directions += std::pow(cross(carried_directions[v]), 2);
            sum.recomputed_directions += std::pow(cross(directions[v]), 2);
            with_directions += 1.0;
        }
        return {std::sqrt(sum.blended_normals / count), std::sqrt(sum.recomputed_normals / count),
                std::sqrt(sum.carried_directions / with_directions),
                std::sqrt(sum.recomputed_directions / with_directions)};
    }

    [[nodiscard]] static double degrees_between(const glm::vec3& a, const glm::dvec3& b, bool lines) {
        const glm::dvec3 wide = glm::normalize(glm::dvec3(a));
        const double cosine = lines ? std::abs(glm::dot(wide, b)) : glm::dot(wide, b);
        return std::atan2(glm::length(glm::cross(wide, b)), cosine) * 180.0 / std::numbers::pi;
    }
};

} // namespace hachure::test
