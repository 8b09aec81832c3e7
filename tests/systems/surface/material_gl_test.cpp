#include <hachure/components/gooch.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <cmath>

namespace hachure::test {
namespace {

// The square [-1, 1]^2 fills the picture; 60 is a multiple of 4 texels with an odd quotient, so that the centre of
// every texel is the centre of a pixel.
constexpr int material_side = 60;

SurfaceMesh square(const SurfaceMaterial& material) {
    SurfaceMesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.submeshes = {{0, 6, material}};
    return mesh;
}

/// Draws the mesh without a style, from straight ahead, and returns its linear colours.
assets::Image draw(gpu::Context& context, SurfaceMesh mesh, const std::vector<SurfaceTexture>& textures = {},
                   glm::vec3 tint = glm::vec3(1.0f)) {
    DrawnScene scene(context, {material_side, material_side});
    for (const SurfaceTexture& texture : textures)
        static_cast<void>(scene.world().resource_mutable<MeshStore>().add(texture));
    scene.world().get_mutable<Surface>(scene.add(std::move(mesh))).tint = tint;
    scene.add(Camera{.projection = Projection::orthographic, .ymag = 1.0f, .zfar = 10.0f}, {.translation = {0, 0, 2}});
    scene.renderer().request_aov("color");
    scene.renderer().render_frame();
    return scene.renderer().read_aov("color");
}

glm::vec3 at(const assets::Image& image, int column, int row) {
    const float* p = image.f32() + 3 * (row * material_side + column);
    return {p[0], p[1], p[2]};
}

/// Drivers decode sRGB textures with some bits less than a float has.
constexpr double decoding_tolerance = 2e-3;

double linear(std::uint8_t encoded) {
    const double s = encoded / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// 4x4 texels, all different.
SurfaceTexture texture(int channels, assets::Filter magnify) {
    SurfaceTexture result;
    result.image = assets::make_image(4, 4, channels, assets::PixelType::u8);
    for (int i = 0; i < 16 * channels; ++i) result.image.u8()[i] = static_cast<std::uint8_t>((i * 89 + 31) % 256);
    result.magnify = magnify;
    return result;
}

using MaterialTest = GlTest;

TEST_P(MaterialTest, TexelCentresAreExactForEveryChannelCountAndFilter) {
    for (const int channels : {1, 2, 3, 4})
        for (const assets::Filter magnify : {assets::Filter::nearest, assets::Filter::linear}) {
            SCOPED_TRACE(std::to_string(channels) + " channels");
            const SurfaceTexture source = texture(channels, magnify);
            SurfaceMaterial material;
            material.base_color = {0.9f, 0.8f, 0.7f, 1.0f};
            material.base_color_texture = 0;
            const glm::vec3 tint(0.5f, 1.0f, 0.75f);
            const assets::Image image = draw(context(), square(material), {source}, tint);
            for (int texel = 0; texel < 16; ++texel)
                for (int c = 0; c < 3; ++c) {
                    const int channel = channels >= 3 ? c : 0;
                    const double expected = linear(source.image.u8()[texel * channels + channel]) *
                                            double(tint[c] * material.base_color[c]);
                    EXPECT_NEAR(at(image, texel % 4 * 15 + 7, texel / 4 * 15 + 7)[c], expected, decoding_tolerance)
                        << "texel " << texel << " channel " << c;
                }
        }
}

/// KHR_texture_transform: scale first, then a turn that is counter-clockwise where v points down, then the offset.
TEST_P(MaterialTest, TextureCoordinatesAreTransformedAsGltfSays) {
    const SurfaceTexture source = texture(3, assets::Filter::nearest);
    SurfaceMaterial material;
    material.base_color_texture = 0;
    material.uv_offset = {0.1f, 0.3f};
    material.uv_scale = {2.0f, 0.5f};
    material.uv_rotation = 0.5f;
    const assets::Image image = draw(context(), square(material), {source});
    int checked = 0;
    for (int row = 0; row < material_side; ++row)
        for (int column = 0; column < material_side; ++column) {
            const double u = 2.0 * (column + 0.5) / material_side, v = 0.5 * (row + 0.5) / material_side;
            const double c = std::cos(0.5), s = std::sin(0.5);
            const double x = 4.0 * (0.1 + c * u + s * v), y = 4.0 * (0.3 - s * u + c * v);
            const double to_border = std::min(std::abs(x - std::round(x)), std::abs(y - std::round(y)));
            if (to_border < 0.02) continue; // which texel it is hangs on rounding
            const int texel = (static_cast<int>(std::floor(y)) & 3) * 4 + (static_cast<int>(std::floor(x)) & 3);
            for (int k = 0; k < 3; ++k)
                ASSERT_NEAR(at(image, column, row)[k], linear(source.image.u8()[3 * texel + k]), decoding_tolerance)
                    << column << ", " << row;
            ++checked;
        }
    EXPECT_GT(checked, material_side * material_side * 8 / 10);
}

TEST_P(MaterialTest, VertexColoursAreInterpolatedInLinearLight) {
    SurfaceMesh mesh = square({});
    const auto color = [](double x, double y) {
        return glm::dvec3(0.5 + 0.4 * x, 0.3 - 0.2 * y, 0.6 + 0.1 * x + 0.2 * y);
    };
    for (const glm::vec3& p : mesh.positions) mesh.colors.emplace_back(glm::vec3(color(p.x, p.y)), 1.0f);
    const assets::Image image = draw(context(), mesh);
    for (int row = 0; row < material_side; ++row)
        for (int column = 0; column < material_side; ++column) {
            const glm::dvec3 expected =
                color((column + 0.5) / material_side * 2 - 1, 1 - (row + 0.5) / material_side * 2);
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(at(image, column, row)[c], expected[c], 1e-3);
        }
}

TEST_P(MaterialTest, FragmentsBelowTheCutOffAreNotDrawn) {
    for (const float cutoff : {0.0f, 0.25f, 0.75f}) {
        SurfaceMaterial material;
        material.alpha_cutoff = cutoff;
        SurfaceMesh mesh = square(material);
        for (const glm::vec3& p : mesh.positions) mesh.colors.emplace_back(0.0f, 0.0f, 0.0f, 0.5f + 0.5f * p.x);
        const assets::Image image = draw(context(), mesh);
        for (int column = 0; column < material_side; ++column) {
            const double alpha = (column + 0.5) / material_side;
            if (std::abs(alpha - double(cutoff)) < 1.0 / material_side) continue;
            EXPECT_EQ(at(image, column, material_side / 2).x, alpha < double(cutoff) ? 1.0f : 0.0f)
                << column << " " << cutoff;
        }
    }
}

TEST_P(MaterialTest, SubmeshesKeepTheirMaterials) {
    SurfaceMaterial left, right;
    left.base_color = {0.25f, 0.5f, 0.75f, 1.0f};
    right.base_color = {0.75f, 0.125f, 0.5f, 1.0f};
    SurfaceMesh mesh = square(left);
    mesh.submeshes = {{0, 3, left}, {3, 3, right}}; // below and above the diagonal
    const assets::Image image = draw(context(), mesh);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(at(image, 50, 40)[c], left.base_color[c], 1e-6);
        EXPECT_NEAR(at(image, 10, 20)[c], right.base_color[c], 1e-6);
    }
}

HACHURE_INSTANTIATE_GL_TESTS(MaterialTest);

} // namespace
} // namespace hachure::test
