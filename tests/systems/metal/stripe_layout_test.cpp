#include <hachure/systems/metal/stretch.h>
#include <hachure/systems/metal/stripe_layout.h>
#include <hachure/tests/support/drawn_scene.h>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace hachure::test {
namespace {

void expect_sound(const SurfaceMesh& mesh, const geometry::StripeMesh& stripes) {
    const std::size_t count = stripes.source_vertex.size();
    ASSERT_EQ(stripes.coordinate.size(), count);
    ASSERT_EQ(stripes.weight.size(), count);
    ASSERT_EQ(stripes.indices.size(), mesh.indices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        EXPECT_EQ(stripes.source_vertex.at(stripes.indices[i]), mesh.indices[i]);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) EXPECT_EQ(stripes.source_vertex[v], v);
}

TEST(StripeLayoutTest, TextureCoordinatesAreTakenAsTheyAre) {
    const SurfaceMesh mesh = surface_mesh(geometry::torus(1.0, 0.3, 16, 8));
    for (const auto& [source, component] :
         {std::pair{MetalSource::texture_u, 0}, std::pair{MetalSource::texture_v, 1}}) {
        const geometry::StripeMesh stripes = lay_stripes(mesh, {.source = source, .sets = 3});
        expect_sound(mesh, stripes);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            EXPECT_EQ(stripes.coordinate[v], 3.0f * mesh.texcoords[v][component]);
    }
}

TEST(StripeLayoutTest, AlongTheAxisFromEndToEnd) {
    const SurfaceMesh mesh = surface_mesh(geometry::cone(1.0, 2.0, 16));
    const geometry::StripeMesh stripes = lay_stripes(mesh, {.source = MetalSource::along_axis, .sets = 2});
    expect_sound(mesh, stripes);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        EXPECT_NEAR(stripes.coordinate[v], mesh.positions[v].y + 1.0f, 1e-5f);
}

/// Every triangle spans the angle that its corners are apart, whichever side of the start they lie.
TEST(StripeLayoutTest, AroundTheAxisTrianglesAreWhole) {
    const SurfaceMesh mesh = surface_mesh(geometry::icosphere(1.0, 3));
    const geometry::StripeMesh stripes = lay_stripes(mesh, {.source = MetalSource::around_axis, .sets = 4.4f});
    expect_sound(mesh, stripes);
    EXPECT_GT(stripes.source_vertex.size(), mesh.positions.size());
    for (std::size_t first = 0; first < stripes.indices.size(); first += 3)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t v = stripes.indices[first + c], w = stripes.indices[first + (c + 1) % 3];
            EXPECT_LE(std::abs(stripes.coordinate[v] - stripes.coordinate[w]), 2.0f);
            const glm::vec3 p = mesh.positions[stripes.source_vertex[v]];
            if (std::hypot(p.x, p.z) < 1e-3f) continue;
            const double turns = std::atan2(-double(p.z), double(p.x)) / 6.283185307179586;
            EXPECT_NEAR(std::remainder(double(stripes.coordinate[v]) - 4.0 * turns, 4.0), 0.0, 1e-4);
        }
}

TEST(StripeLayoutTest, WithoutTextureCoordinatesByCurvature) {
    SurfaceMesh mesh = surface_mesh(geometry::torus(1.0, 0.3, 16, 8));
    EXPECT_EQ(stripe_source(mesh, {.source = MetalSource::texture_v}), MetalSource::texture_v);
    mesh.texcoords.clear();
    EXPECT_EQ(stripe_source(mesh, {.source = MetalSource::texture_v}), MetalSource::curvature);
    EXPECT_EQ(stripe_source(mesh, {.source = MetalSource::along_axis}), MetalSource::along_axis);
}

TEST(StripeLayoutTest, KeysTellLayoutsApartAndNothingElse) {
    const SurfaceMesh mesh = surface_mesh(geometry::torus(1.0, 0.3, 16, 8));
    const auto key = [&](const Metal& metal, std::uint32_t index = 0) { return stripe_layout_key(index, mesh, metal); };
    const Metal plain;
    EXPECT_EQ(key(plain), key({.count = 7, .seed = 5, .low = 0.3f, .light_stripe = 0.1f, .axis = {1, 0, 0}}));
    const std::set<std::uint64_t> keys = {key(plain),
                                          key(plain, 1),
                                          key({.sets = 2}),
                                          key({.detail = 0.3f}),
                                          key({.crease_angle = 1.0f}),
                                          key({.source = MetalSource::texture_u}),
                                          key({.source = MetalSource::along_axis}),
                                          key({.source = MetalSource::along_axis, .axis = {1, 0, 0}}),
                                          key({.source = MetalSource::along_axis, .axis_offset = {1, 0, 0}})};
    EXPECT_EQ(keys.size(), 9u);
}

TEST(StripeLayoutTest, TheAxisIsARotationWhateverItIs) {
    const SurfaceMesh mesh = surface_mesh(geometry::torus(1.0, 0.3, 16, 8));
    for (const glm::vec3& axis : {glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0, 0, -3), glm::vec3(0),
                                  glm::vec3(1, 1, 1), glm::vec3(1e-3f, 0, 1)}) {
        const glm::mat3 m = stripe_axis(mesh, {.axis = axis}).axis_from_entity;
        EXPECT_NEAR(glm::determinant(m), 1.0f, 1e-5f);
        const glm::vec3 expected = glm::length(axis) > 0.0f ? glm::normalize(axis) : glm::vec3(0, 1, 0);
        EXPECT_NEAR(glm::length(m * expected - glm::vec3(0, 0, 1)), 0.0f, 1e-5f);
    }
}

/// scale * rotation * S is the transform: S^T S has its angles and lengths, and rotations leave it as it is.
TEST(StretchTest, IsWhatATransformDoesToAngles) {
    const glm::mat3 turn = glm::mat3_cast(glm::angleAxis(0.7f, glm::normalize(glm::vec3(1, 2, 3))));
    EXPECT_EQ(stretch_of(turn), glm::mat3(1.0f));
    EXPECT_EQ(stretch_of(-2.5f * turn), glm::mat3(1.0f));
    EXPECT_EQ(stretch_of(glm::mat3(0.0f)), glm::mat3(1.0f));
    EXPECT_EQ(stretch_of(glm::mat3(1, 0, 0, 0, 0, 0, 0, 0, 1)), glm::mat3(1.0f));
    const glm::mat3 sheared = glm::mat3(2, 0, 0, 0.5f, 1, 0, 0, 0.3f, -1.5f);
    const glm::mat3 s = stretch_of(sheared);
    EXPECT_TRUE(same_stretch(s, stretch_of(turn * sheared)));
    EXPECT_FALSE(same_stretch(s, stretch_of(sheared * turn)));
    const glm::mat3 rest = sheared * glm::inverse(s), unit = glm::transpose(rest) * rest;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            EXPECT_NEAR(unit[column][row] / unit[0][0], column == row ? 1.0f : 0.0f, 1e-5f);
}

} // namespace
} // namespace hachure::test
