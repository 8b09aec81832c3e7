#include <hachure/runtime/geometry/skin_palette.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "skin_reference.h"

namespace hachure::geometry {
namespace {

glm::dmat3 rotation(const JointMotion& m) { return glm::mat3_cast(glm::dquat(m.real.w, m.real.x, m.real.y, m.real.z)); }

glm::dmat3 stretch(const JointMotion& m) {
    const glm::dvec4 d(m.stretch0), o(m.stretch1);
    return {d.x, o.x, o.y, o.x, d.y, o.z, o.y, o.z, d.z};
}

/// The largest difference between rotation * stretch and the matrix.
double decomposition_error(const glm::dmat4& matrix) {
    const JointMotion m = to_joint_motion(matrix);
    EXPECT_NEAR(glm::length(m.real), 1.0f, 1e-6f);
    const glm::dmat3 product = rotation(m) * stretch(m);
    double error = 0.0;
    for (int c = 0; c < 3; ++c) error = std::max(error, glm::distance(product[c], glm::dvec3(matrix[c])));
    return error;
}

TEST(SkinPalette, MotionsAreTheMatrixAgain) {
    std::mt19937 random(1);
    const glm::dvec3 scales[] = {{1, 1, 1},    {2, 2, 2},   {1, 2, 3}, {-1, 1, 1},  {-1, -1, -1},
                                 {-2, 3, 0.5}, {1, 1, 0},   {1, 0, 0}, {0, 0, 0},   {-1, 1, 0},
                                 {1, 1, 1e-9}, {-1, -1, 1}, {1, 1, 2}, {1e-6, 1, 1}};
    for (const glm::dvec3& scale : scales)
        for (int i = 0; i < 20; ++i) {
            const glm::dmat4 a = reference::random_rigid(random), b = reference::random_rigid(random);
            EXPECT_LT(decomposition_error(glm::scale(a, scale)), 2e-6);
            EXPECT_LT(decomposition_error(glm::scale(a, scale) * b), 2e-6); // stretched along other axes
        }
}

TEST(SkinPalette, MirroredSkeletonsTurnAsOne) {
    // A whole character mirrored: each joint's rotation must be the one of the rest, or blending would tear it.
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1));
    const JointMotion a = to_joint_motion(mirror);
    const JointMotion b = to_joint_motion(mirror * glm::rotate(glm::dmat4(1.0), 0.1, glm::dvec3(0, 0, 1)));
    EXPECT_GT(std::abs(glm::dot(a.real, b.real)), 0.99f);
    EXPECT_NEAR(a.stretch0.x, -1.0f, 1e-6f);
    EXPECT_NEAR(b.stretch0.y, -1.0f, 1e-6f);
}

TEST(SkinPalette, IsWorldTimesInverseBindInDouble) {
    // A character a million metres away, seen from its own node: float products would be off by centimetres.
    const glm::dmat4 node = glm::translate(glm::dmat4(1.0), glm::dvec3(1e6, 0, -1e6));
    const glm::dmat4 joint = node * glm::translate(glm::dmat4(1.0), glm::dvec3(0.125, 1.5, 0));
    const glm::mat4 inverse_bind = glm::translate(glm::mat4(1.0f), glm::vec3(0, -1.5f, 0));
    std::vector<JointMatrix> palette(2);
    std::vector<JointMotion> motions(2);
    SkinPaletteJob job{.joints_double = {&joint, 1},
                       .inverse_bind = {&inverse_bind, 1},
                       .to_out = glm::inverse(node),
                       .palette = palette,
                       .motions = motions};
    job.validate();
    job.run();
    EXPECT_NEAR(palette[0].row[0].w, 0.125f, 1e-7f);
    EXPECT_NEAR(palette[0].row[1].w, 0.0f, 1e-7f);
    EXPECT_NEAR(motions[0].dual.x, 0.0625f, 1e-7f);
    EXPECT_EQ(palette[1].row[1], glm::vec4(0, 1, 0, 0)); // what follows no joint
    EXPECT_EQ(job.repaired, 0u);
}

TEST(SkinPalette, JointsThatAreNoNumbersStayAtRest) {
    std::vector<glm::mat4> joints(3, glm::mat4(1.0f));
    joints[0][3][1] = std::numeric_limits<float>::quiet_NaN();
    joints[2][0][0] = std::numeric_limits<float>::max();
    std::vector<JointMatrix> palette(4);
    SkinPaletteJob job{.joints = joints, .palette = palette};
    job.validate();
    job.run();
    EXPECT_EQ(job.repaired, 2u);
    EXPECT_EQ(palette[0].row[1], glm::vec4(0, 1, 0, 0));
    EXPECT_EQ(palette[2].row[0], glm::vec4(1, 0, 0, 0));
    job.joints = job.joints.first(2);
    EXPECT_DEATH(job.validate(), "one entry more");
}

} // namespace
} // namespace hachure::geometry
