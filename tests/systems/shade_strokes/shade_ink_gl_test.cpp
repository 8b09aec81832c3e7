// Pictures are as dark as the light asks for, everywhere and whatever triangles a surface is made of.

#include <hachure/components/light.h>
#include <hachure/components/shade_strokes.h>
#include <hachure/systems/shade_strokes/shade_draw.h>
#include <hachure/tests/support/divided_mesh.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/shade_rig.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <vector>

namespace hachure::test {
namespace {

constexpr int ink_side = 320; // pixels of a picture
constexpr int ink_tiles = 8;  // along its side
const std::array ink_suns{glm::vec3{0.6f, 0.7f, 0.5f}, glm::vec3{-0.8f, 0.3f, 0.4f}, glm::vec3{0.1f, -0.9f, 0.3f}};

/// What a mesh looks like under each of the suns, from one place.
struct InkPictures {
    std::vector<bool> seen; ///< pixels of the surface
    std::array<assets::Image, ink_suns.size()> needed, coverage;
};

InkPictures draw_ink(gpu::Context& context, const geometry::Shape& shape) {
    DrawnScene scene(context, {ink_side, ink_side});
    const Entity surface = scene.add(surface_mesh(shape));
    scene.world().add(surface, ShadeStrokes{});
    scene.add(Camera{.yfov = 0.5f}, {.translation = {0, 0, 4.6f}});
    const Entity sun = scene.world().create_with(Transform{}, Light{});
    for (const char* aov : {"shade_needed", "stroke_coverage", "object_id"}) scene.renderer().request_aov(aov);
    InkPictures pictures;
    for (std::size_t i = 0; i < ink_suns.size(); ++i) {
        scene.world().get_mutable<Transform>(sun).rotation =
            glm::quatLookAt(-glm::normalize(ink_suns[i]), glm::vec3(0.1f, 1.0f, 0.05f));
        scene.renderer().render_frame();
        pictures.needed[i] = scene.renderer().read_aov("shade_needed");
        pictures.coverage[i] = scene.renderer().read_aov("stroke_coverage");
    }
    const assets::Image id = scene.renderer().read_aov("object_id");
    for (int i = 0; i < ink_side * ink_side; ++i) pictures.seen.push_back(id.f32()[i] != 0.0f);
    return pictures;
}

/// Sums over some pixels and suns.
struct Ink {
    double needed = 0.0, coverage = 0.0, pixels = 0.0;

    void add(const InkPictures& pictures, std::size_t sun, int pixel) {
        needed += double(pictures.needed[sun].f32()[pixel]);
        coverage += double(pictures.coverage[sun].f32()[pixel]);
        pixels += 1.0;
    }
    [[nodiscard]] double mean() const { return coverage / pixels; }
    /// The mean that the need asks for: full shade is that dark, less shade is less so in proportion.
    [[nodiscard]] double wanted() const { return double{full_darkness} * ShadeStrokes{}.opacity * needed / pixels; }
};

/// Ink by tile, over all suns, and by sun, over all tiles.
struct InkSums {
    std::array<Ink, ink_tiles * ink_tiles> tiles;
    std::array<Ink, ink_suns.size()> suns;
};

InkSums sum_ink(const InkPictures& pictures, const std::vector<int>& pixels) {
    constexpr int tile_side = ink_side / ink_tiles;
    InkSums sums;
    for (std::size_t sun = 0; sun < ink_suns.size(); ++sun)
        for (const int i : pixels) {
            const int tile = i / ink_side / tile_side * ink_tiles + i % ink_side / tile_side;
            sums.tiles[static_cast<std::size_t>(tile)].add(pictures, sun, i);
            sums.suns[sun].add(pictures, sun, i);
        }
    return sums;
}

std::vector<int> common_pixels(const std::vector<InkPictures>& meshes) {
    std::vector<int> pixels;
    for (int i = 0; i < ink_side * ink_side; ++i) {
        const auto sees = [i](const InkPictures& mesh) { return mesh.seen[static_cast<std::size_t>(i)]; };
        if (std::ranges::all_of(meshes, sees)) pixels.push_back(i);
    }
    return pixels;
}

/// Meshes of one surface are, where all of them are seen, as dark as the light asks for: the whole in each light, and
/// every tile that they fill. A tile of some fifty strokes is off by 4 % RMS, by which strokes happen to lie in it.
void expect_same_ink(const std::vector<InkPictures>& meshes) {
    const std::vector<int> pixels = common_pixels(meshes);
    constexpr double in_a_tile = double{ink_side} * ink_side / (ink_tiles * ink_tiles);
    const InkSums first = sum_ink(meshes[0], pixels);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const InkSums sums = sum_ink(meshes[m], pixels);
        for (std::size_t sun = 0; sun < ink_suns.size(); ++sun) {
            const Ink& ink = sums.suns[sun];
            EXPECT_NEAR(ink.mean(), ink.wanted(), 0.06 * ink.wanted()) << "mesh " << m << ", sun " << sun;
            EXPECT_NEAR(ink.mean(), first.suns[sun].mean(), 0.06 * ink.mean()) << "mesh " << m << ", sun " << sun;
        }
        int filled = 0;
        for (std::size_t t = 0; t < sums.tiles.size(); ++t) {
            const Ink& ink = sums.tiles[t];
            if (ink.pixels < in_a_tile * double{ink_suns.size()}) continue;
            EXPECT_NEAR(ink.mean(), ink.wanted(), 0.15 * ink.wanted()) << "mesh " << m << ", tile " << t;
            ++filled;
        }
        EXPECT_GE(filled, 8);
    }
}

using ShadeInkGlTest = GlTest;

/// The same surface of 1, 4 and 64 times as many triangles, no two of them alike.
TEST_P(ShadeInkGlTest, SubdivisionChangesNoPicture) {
    geometry::Shape coarse = geometry::irregular_torus(0.7, 0.35, 36, 18, 0.3, 5);
    const glm::quat towards_eye = glm::angleAxis(0.9f, glm::normalize(glm::vec3(1.0f, 0.3f, 0.2f)));
    for (glm::vec3& p : coarse.positions) p = towards_eye * p;
    for (glm::vec3& n : coarse.normals) n = towards_eye * n;
    std::vector<InkPictures> meshes;
    for (const int times : {0, 1, 3}) meshes.push_back(draw_ink(context(), subdivided(coarse, times)));
    expect_same_ink(meshes);
}

/// The bunny as it is and decimated, each mesh with its own normals.
TEST_P(ShadeInkGlTest, DecimationChangesLittleOfThePicture) {
    if (!std::filesystem::exists(bunny_file)) GTEST_SKIP() << "the bunny is not there";
    const geometry::Shape bunny = shape_of_file(bunny_file);
    std::vector<InkPictures> meshes;
    for (const std::size_t triangles : {70000u, 17000u, 5000u})
        meshes.push_back(draw_ink(context(), decimated(bunny, triangles)));
    expect_same_ink(meshes);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(ShadeInkGlTest);

} // namespace
} // namespace hachure::test
