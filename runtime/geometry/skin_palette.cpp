#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/skin_palette.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hachure::geometry {
namespace {

/// Squares and products of elements below this stay finite in float.
constexpr double largest_element = 1e15;

bool is_usable(const glm::dmat4& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!(std::abs(m[c][r]) <= largest_element)) return false; // NaN, too
    return true;
}

/// Turns columns p and q of `a` so that they are perpendicular (one-sided Jacobi), and those of `v` alike.
bool make_perpendicular(glm::dmat3& a, glm::dmat3& v, int p, int q) {
    const double alpha = glm::dot(a[p], a[p]), beta = glm::dot(a[q], a[q]), gamma = glm::dot(a[p], a[q]);
    if (!(std::abs(gamma) > 1e-15 * std::sqrt(alpha * beta))) return false;
    const double zeta = (beta - alpha) / (2.0 * gamma);
    const double t = std::copysign(1.0, zeta) / (std::abs(zeta) + std::sqrt(1.0 + zeta * zeta));
    const double c = 1.0 / std::sqrt(1.0 + t * t), s = c * t;
    for (glm::dmat3* m : {&a, &v}) {
        const glm::dvec3 old = (*m)[p];
        (*m)[p] = c * old - s * (*m)[q];
        (*m)[q] = s * old + c * (*m)[q];
    }
    return true;
}

glm::dvec3 any_perpendicular(const glm::dvec3& unit) {
    const glm::dvec3 axis = std::abs(unit.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(unit, axis));
}

/// The rotation in the polar decomposition m = rotation * stretch; where m mirrors, stretch is negative definite.
/// Directions that m flattens take whatever completes a rotation.
glm::dmat3 polar_rotation(const glm::dmat3& m) {
    glm::dmat3 u = m, v(1.0); // u = m v has perpendicular columns after the sweeps
    for (int sweep = 0; sweep < 30; ++sweep) {
        const bool a = make_perpendicular(u, v, 0, 1), b = make_perpendicular(u, v, 0, 2);
        if (!make_perpendicular(u, v, 1, 2) && !a && !b) break;
    }
    std::array<int, 3> order{0, 1, 2};
    std::array<double, 3> length{};
    for (int i = 0; i < 3; ++i) length[static_cast<std::size_t>(i)] = glm::length(u[i]);
    std::ranges::sort(order, std::ranges::greater{}, [&](int i) { return length[static_cast<std::size_t>(i)]; });
    const auto [x, y, z] = order;
    const double least = 1e-12 * length[static_cast<std::size_t>(x)];
    if (!(length[static_cast<std::size_t>(x)] > 0.0)) return glm::dmat3(1.0);
    const bool mirrors = glm::determinant(m) < 0.0 && length[static_cast<std::size_t>(z)] > least;
    if (mirrors) u = -u;
    u[x] /= length[static_cast<std::size_t>(x)];
    u[y] = length[static_cast<std::size_t>(y)] > least ? glm::normalize(u[y]) : any_perpendicular(u[x]);
    // v is a rotation, so columns x, y, z of both have one handedness.
    u[z] = glm::cross(u[x], u[y]) * glm::dot(glm::cross(v[x], v[y]), v[z]);
    return u * glm::transpose(v);
}

/// The inputs' matrix of one joint.
glm::dmat4 joint_world(const SkinPaletteJob& job, std::size_t joint) {
    return job.joints_double.empty() ? glm::dmat4(job.joints[joint]) : job.joints_double[joint];
}

} // namespace

JointMatrix to_joint_matrix(const glm::dmat4& matrix) {
    JointMatrix result;
    if (!is_usable(matrix)) return result;
    for (int r = 0; r < 3; ++r) result.row[r] = {matrix[0][r], matrix[1][r], matrix[2][r], matrix[3][r]};
    return result;
}

JointMotion to_joint_motion(const glm::dmat4& matrix) {
    JointMotion result;
    if (!is_usable(matrix)) return result;
    const glm::dmat3 linear(matrix), rotation = polar_rotation(linear);
    const glm::dmat3 stretch = glm::transpose(rotation) * linear;
    const glm::dquat real = glm::normalize(glm::dquat(rotation));
    const glm::dquat dual = 0.5 * (glm::dquat(0.0, glm::dvec3(matrix[3])) * real);
    result.real = {real.x, real.y, real.z, real.w};
    result.dual = {dual.x, dual.y, dual.z, dual.w};
    result.stretch0 = {stretch[0][0], stretch[1][1], stretch[2][2], 0.0};
    result.stretch1 = {0.5 * (stretch[0][1] + stretch[1][0]), 0.5 * (stretch[0][2] + stretch[2][0]),
                       0.5 * (stretch[1][2] + stretch[2][1]), 0.0};
    return result;
}

void SkinPaletteJob::validate() const {
    const std::size_t count = std::max(joints.size(), joints_double.size());
    HACHURE_ASSERT(joints.empty() || joints_double.empty(), "joints are given in float or in double, not both");
    HACHURE_ASSERT(inverse_bind.empty() || inverse_bind.size() == count, "one inverse bind matrix per joint");
    HACHURE_ASSERT(palette.empty() || palette.size() == count + 1, "a palette has one entry more than joints");
    HACHURE_ASSERT(motions.empty() || motions.size() == count + 1, "a palette has one entry more than joints");
}

void SkinPaletteJob::run() {
    const std::size_t count = std::max(joints.size(), joints_double.size());
    repaired = 0;
    for (std::size_t j = 0; j <= count; ++j) {
        glm::dmat4 matrix = unweighted;
        if (j < count) {
            matrix = to_out * joint_world(*this, j);
            if (!inverse_bind.empty()) matrix = matrix * glm::dmat4(inverse_bind[j]);
            repaired += !is_usable(matrix);
        }
        if (!palette.empty()) palette[j] = to_joint_matrix(matrix);
        if (!motions.empty()) motions[j] = to_joint_motion(matrix);
    }
}

} // namespace hachure::geometry
