#include <hachure/systems/shade_strokes/shade_density.h>
#include <hachure/tests/support/shade_rig.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace hachure::test {
namespace {

/// A square of side 1 in the plane z = 0, of 20 x 20 vertices; texture coordinates are x and 1 - y.
SurfaceMesh square() {
    constexpr std::uint32_t n = 20;
    SurfaceMesh mesh;
    for (std::uint32_t i = 0; i < n * n; ++i) {
        const glm::vec2 p = glm::vec2(i % n, i / n) / float(n - 1);
        mesh.positions.emplace_back(p, 0.0f);
        mesh.texcoords.emplace_back(p.x, 1.0f - p.y);
    }
    for (std::uint32_t y = 0; y + 1 < n; ++y)
        for (std::uint32_t x = 0; x + 1 < n; ++x) {
            const std::uint32_t a = y * n + x;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + n, a + n, a + 1, a + n + 1});
        }
    return mesh;
}

class ShadeDensityTest : public ::testing::Test {
protected:
    /// The middle of a cell's area, from its atoms.
    [[nodiscard]] glm::dvec3 middle(std::uint32_t cell) const {
        glm::dvec3 sum(0.0);
        double area = 0.0;
        for (std::uint32_t m = mesh.cells.first_member[cell]; m < mesh.cells.first_member[cell + 1]; ++m) {
            const std::uint32_t atom = mesh.cells.members[m], triangle = mesh.cells.triangle_of(atom);
            std::array<glm::dvec3, 3> at;
            const auto corners = mesh.cells.atom_corners(triangle, atom);
            for (std::size_t k = 0; k < 3; ++k) at[k] = mesh.at(mesh.point(triangle, corners[k]));
            const double part = 0.5 * glm::length(glm::cross(at[1] - at[0], at[2] - at[0]));
            sum += part * (at[0] + at[1] + at[2]) / 3.0;
            area += part;
        }
        return sum / area;
    }

    SurfaceMesh surface = square();
    ShadeMesh mesh = make_shade_mesh({.positions = surface.positions, .indices = surface.indices, .cells = 100});
    std::vector<float> density;
};

/// The mean of a linear function over a cell is its value in the middle.
TEST_F(ShadeDensityTest, PaintIsTheMeanOverACell) {
    for (const glm::vec3& p : surface.positions) surface.colors.emplace_back(p.x, p.y, 0.25f, 1.0f - p.x);
    density_by_paint(mesh, surface, ShadePaintChannel::red, density);
    ASSERT_EQ(density.size(), mesh.cell_count());
    for (std::uint32_t c = 0; c < density.size(); ++c) EXPECT_NEAR(density[c], middle(c).x, 0.012) << c;
    density_by_paint(mesh, surface, ShadePaintChannel::green, density);
    for (std::uint32_t c = 0; c < density.size(); ++c) EXPECT_NEAR(density[c], middle(c).y, 0.012) << c;
    density_by_paint(mesh, surface, ShadePaintChannel::blue, density);
    for (const float value : density) EXPECT_NEAR(value, 0.25f, 1e-6f);
    density_by_paint(mesh, surface, ShadePaintChannel::alpha, density);
    for (std::uint32_t c = 0; c < density.size(); ++c) EXPECT_NEAR(density[c], 1.0 - middle(c).x, 0.012) << c;
}

TEST_F(ShadeDensityTest, WithoutColoursOrCoordinatesThereIsAllOfTheShade) {
    density_by_paint(mesh, surface, ShadePaintChannel::red, density);
    for (const float value : density) EXPECT_EQ(value, 1.0f);
    surface.texcoords.clear();
    density_by_picture(mesh, surface, assets::make_image(1, 1, 3, assets::PixelType::u8), density);
    for (const float value : density) EXPECT_EQ(value, 1.0f);
}

TEST_F(ShadeDensityTest, ValuesThatAreNoNumbersPaintNothing) {
    surface.colors.assign(surface.positions.size(), glm::vec4(std::numeric_limits<float>::quiet_NaN()));
    density_by_paint(mesh, surface, ShadePaintChannel::red, density);
    for (const float value : density) EXPECT_EQ(value, 1.0f);
    for (glm::vec2& texcoord : surface.texcoords) texcoord.x = std::numeric_limits<float>::infinity();
    density_by_picture(mesh, surface, assets::make_image(4, 4, 1, assets::PixelType::u8), density);
    for (const float value : density) EXPECT_EQ(value, 1.0f);
}

/// The upper half of the picture is black, the lower left quarter grey, the lower right white: rows go down.
TEST_F(ShadeDensityTest, APictureLiesAsItsCoordinatesSay) {
    for (const assets::PixelType type : {assets::PixelType::u8, assets::PixelType::f32}) {
        constexpr int size = 64;
        assets::Image picture = assets::make_image(size, size, 4, type);
        for (int i = 0; i < size * size; ++i) {
            const float value = i / size < size / 2 ? 0.0f : i % size < size / 2 ? 0.4f : 1.0f;
            for (int channel = 0; channel < 3; ++channel) {
                if (type == assets::PixelType::u8)
                    picture.u8()[4 * i + channel] = static_cast<std::uint8_t>(std::lround(255.0f * value));
                else
                    picture.f32()[4 * i + channel] = value;
            }
        }
        density_by_picture(mesh, surface, picture, density);
        int looked_at = 0;
        for (std::uint32_t c = 0; c < density.size(); ++c) {
            const glm::dvec3 at = middle(c);
            const glm::dvec2 off = glm::abs(glm::dvec2(at) - 0.5); // from where values meet
            if (std::min(off.x, off.y) < 0.12 || std::max(off.x, off.y) > 0.4) continue;
            EXPECT_NEAR(density[c], at.y > 0.5 ? 0.0 : at.x < 0.5 ? 0.4 : 1.0, 2e-3) << at.x << " " << at.y;
            ++looked_at;
        }
        EXPECT_GT(looked_at, 20);
    }
}

TEST(PlacedVolumeTest, FactorsAreThoseOfTheirShapes) {
    PlacedVolume placed{{.inside = 0.2f, .outside = 0.8f, .falloff = 0.5f}};
    EXPECT_FLOAT_EQ(placed.factor({0, 0, 0}), 0.2f);
    EXPECT_FLOAT_EQ(placed.factor({0, 0.5f, 0}), 0.2f);
    EXPECT_FLOAT_EQ(placed.factor({0, 0, 0.75f}), 0.5f) << "smoothstep is a half in the middle of the way";
    EXPECT_FLOAT_EQ(placed.factor({1, 0, 0}), 0.8f);
    EXPECT_FLOAT_EQ(placed.factor({0.8f, 0.8f, 0}), 0.8f);
    placed.volume.shape = ShadeVolumeShape::box;
    EXPECT_FLOAT_EQ(placed.factor({0.75f, 0.75f, -0.75f}), 0.5f);
    EXPECT_FLOAT_EQ(placed.factor({0, -1, 0}), 0.8f);
    placed.volume.falloff = 0.0f;
    EXPECT_FLOAT_EQ(placed.factor({0.99f, 0.99f, 0.99f}), 0.2f);
    EXPECT_FLOAT_EQ(placed.factor({1.01f, 0, 0}), 0.8f);
}

TEST_F(ShadeDensityTest, VolumesStandInTheWorldAndAreMultiplied) {
    const glm::mat4 world_from_mesh = glm::translate(glm::mat4(1.0f), {10, 0, 0});
    const auto box = [](const glm::vec3& at, const glm::vec3& half, float inside) {
        const glm::mat4 place = glm::scale(glm::translate(glm::mat4(1.0f), at), half);
        return PlacedVolume{{.shape = ShadeVolumeShape::box, .inside = inside, .falloff = 0.0f}, glm::inverse(place)};
    };
    // The left half, and the lower half.
    const std::vector<PlacedVolume> volumes{box({10, 0, 0}, {0.5f, 5, 1}, 0.5f), box({10, 0, 0}, {5, 0.5f, 1}, 0.4f)};
    density_by_volumes(mesh, surface.positions, surface.indices, world_from_mesh, volumes, density);
    for (std::uint32_t c = 0; c < density.size(); ++c) {
        const glm::dvec3 at = middle(c);
        if (std::min(std::abs(at.x - 0.5), std::abs(at.y - 0.5)) < 0.12) continue;
        EXPECT_NEAR(density[c], (at.x < 0.5 ? 0.5 : 1.0) * (at.y < 0.5 ? 0.4 : 1.0), 1e-5) << at.x << " " << at.y;
    }
}

} // namespace
} // namespace hachure::test
