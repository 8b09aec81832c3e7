#include <hachure/components/gooch.h>
#include <hachure/runtime/assets/file_bytes.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/read_model.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/temp_folder.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <optional>

namespace hachure::test {
namespace {

constexpr int map_side = 96;
constexpr double view_half = 1.5; ///< metres from the middle of the picture to its border

/// Texels are bytes, so nothing but float rounding is between the shader and the reference.
constexpr double tolerance = 2e-5;

constexpr int texels = 16; ///< a side of the map

/// Directions all over the upper hemisphere; none is the zero vector.
assets::Image relief(int channels = 3) {
    assets::Image image = assets::make_image(texels, texels, channels, assets::PixelType::u8);
    for (int i = 0; i < texels * texels; ++i)
        for (int c = 0; c < channels; ++c)
            image.u8()[i * channels + c] =
                static_cast<std::uint8_t>(c == 2 ? 140 + i * 37 % 116 : (i * 89 + c * 71) % 256);
    return image;
}

assets::EncodedImage encoded(const assets::Image& image, const std::string& name) {
    const TempFolder folder;
    assets::write_png(folder / "map.png", image);
    return {name, assets::read_file_bytes(folder / "map.png")};
}

struct Trial {
    std::string name;
    glm::mat4 matrix{1.0f};
    assets::TextureUse use{.texture = 0};
    float scale = 1.0f;
    bool double_sided = false;
    bool mirrored_texture = false;           ///< the square shows its picture's mirror image
    std::optional<glm::vec4> file_tangent{}; ///< of every vertex; else they are computed
    int channels = 3;
};

/// The square [-1, 1]^2 in z = 0 that faces +Z, with a picture upright on it or its mirror image.
assets::Primitive square(bool mirrored) {
    assets::Primitive result;
    result.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    result.normals.assign(4, {0, 0, 1});
    result.texcoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    if (mirrored)
        for (glm::vec2& texcoord : result.texcoords[0]) texcoord.x = 1.0f - texcoord.x;
    result.indices = {0, 1, 2, 0, 2, 3};
    return result;
}

assets::Model model_of(const Trial& trial) {
    assets::Model model;
    assets::Primitive primitive = square(trial.mirrored_texture);
    if (trial.use.texcoord == 1) { // the base colour keeps another set
        primitive.texcoords[1] = primitive.texcoords[0];
        for (glm::vec2& texcoord : primitive.texcoords[0]) texcoord = 0.5f * texcoord + 0.3f;
    }
    if (trial.file_tangent) primitive.tangents.assign(4, *trial.file_tangent);
    primitive.material = 0;
    assets::Material material;
    material.normal_texture = trial.use;
    material.normal_scale = trial.scale;
    material.double_sided = trial.double_sided;
    if (trial.use.texcoord == 1) material.base_color_texture.texture = 0;
    model.materials = {material};
    model.images = {encoded(relief(trial.channels), "relief.png")};
    model.textures = {
        {.image = 0, .magnify = assets::Filter::nearest, .minify = assets::Filter::nearest, .mipmaps = false}};
    model.meshes.push_back({.name = "square", .primitives = {primitive}});
    model.nodes.push_back({.name = "square", .matrix = trial.matrix, .mesh = 0});
    model.scenes.push_back({.roots = {0}});
    return model;
}

/// Puts the model before a camera that looks along -Z.
SpawnedModel spawn(DrawnScene& scene, const assets::Model& model) {
    SpawnedModel spawned = spawn_model(scene.world(), model);
    scene.add(Camera{.projection = Projection::orthographic, .ymag = static_cast<float>(view_half), .zfar = 20.0f},
              {.translation = {0, 0, 10}});
    return spawned;
}

assets::Image draw_aov(DrawnScene& scene, const char* name) {
    scene.renderer().request_aov(name);
    scene.renderer().render_frame();
    return scene.renderer().read_aov(name);
}

assets::Image draw_normals(gpu::Context& context, const assets::Model& model, int size = map_side) {
    DrawnScene scene(context, {size, size});
    EXPECT_THAT(spawn(scene, model).warnings, testing::IsEmpty());
    return draw_aov(scene, "normal");
}

/// The normal at (x, y) of the world, from directions that are moved with the surface: no handedness is involved where
/// the tangent is not the file's. Nothing outside the square, and where rounding says which texel it is.
class Reference {
public:
    explicit Reference(const Trial& trial)
        : trial_(trial), matrix_(trial.matrix), back_(glm::inverse(matrix_)), relief_(relief(trial.channels)) {
        const double c = std::cos(double(trial.use.rotation)), s = std::sin(double(trial.use.rotation));
        // Of (u, v): the turn is counter-clockwise where v points down.
        texcoord_ = glm::dmat2({c, -s}, {s, c}) *
                    glm::dmat2({double(trial.use.scale.x), 0.0}, {0.0, double(trial.use.scale.y)});
        const double u_of_x = trial.mirrored_texture ? -0.5 : 0.5;
        const glm::dmat2 uv_of_xy = texcoord_ * glm::dmat2({u_of_x, 0.0}, {0.0, -0.5});
        const glm::dmat2 xy_of_uv = glm::inverse(uv_of_xy);
        const glm::dmat3 linear(matrix_);
        normal_ = glm::normalize(glm::transpose(glm::inverse(linear)) * glm::dvec3(0, 0, 1));
        const glm::dvec3 u(xy_of_uv[0], 0.0), up(-xy_of_uv[1], 0.0);
        tangent_ = glm::normalize(linear * (trial.file_tangent ? glm::dvec3(*trial.file_tangent) : u));
        // Across the tangent in the surface, to the side where the picture's top is.
        bitangent_ = glm::cross(normal_, tangent_);
        const glm::dvec3 top = trial.file_tangent ? double(trial.file_tangent->w) *
                                                        glm::cross(glm::dvec3(0, 0, 1), glm::dvec3(*trial.file_tangent))
                                                  : up;
        if (glm::dot(bitangent_, linear * top) < 0.0) bitangent_ = -bitangent_;
    }

    [[nodiscard]] std::optional<glm::dvec3> at(double x, double y) const {
        const glm::dvec4 origin = back_ * glm::dvec4(x, y, 0.0, 1.0), ray = back_ * glm::dvec4(0.0, 0.0, 1.0, 0.0);
        const glm::dvec2 p = glm::dvec2(origin) - glm::dvec2(ray) * (origin.z / ray.z);
        if (std::max(std::abs(p.x), std::abs(p.y)) > 0.98) return std::nullopt;
        const double u = trial_.mirrored_texture ? 0.5 - 0.5 * p.x : 0.5 + 0.5 * p.x;
        const glm::dvec2 uv =
            double(texels) * (glm::dvec2(trial_.use.offset) + texcoord_ * glm::dvec2(u, 0.5 - 0.5 * p.y));
        const glm::dvec2 border = glm::abs(uv - glm::round(uv));
        if (std::min(border.x, border.y) < 0.01) return std::nullopt;
        const glm::dvec3 mapped = decoded(static_cast<int>(std::floor(uv.x)) & (texels - 1),
                                          static_cast<int>(std::floor(uv.y)) & (texels - 1));
        const glm::dvec3 n = glm::normalize(mapped.x * tangent_ + mapped.y * bitangent_ + mapped.z * normal_);
        return normal_.z < 0.0 ? -n : n; // seen from behind: the camera looks along -Z
    }

private:
    [[nodiscard]] glm::dvec3 decoded(int column, int row) const {
        const std::uint8_t* t = relief_.u8() + (row * texels + column) * relief_.channels;
        const double s = trial_.scale;
        return {s * (t[0] / 127.5 - 1.0), s * (t[1] / 127.5 - 1.0), t[2] / 127.5 - 1.0};
    }

    const Trial& trial_;
    glm::dmat4 matrix_, back_;
    glm::dmat2 texcoord_;
    glm::dvec3 normal_, tangent_, bitangent_;
    assets::Image relief_;
};

glm::dvec3 texel(const assets::Image& image, int column, int row) {
    const float* p = image.f32() + 3 * (row * image.width + column);
    return {p[0], p[1], p[2]};
}

double coordinate(int pixel) { return view_half * ((pixel + 0.5) / map_side * 2.0 - 1.0); }

std::vector<Trial> trials() {
    const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), 0.7f, glm::normalize(glm::vec3(1, 2, 3)));
    const glm::mat4 behind = glm::rotate(turn, 3.1f, glm::vec3(0, 1, 0));
    const glm::mat4 mirror = glm::scale(turn, {-1, 1, 1}), through = glm::scale(turn, {1, 1, -1});
    const glm::mat4 uneven = glm::scale(turn, {0.5f, 1.2f, 3.0f});
    const glm::mat4 shear = glm::scale(glm::mat4(1.0f), {1.1f, 0.6f, 1.0f}) * turn;
    const assets::TextureUse moved{.texture = 0, .offset = {0.3f, -0.2f}, .scale = {1.5f, 0.7f}, .rotation = 0.6f};
    const assets::TextureUse flipped{.texture = 0, .scale = {-1.0f, 2.0f}, .rotation = -2.0f};
    return {{.name = "straight"},
            {.name = "four channels", .channels = 4},
            {.name = "turned", .matrix = turn},
            {.name = "small", .matrix = glm::scale(turn, glm::vec3(0.2f))},
            {.name = "flat", .matrix = turn, .scale = 0.3f},
            {.name = "inverted relief", .matrix = turn, .scale = -1.0f},
            {.name = "mirrored", .matrix = mirror},
            {.name = "mirrored through its plane", .matrix = through, .double_sided = true},
            {.name = "mirrored texture", .matrix = turn, .mirrored_texture = true},
            {.name = "mirrored texture, mirrored", .matrix = mirror, .mirrored_texture = true},
            {.name = "front of two sides", .matrix = turn, .double_sided = true},
            {.name = "back", .matrix = behind, .double_sided = true},
            {.name = "mirrored back", .matrix = glm::scale(behind, {-1, 1, 1}), .double_sided = true},
            {.name = "moved texture", .matrix = turn, .use = moved},
            {.name = "moved texture, mirrored back",
             .matrix = glm::scale(behind, {1, -1, 1}),
             .use = moved,
             .double_sided = true},
            {.name = "flipped texture", .matrix = turn, .use = flipped},
            {.name = "unevenly scaled", .matrix = uneven},
            {.name = "sheared", .matrix = shear, .use = moved},
            {.name = "sheared mirror image", .matrix = glm::scale(shear, {-1, 1, 1}), .use = moved},
            {.name = "second texture coordinates", .matrix = turn, .use = {.texture = 0, .texcoord = 1}},
            {.name = "tangents of the file", .matrix = shear, .file_tangent = glm::vec4(0.6f, 0.8f, 0.0f, 1.0f)},
            {.name = "mirrored tangents of the file",
             .matrix = mirror,
             .use = moved,
             .file_tangent = glm::vec4(0.6f, 0.8f, 0.0f, -1.0f)}};
}

using NormalMapTest = GlTest;

TEST_P(NormalMapTest, NormalsAreTheMapsOwn) {
    for (const Trial& trial : trials()) {
        SCOPED_TRACE(trial.name);
        const assets::Image image = draw_normals(context(), model_of(trial));
        const Reference reference(trial);
        int checked = 0;
        double error = 0.0;
        for (int row = 0; row < map_side; ++row)
            for (int column = 0; column < map_side; ++column)
                if (const auto expected = reference.at(coordinate(column), -coordinate(row))) {
                    error = std::max(error, glm::length(texel(image, column, row) - *expected));
                    ++checked;
                }
        EXPECT_LT(error, tolerance);
        EXPECT_GT(checked, 60);
    }
}

/// A map of one direction must shade as vertex normals of that direction do.
TEST_P(NormalMapTest, GoochShadesWithTheMappedNormal) {
    Trial trial{.matrix = glm::rotate(glm::mat4(1.0f), 0.5f, glm::vec3(1, 0, 0))};
    assets::Model model = model_of(trial);
    assets::Image map = assets::make_image(1, 1, 3, assets::PixelType::u8);
    const std::array<std::uint8_t, 3> bytes{220, 60, 200};
    std::copy_n(bytes.begin(), 3, map.u8());
    model.images = {encoded(map, "slope.png")};
    assets::Model plain = model;
    plain.materials[0].normal_texture = {};
    const glm::vec3 slope(220 / 127.5f - 1.0f, 60 / 127.5f - 1.0f, 200 / 127.5f - 1.0f);
    plain.meshes[0].primitives[0].normals.assign(4, glm::normalize(slope));
    const auto draw = [&](const assets::Model& drawn) {
        DrawnScene scene(context(), {map_side, map_side});
        for (const Entity surface : spawn(scene, drawn).surfaces) scene.world().add(surface, Gooch{});
        spawn_default_light(scene.world());
        return draw_aov(scene, "color");
    };
    const assets::Image mapped = draw(model), expected = draw(plain);
    model.materials[0].normal_texture = {};
    const assets::Image unmapped = draw(model);
    for (const int pixel : {map_side / 4, map_side / 2, 3 * map_side / 4}) {
        const glm::dvec3 color = texel(mapped, pixel, map_side / 2);
        EXPECT_LT(glm::length(color - texel(expected, pixel, map_side / 2)), 1e-4) << pixel;
        EXPECT_GT(glm::length(color - texel(unmapped, pixel, map_side / 2)), 0.02) << pixel;
    }
}

TEST_P(NormalMapTest, NoScaleMakesNormalsThatAreNone) {
    for (const float scale : {1e6f, 1e30f, -std::numeric_limits<float>::infinity()}) {
        const assets::Image image = draw_normals(context(), model_of({.scale = scale}));
        for (int i = 0; i < map_side; ++i) {
            if (std::abs(coordinate(i)) > 0.98) continue;
            EXPECT_NEAR(glm::length(texel(image, i, map_side / 2)), 1.0, 1e-5) << scale;
        }
    }
}

/// Of one mesh: a square with a map, one whose material has none, and one that lacks texture coordinates.
TEST_P(NormalMapTest, PartsWithoutAMapKeepTheirNormals) {
    assets::Model model = model_of({});
    assets::Primitive& mapped = model.meshes[0].primitives[0];
    assets::Primitive plain = mapped, untextured = mapped;
    for (glm::vec3& p : mapped.positions) p.x = 0.5f * p.x - 0.5f;
    for (glm::vec3& p : plain.positions) p = {0.5f * p.x + 0.5f, 0.5f * p.y + 0.5f, 0.0f};
    for (glm::vec3& p : untextured.positions) p = {0.5f * p.x + 0.5f, 0.5f * p.y - 0.5f, 0.0f};
    plain.material = 1;
    untextured.texcoords[0].clear();
    model.materials.emplace_back();
    model.meshes[0].primitives.insert(model.meshes[0].primitives.end(), {plain, untextured});
    const assets::Image image = draw_normals(context(), model);
    for (int row = 0; row < map_side; ++row) {
        if (std::abs(coordinate(row)) > 0.98) continue;
        EXPECT_EQ(texel(image, 3 * map_side / 4 - 4, row), glm::dvec3(0, 0, 1)) << row;
        EXPECT_GT(glm::length(texel(image, map_side / 4 + 4, row) - glm::dvec3(0, 0, 1)), 0.02) << row;
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(NormalMapTest);

/// What spawning says of the map and what it leaves of it.
SpawnedModel spawn_in(World& world, const assets::Model& model) {
    world.set_resource(MeshStore{});
    return spawn_model(world, model);
}

TEST(NormalMapFiles, WhatIsNoNormalMapIsNamedAndLeftOut) {
    for (const int channels : {1, 2}) {
        assets::Model model = model_of({.channels = channels});
        model.materials.push_back(model.materials[0]);
        model.meshes[0].primitives.push_back(model.meshes[0].primitives[0]);
        model.meshes[0].primitives[1].material = 1;
        World world;
        const std::string channel_count = std::to_string(channels) + " of 3 channels";
        EXPECT_THAT(spawn_in(world, model).warnings,
                    testing::ElementsAre("relief.png: is not a normal map: it has " + channel_count));
        const SurfaceMesh& mesh = world.resource<MeshStore>().mesh(0);
        EXPECT_EQ(mesh.submeshes.at(0).material.normal_texture, -1);
        EXPECT_TRUE(mesh.tangents.empty());
    }
    assets::Model broken = model_of({});
    broken.images[0].bytes.resize(100);
    World world;
    EXPECT_THAT(spawn_in(world, broken).warnings, testing::ElementsAre(testing::StartsWith("relief.png: ")));
    EXPECT_EQ(world.resource<MeshStore>().mesh(0).submeshes.at(0).material.normal_texture, -1);
}

TEST(NormalMapFiles, MeshesWithoutAMapCarryNothingForOne) {
    assets::Model model = model_of({.file_tangent = glm::vec4(1, 0, 0, 1)});
    model.meshes[0].primitives[0].texcoords[1] = model.meshes[0].primitives[0].texcoords[0];
    model.materials[0].normal_texture = {};
    World world;
    EXPECT_THAT(spawn_in(world, model).warnings, testing::IsEmpty());
    const SurfaceMesh& mesh = world.resource<MeshStore>().mesh(0);
    EXPECT_TRUE(mesh.tangents.empty());
    EXPECT_TRUE(mesh.normal_texcoords.empty());
    EXPECT_EQ(mesh.texcoords.size(), 4u);
}

TEST(NormalMapFiles, ImagesAreStoredOncePerColourSpaceAndSampling) {
    assets::Model model = model_of({});
    model.textures.push_back(model.textures[0]);                               // the same by another name
    model.textures.push_back({.image = 0, .magnify = assets::Filter::linear}); // the same image, read differently
    model.materials.assign(4, model.materials[0]);
    model.materials[1].normal_texture.texture = 1;
    model.materials[2].normal_texture.texture = 2;
    model.materials[3].base_color_texture.texture = 1;
    const assets::Primitive primitive = model.meshes[0].primitives[0];
    model.meshes[0].primitives.assign(4, primitive);
    for (int i = 0; i < 4; ++i) model.meshes[0].primitives[static_cast<std::size_t>(i)].material = i;
    World world;
    EXPECT_THAT(spawn_in(world, model).warnings, testing::IsEmpty());
    const MeshStore& store = world.resource<MeshStore>();
    EXPECT_EQ(store.texture_count(), 3u);
    const auto material = [&](std::size_t i) -> const SurfaceMaterial& {
        return store.mesh(0).submeshes.at(i).material;
    };
    EXPECT_EQ(material(1).normal_texture, material(0).normal_texture);
    EXPECT_NE(material(2).normal_texture, material(0).normal_texture);
    EXPECT_EQ(material(3).normal_texture, material(0).normal_texture);
    EXPECT_EQ(store.texture(material(0).normal_texture).color_space, ColorSpace::linear);
    EXPECT_EQ(store.texture(material(3).base_color_texture).color_space, ColorSpace::srgb);
}

/// Khronos' chart: on each tile a dome of triangles on the left and, on the right, the same dome in a normal map, which
/// is turned and mirrored from row to row.
class GivenNormalMaps : public GivenModelTest {};

TEST_P(GivenNormalMaps, RightDomesAreShadedAsLeftOnes) {
    std::string reason;
    gpu::Context* egl = GlContexts::use(gpu::Backend::egl, reason);
    if (!egl) GTEST_SKIP() << "no EGL context: " << reason;
    constexpr int size = 600, to_the_right = 64; // 200 pixels a metre; the twin of a tile is .32 m beside it
    const assets::Image image = draw_normals(*egl, assets::read_model(file()), size);
    for (const int x : {108, 268, 428})                 // middles of left domes: -.96, -.16, .64 m
        for (const int y : {140, 220, 300, 380, 460}) { // .8 m to -.8 m
            SCOPED_TRACE(std::to_string(x) + ", " + std::to_string(y));
            double sum = 0.0, slope = 0.0;
            int count = 0;
            for (int row = y - 14; row < y + 14; ++row)
                for (int column = x - 14; column < x + 14; ++column) {
                    const glm::dvec3 left = texel(image, column, row), right = texel(image, column + to_the_right, row);
                    sum += glm::length(left - right);
                    slope += std::hypot(left.x, left.y);
                    ++count;
                }
            EXPECT_LT(sum / count, 0.06);
            EXPECT_GT(slope / count, 0.3) << "there is no dome";
        }
}

INSTANTIATE_TEST_SUITE_P(Folder, GivenNormalMaps, ::testing::Values("meshes/khronos_tests/NormalTangentTest.glb"),
                         given_model_name);

} // namespace
} // namespace hachure::test
