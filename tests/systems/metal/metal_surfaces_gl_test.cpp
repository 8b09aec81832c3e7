// What metal computes, and when; and that what moves a surface without changing it changes no picture.

#include <hachure/components/deformed.h>
#include <hachure/systems/metal/metal_frame.h>
#include <hachure/tests/support/gl_fixture.h>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "metal_scene.h"

namespace hachure::test {
namespace {

constexpr Canvas surface_canvas{128, 96};

using MetalSurfacesTest = GlTest;

constexpr MetalSource sources[] = {MetalSource::curvature, MetalSource::texture_u, MetalSource::texture_v,
                                   MetalSource::around_axis, MetalSource::along_axis};

SurfaceMesh torus_mesh() { return surface_mesh(geometry::torus(1.0, 0.4, 48, 24)); }

Transform slanted() { return {.rotation = glm::angleAxis(0.9f, glm::normalize(glm::vec3(1, 0.3f, 0.2f)))}; }

TEST_P(MetalSurfacesTest, EverySourceDrawsStripesOfItsOwn) {
    std::vector<assets::Image> pictures;
    for (const MetalSource source : sources) {
        MetalScene scene(context(), surface_canvas, torus_mesh(), {.source = source}, {1, 1, 1}, 1.8f, slanted());
        pictures.push_back(scene.draw());
        EXPECT_TRUE(all_finite(pictures.back()));
        for (std::size_t other = 0; other + 1 < pictures.size(); ++other)
            EXPECT_GT(changed_share(pictures[other], pictures.back(), 0.05), 0.05)
                << other << " " << pictures.size() - 1;
    }
}

TEST_P(MetalSurfacesTest, TheSeedDecides) {
    const auto draw = [&](std::uint32_t seed) {
        MetalScene scene(context(), surface_canvas, torus_mesh(), {.source = MetalSource::texture_v, .seed = seed},
                         {1, 1, 1}, 1.8f, slanted());
        return scene.draw();
    };
    const assets::Image one = draw(1);
    EXPECT_EQ(largest_change(one, draw(1)), 0.0);
    EXPECT_GT(changed_share(one, draw(2), 0.05), 0.1);
}

/// Nothing moves: no pass runs, nothing is computed. The light and the camera move: the pass runs, nothing is computed.
TEST_P(MetalSurfacesTest, NothingIsComputedAgainWithoutNeed) {
    for (const MetalSource source : sources) {
        SCOPED_TRACE(static_cast<int>(source));
        MetalScene scene(context(), surface_canvas, torus_mesh(), {.source = source}, {1, 1, 1});
        EXPECT_EQ(scene.scene.draw_passes().at("metal"), gpu::PassState::run);
        const std::uint64_t computed = scene.frame().surfaces.frames_computed();
        EXPECT_EQ(computed, source == MetalSource::around_axis ? 0u : 1u);
        EXPECT_EQ(scene.scene.draw_passes().at("metal"), gpu::PassState::reused);
        scene.turn_light({1, 0, 1});
        EXPECT_EQ(scene.scene.draw_passes().at("metal"), gpu::PassState::run);
        scene.scene.world().get_mutable<Transform>(scene.camera).translation.x += 0.1f;
        EXPECT_EQ(scene.scene.draw_passes().at("metal"), gpu::PassState::run);
        Transform& place = scene.scene.world().get_mutable<Transform>(scene.object);
        place.rotation = glm::angleAxis(1.0f, glm::normalize(glm::vec3(1, 2, 3)));
        place.scale = glm::vec3(1.1f);
        EXPECT_EQ(scene.scene.draw_passes().at("metal"), gpu::PassState::run);
        EXPECT_EQ(scene.frame().surfaces.frames_computed(), computed);
        EXPECT_LE(scene.frame().surfaces.layout_count(), 1u);
    }
}

TEST_P(MetalSurfacesTest, WhatIsNotDrawnAnyMoreIsForgotten) {
    MetalScene scene(context(), surface_canvas, torus_mesh(), {.source = MetalSource::texture_u}, {1, 1, 1}, 2.0f,
                     {.scale = {1, 2, 1}});
    const Entity other = scene.scene.add(torus_mesh());
    scene.scene.world().add(other, Metal{.source = MetalSource::texture_v});
    static_cast<void>(scene.draw());
    EXPECT_EQ(scene.frame().surfaces.layout_count(), 2u);
    EXPECT_EQ(scene.frame().surfaces.shape_count(), 2u);
    scene.scene.world().destroy(other);
    scene.scene.world().get_mutable<Metal>(scene.object).sets = 2.0f;
    static_cast<void>(scene.draw());
    EXPECT_EQ(scene.frame().surfaces.layout_count(), 1u);
    EXPECT_EQ(scene.frame().surfaces.shape_count(), 1u);
    scene.scene.world().remove<Metal>(scene.object);
    static_cast<void>(scene.draw());
    EXPECT_FALSE(scene.scene.draw_passes().contains("metal"));
}

/// A transform does what moving the vertices does: turned, mirrored and stretched.
TEST_P(MetalSurfacesTest, TransformsAreAsMovedVertices) {
    const glm::mat3 turn(glm::mat4_cast(slanted().rotation));
    const auto moved = [](const geometry::Shape& shape, const glm::mat3& matrix) {
        geometry::Shape result = shape;
        const glm::mat3 for_normals = glm::transpose(glm::inverse(matrix));
        for (glm::vec3& p : result.positions) p = matrix * p;
        for (glm::vec3& n : result.normals) n = glm::normalize(for_normals * n);
        if (glm::determinant(matrix) < 0.0f)
            for (std::size_t i = 0; i < result.indices.size(); i += 3)
                std::swap(result.indices[i], result.indices[i + 1]);
        return result;
    };
    const geometry::Shape torus = geometry::torus(1.0, 0.4, 192, 96);
    for (const glm::vec3& scale :
         {glm::vec3(1), glm::vec3(-1, 1, 1), glm::vec3(1.2f, 0.6f, 1), glm::vec3(0.7f, 1, -1.3f)})
        for (const MetalSource source : {MetalSource::texture_u, MetalSource::texture_v}) {
            SCOPED_TRACE(fmt::format("{} {} {} source {}", scale.x, scale.y, scale.z, static_cast<int>(source)));
            const Metal metal{.source = source};
            const glm::mat3 matrix = turn * glm::mat3(glm::scale(glm::mat4(1.0f), scale));
            MetalScene placed(context(), surface_canvas, surface_mesh(torus), metal, {1, 1, 1}, 2.0f,
                              {.rotation = slanted().rotation, .scale = scale});
            MetalScene baked(context(), surface_canvas, surface_mesh(moved(torus, matrix)), metal, {1, 1, 1});
            const assets::Image a = placed.draw(), b = baked.draw();
            EXPECT_LT(changed_share(a, b, 2.0 / 255.0), 0.002); // an outline's pixels may fall on either side
        }
}

/// Every coordinate moved to the float before or after it, or left; the same way for all vertices at one place.
geometry::Shape nudged(geometry::Shape shape, std::uint32_t seed) {
    for (glm::vec3& p : shape.positions) {
        p += 0.0f; // -0 is the place of 0
        std::seed_seq place{seed, std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                            std::bit_cast<std::uint32_t>(p.z)};
        std::minstd_rand random(place);
        for (int axis = 0; axis < 3; ++axis)
            if (const auto draw = random() % 3; draw != 1) p[axis] = std::nextafter(p[axis], draw == 0 ? -1e9f : 1e9f);
    }
    return shape;
}

/// Where every direction bends alike, or none bends at all, there is no direction of least curvature to find. The
/// result is stable: the last bits of the positions do not decide.
TEST_P(MetalSurfacesTest, SphereSquareAndCubeAreStable) {
    const std::pair<const char*, geometry::Shape> shapes[] = {{"uv sphere", geometry::uv_sphere(1.0, 48, 24)},
                                                              {"icosphere", geometry::icosphere(1.0, 4)},
                                                              {"square", geometry::plane(2.0, 8)},
                                                              {"cube", geometry::cube(1.6)}};
    for (const auto& [name, shape] : shapes) {
        SCOPED_TRACE(name);
        const auto draw = [&](const geometry::Shape& drawn) {
            MetalScene scene(context(), surface_canvas, surface_mesh(drawn), {}, {1, 1, 1}, 1.5f, slanted());
            return scene.draw();
        };
        const assets::Image exact = draw(shape);
        EXPECT_TRUE(all_finite(exact));
        for (std::uint32_t seed = 1; seed <= 3; ++seed) {
            const assets::Image moved = draw(nudged(shape, seed));
            EXPECT_LT(changed_share(exact, moved, 2.0 / 255.0), 0.003) << seed;
        }
    }
}

HACHURE_INSTANTIATE_GL_TESTS(MetalSurfacesTest);

} // namespace
} // namespace hachure::test
