#include <hachure/components/compose.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/paper.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/temp_folder.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace hachure::test {
namespace {

constexpr int picture_side = 256;

/// A square of one colour that fills the picture, or a part of it, on the paper's colour.
struct Sheet {
    glm::vec3 color{0.5f};
    glm::vec3 background{1.0f};
    float size = 1.0f; ///< of the square, relative to the picture
    std::optional<EdgeLines> lines{};
};

SurfaceMesh square(const Sheet& sheet) {
    SurfaceMaterial material;
    material.base_color = glm::vec4(sheet.color, 1.0f);
    SurfaceMesh mesh;
    const float s = sheet.size;
    mesh.positions = {{-s, -s, 0}, {s, -s, 0}, {s, s, 0}, {-s, s, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.submeshes = {{0, 6, material}};
    return mesh;
}

class PaperScene {
public:
    PaperScene(gpu::Context& context, const Sheet& sheet, const std::optional<Paper>& paper)
        : scene_(context, {picture_side, picture_side}) {
        surface_ = scene_.add(square(sheet));
        if (sheet.lines) scene_.world().add(surface_, *sheet.lines);
        camera_ = scene_.add(Camera{.projection = Projection::orthographic, .ymag = 1.0f, .zfar = 10.0f},
                             {.translation = {0, 0, 2}});
        scene_.world().add(camera_, Compose{.background = sheet.background});
        if (paper) scene_.world().add(camera_, *paper);
    }

    [[nodiscard]] DrawnScene& drawn() { return scene_; }
    /// What the square's colour is multiplied with.
    void tint(const glm::vec3& tint) { scene_.world().get_mutable<Surface>(surface_).tint = tint; }
    [[nodiscard]] Paper& paper() { return scene_.world().get_mutable<Paper>(camera_); }

    /// Linear colours.
    assets::Image colors() {
        scene_.renderer().request_aov("color");
        scene_.renderer().render_frame();
        return scene_.renderer().read_aov("color");
    }

private:
    DrawnScene scene_;
    Entity surface_ = Entity::null, camera_ = Entity::null;
};

assets::Image colors(gpu::Context& context, const Sheet& sheet, const std::optional<Paper>& paper) {
    return PaperScene(context, sheet, paper).colors();
}

glm::dvec3 mean(const assets::Image& image) {
    glm::dvec3 sum(0.0);
    for (int i = 0; i < image.width * image.height; ++i)
        for (int c = 0; c < 3; ++c) sum[c] += double(image.f32()[3 * i + c]);
    return sum / double(image.width * image.height);
}

bool same(const assets::Image& a, const assets::Image& b) { return a.pixels == b.pixels; }

constexpr PaperKind kinds_of_paper[] = {PaperKind::tooth, PaperKind::cold_press, PaperKind::laid, PaperKind::canvas};

using PaperTest = GlTest;
using PaperDrawingTest = GlTest; ///< the paper on a tone and on lines, on every back end

TEST_P(PaperTest, FlatTonesAreKeptOnAverage) {
    double worst = 0.0;
    for (const PaperKind kind : kinds_of_paper) {
        PaperScene scene(context(), {.color = glm::vec3(1.0f)}, Paper{.kind = kind});
        for (const float softness : {0.0f, 0.5f, 1.0f})
            for (const float grey : {0.03f, 0.2f, 0.5f, 0.8f, 0.97f}) {
                scene.paper().softness = softness;
                scene.tint(glm::vec3(grey));
                const glm::dvec3 found = mean(scene.colors());
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], grey, 0.015) << int(kind) << " softness " << softness;
                worst = std::max(worst, std::abs(found.x - double(grey)));
            }
    }
    RecordProperty("worst", std::to_string(worst));
}

/// Chalk is lighter than its paper, in some channels or all.
TEST_P(PaperTest, ColoursAreKeptOnAverageOnAnyPaper) {
    for (const glm::vec3& bare : {glm::vec3(0.2f, 0.25f, 0.3f), glm::vec3(0.0f), glm::vec3(0.9f, 0.8f, 0.6f)})
        for (const glm::vec3& color : {glm::vec3(0.6f, 0.1f, 0.3f), glm::vec3(0.8f, 0.75f, 0.7f), glm::vec3(0.05f)}) {
            const assets::Image image = colors(context(), {.color = color, .background = bare}, Paper{});
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean(image)[c], double(color[c]), 0.012) << c;
            const auto [low, high] = std::minmax_element(image.f32(), image.f32() + 3 * picture_side * picture_side);
            EXPECT_GE(*low, -1e-5f);
            EXPECT_LE(*high, 1.0f + 1e-5f);
        }
}

TEST_P(PaperTest, BarePaperStaysClean) {
    for (const glm::vec3& bare : {glm::vec3(1.0f), glm::vec3(0.31f, 0.07f, 0.013f), glm::vec3(0.002f)}) {
        const Sheet sheet{.color = bare, .background = bare, .size = 0.5f};
        // The picture, whose colours are rounded on the way, and the colours that are not.
        EXPECT_TRUE(same(PaperScene(context(), sheet, Paper{}).drawn().draw(),
                         PaperScene(context(), sheet, std::nullopt).drawn().draw()));
        EXPECT_TRUE(same(colors(context(), sheet, Paper{}), colors(context(), sheet, std::nullopt)));
    }
}

/// With no passage between them, pigment is where the paper is higher than the share that stays bare.
TEST_P(PaperDrawingTest, PeaksCatchPigmentAndValleysResistIt) {
    const TempFolder folder;
    const std::string file = (folder / "ramp.png").string();
    assets::Image ramp = assets::make_image(256, 1, 1, assets::PixelType::u8);
    for (int x = 0; x < 256; ++x) ramp.u8()[x] = static_cast<std::uint8_t>(x);
    assets::write_png(file, ramp);
    for (const float grey : {0.25f, 0.5f, 0.75f}) {
        const assets::Image image =
            colors(context(), {.color = glm::vec3(grey)}, Paper{.file = file, .softness = 0.0f});
        for (int x = 0; x < picture_side; ++x) {
            const float value = image.f32()[3 * (100 * picture_side + x)];
            const float edge = 256.0f * grey;
            if (std::abs(float(x) - edge) < 2.0f) continue;
            EXPECT_NEAR(value, float(x) < edge ? 1.0f : 0.0f, 1e-4) << grey << " at " << x;
        }
    }
}

TEST_P(PaperTest, LessPressureLeavesPaperBareInTheDarkest) {
    for (const float pressure : {0.3f, 0.7f, 1.0f})
        EXPECT_NEAR(mean(colors(context(), {.color = glm::vec3(0.0f)}, Paper{.pressure = pressure})).x,
                    double(1.0f - pressure), 0.01)
            << pressure;
}

TEST_P(PaperTest, StrengthLeadsFromNothingToAllOfIt) {
    const Sheet sheet{.color = glm::vec3(0.4f)};
    const assets::Image none = colors(context(), sheet, std::nullopt),
                        half = colors(context(), sheet, Paper{.strength = 0.5f}),
                        all = colors(context(), sheet, Paper{});
    EXPECT_TRUE(same(none, colors(context(), sheet, Paper{.strength = 0.0f})));
    double largest = 0.0;
    for (int i = 0; i < 3 * picture_side * picture_side; ++i) {
        ASSERT_NEAR(half.f32()[i], 0.5f * (none.f32()[i] + all.f32()[i]), 1e-5f);
        largest = std::max(largest, double(std::abs(all.f32()[i] - none.f32()[i])));
    }
    EXPECT_GT(largest, 0.3);
}

/// Lines half the picture wide: their darkness is kept as that of a tone is, where they are not opaque.
TEST_P(PaperDrawingTest, LinesShowThePaperWhereTheyAreAsked) {
    const Sheet sheet{.color = glm::vec3(1.0f), .size = 0.6f, .lines = EdgeLines{.width = 40.0f}};
    const assets::Image plain = colors(context(), sheet, std::nullopt);
    EXPECT_LT(mean(plain).x, 0.9);
    const Paper lines_alone{.on_shading = false, .pressure = 0.6f}, neither{.on_lines = false, .on_shading = false},
        shading_alone{.on_lines = false, .pressure = 0.6f};
    const assets::Image papered = colors(context(), sheet, lines_alone);
    EXPECT_NEAR(1.0 - mean(papered).x, 0.6 * (1.0 - mean(plain).x), 0.01);
    EXPECT_TRUE(same(plain, colors(context(), sheet, neither)));
    EXPECT_TRUE(same(plain, colors(context(), sheet, shading_alone))); // white shading, and lines as they were
    // With shading in the same pass, lines are the same.
    const assets::Image both = colors(context(), sheet, Paper{.pressure = 0.6f});
    for (int i = 0; i < 3 * picture_side * picture_side; ++i) ASSERT_NEAR(both.f32()[i], papered.f32()[i], 1e-4f) << i;
}

TEST_P(PaperTest, NothingRunsWithoutItOrWhileNothingChanges) {
    const Sheet sheet{.size = 0.6f, .lines = EdgeLines{}};
    PaperScene without(context(), sheet, std::nullopt);
    const auto plain = without.drawn().draw_passes();
    EXPECT_FALSE(plain.contains("paper"));
    EXPECT_TRUE(plain.contains("overlay"));
    PaperScene with(context(), sheet, Paper{});
    const auto first = with.drawn().draw_passes();
    EXPECT_EQ(first.at("paper"), gpu::PassState::run);
    EXPECT_FALSE(first.contains("overlay")) << "lines are laid twice";
    for (const auto& [name, state] : with.drawn().draw_passes()) EXPECT_NE(state, gpu::PassState::run) << name;
    with.paper().softness = 0.2f;
    EXPECT_EQ(with.drawn().draw_passes().at("paper"), gpu::PassState::run);
    with.paper().strength = 0.0f;
    const auto bare = with.drawn().draw_passes();
    EXPECT_FALSE(bare.contains("paper"));
    EXPECT_TRUE(bare.contains("overlay"));
}

/// 7.8125 thousandths of a height of 256 pixels are two of them.
TEST_P(PaperTest, ScaleCanFollowThePicture) {
    const Paper pixels{.scale = 2.0f}, picture{.scale = 7.8125f, .scale_unit = PaperUnit::picture};
    EXPECT_TRUE(same(colors(context(), {}, pixels), colors(context(), {}, picture)));
    EXPECT_FALSE(same(colors(context(), {}, pixels), colors(context(), {}, Paper{.scale = 7.8125f})));
}

TEST_P(PaperTest, AFileThatIsMissingOrBrokenEndsTheFrameWithItsName) {
    const TempFolder folder;
    for (const std::string& file : {(folder / "none.png").string(), folder.write("broken.png", "none").string()}) {
        PaperScene scene(context(), {}, Paper{.file = file});
        try {
            scene.drawn().renderer().render_frame();
            ADD_FAILURE() << "it was drawn";
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), ::testing::HasSubstr(file));
        }
        scene.paper().file.clear();
        EXPECT_NO_THROW(scene.drawn().renderer().render_frame());
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(PaperTest);
HACHURE_INSTANTIATE_GL_TESTS(PaperDrawingTest);

} // namespace
} // namespace hachure::test
