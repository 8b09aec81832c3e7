// The looks of samples/styles/brush: presets that match the paper's figures; and the style `brush` itself.

#include <hachure/components/implicit_brush.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/styles/style.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/systems/picture/picture_scene.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace hachure::test {
namespace {

const std::filesystem::path folder = HACHURE_SOURCE_DIR "/samples/styles/brush";

std::vector<std::filesystem::path> presets() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::string preset(const char* name) { return (folder / name).string() + ".json"; }

assets::Image frame_of(DrawnScene& scene) {
    scene.renderer().render_frame();
    return scene.renderer().read_aov("color");
}

/// How far the brushes that are visible change the picture: the sum over pixels, of linear channels.
double ink(DrawnScene& scene) {
    scene.renderer().request_aov("color");
    const assets::Image inked = frame_of(scene);
    std::vector<Entity> hidden;
    for (auto [entity, brush] : scene.world().query<ImplicitBrush>())
        if (brush.visible) hidden.push_back(entity);
    for (const Entity entity : hidden) scene.world().get_mutable<ImplicitBrush>(entity).visible = false;
    const assets::Image plain = frame_of(scene);
    for (const Entity entity : hidden) scene.world().get_mutable<ImplicitBrush>(entity).visible = true;
    double sum = 0.0;
    for (int i = 0; i < inked.width * inked.height * inked.channels; ++i) {
        EXPECT_TRUE(std::isfinite(inked.f32()[i]));
        sum += std::abs(double(inked.f32()[i]) - double(plain.f32()[i]));
    }
    return sum / 3.0;
}

/// Two tori that run through each other, so that they meet in valleys, in one look.
class Look {
public:
    Look(gpu::Context& context, const std::string& name) : scene_(context, {480, 360}) {
        const glm::quat lean = glm::angleAxis(0.9f, glm::normalize(glm::vec3(1.0f, 0.3f, 0.2f)));
        scene_.add(surface_mesh(geometry::torus(1.0, 0.45, 96, 48)), {{-0.4f, 0.0f, 0.0f}, lean});
        scene_.add(surface_mesh(geometry::torus(0.8, 0.4, 96, 48)), {{0.5f, 0.1f, 0.1f}, glm::inverse(lean)});
        scene_.add(Camera{.yfov = 0.7f}, {.translation = {0, 0, 4.8f}});
        static_cast<void>(spawn_default_light(scene_.world()));
        style_ = find_style(scene_.app().types(), name);
        apply_style(scene_.world(), scene_.app().types(), style_);
    }

    [[nodiscard]] const Style& style() const { return style_; }
    [[nodiscard]] double ink() { return test::ink(scene_); }

    /// Of the brushes of that feature alone.
    [[nodiscard]] double ink_of(BrushFeature feature) {
        for (auto [entity, brush] : scene_.world().query<ImplicitBrush>()) brush.visible = brush.feature == feature;
        return ink();
    }

    [[nodiscard]] assets::Image picture() { return scene_.draw(); }

private:
    DrawnScene scene_;
    Style style_;
};

using BrushLookTest = GlTest;

TEST_P(BrushLookTest, EveryPresetParsesAndDraws) {
    ASSERT_GE(presets().size(), 17u);
    for (const std::filesystem::path& file : presets()) {
        SCOPED_TRACE(file.filename().string());
        Look look(context(), file.string());
        EXPECT_EQ(look.style().name, file.stem().string());
        EXPECT_NE(look.style().doc.find("figure"), std::string::npos) << look.style().doc;
        EXPECT_GT(look.ink(), 50.0);
    }
}

/// z = a |x| with a rounded bottom; a is 0 up to y = -.8 and grows from there on, to 2.7 where y = 1.
SurfaceMesh valley() {
    constexpr int cells = 120;
    geometry::Shape shape;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            // Narrow columns in the middle.
            const float t = 2.0f * static_cast<float>(i) / cells - 1.0f, x = 1.2f * t * t * t + 0.1f * t;
            const float y = 2.4f * static_cast<float>(j) / cells - 1.2f;
            const float a = 1.5f * std::max(y + 0.8f, 0.0f), growth = a > 0.0f ? 1.5f : 0.0f;
            const float side = std::sqrt(x * x + 4e-4f);
            shape.positions.emplace_back(x, y, a * side);
            shape.normals.push_back(glm::normalize(glm::vec3(-a * x / side, -growth * side, 1.0f)));
        }
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t k = j * (cells + 1) + i;
            shape.indices.insert(shape.indices.end(), {k, k + 1, k + cells + 2, k, k + cells + 2, k + cells + 1});
        }
    return surface_mesh(shape);
}

/// The ink of each row of a picture of a valley that runs from below, where the ground is flat, up to where its sides
/// are steep, in pixels of black.
std::vector<double> ink_along_a_valley(gpu::Context& context, const std::string& style) {
    constexpr int size = 300;
    DrawnScene scene(context, {size, size});
    scene.add(valley(), {});
    scene.add(Camera{.projection = Projection::orthographic, .ymag = 1.0f}, {.translation = {0, 0, 4}});
    apply_style(scene.world(), scene.app().types(), find_style(scene.app().types(), style));
    const assets::Image picture = scene.draw();
    std::vector<double> rows;
    for (int y = size - 20; y >= 20; --y) {
        double& ink = rows.emplace_back(0.0);
        for (int x = size / 2 - 12; x < size / 2 + 12; ++x) ink += 1.0 - picture.u8()[3 * (y * size + x)] / 255.0;
    }
    return rows;
}

/// Figure 5: binary lines have all of their weight or none, fading ones become weaker with their valley.
TEST_P(BrushLookTest, WeakValleysFade) {
    const auto between = [](const std::vector<double>& rows) { // a seventh and three quarters of the most
        const double most = *std::ranges::max_element(rows);
        EXPECT_GT(most, 1.0);
        return static_cast<double>(
                   std::ranges::count_if(rows, [&](double ink) { return ink > most / 7.0 && ink < 0.75 * most; })) /
               static_cast<double>(rows.size());
    };
    const std::vector<double> binary = ink_along_a_valley(context(), preset("binary"));
    const std::vector<double> fading = ink_along_a_valley(context(), preset("fading"));
    EXPECT_LE(between(binary), 0.05) << ::testing::PrintToString(binary);
    EXPECT_GE(between(fading), 0.2) << ::testing::PrintToString(fading);
    for (const std::vector<double>& rows : {binary, fading}) {
        EXPECT_LT(rows.front(), 0.1) << "flat ground has none";
        EXPECT_GT(rows.back(), 1.0);
    }
}

/// Figure 6c: without surfaces, what no line covers is background.
TEST_P(BrushLookTest, ShadedLinesStandAlone) {
    Look look(context(), preset("shaded"));
    const assets::Image picture = look.picture();
    const auto white = [&](int i) {
        return std::min({picture.u8()[3 * i], picture.u8()[3 * i + 1], picture.u8()[3 * i + 2]}) > 250;
    };
    int empty = 0, colored = 0;
    for (int i = 0; i < picture.width * picture.height; ++i) {
        empty += white(i) ? 1 : 0;
        const int red = picture.u8()[3 * i], blue = picture.u8()[3 * i + 2];
        colored += red > blue + 25 ? 1 : 0;
    }
    EXPECT_GT(empty, picture.width * picture.height * 3 / 4);
    EXPECT_GT(colored, 200) << "lines are as warm as the shaded object";
}

/// Figure 12: each of three features has its lines.
TEST_P(BrushLookTest, TerrainHasThreeFeatures) {
    Look look(context(), preset("terrain"));
    for (const BrushFeature feature : {BrushFeature::contours, BrushFeature::ridges, BrushFeature::valleys})
        EXPECT_GT(look.ink_of(feature), 15.0) << static_cast<int>(feature);
}

/// Outlines are ink, not grey, whatever is drawn.
TEST_P(BrushLookTest, TheStyleHasBlackContours) {
    Look look(context(), "brush");
    const assets::Image picture = look.picture();
    int black = 0;
    for (int i = 0; i < picture.width * picture.height; ++i) black += picture.u8()[3 * i] < 40 ? 1 : 0;
    EXPECT_GT(black, 300) << "of about 2000 pixels of outline";
    EXPECT_GT(look.ink_of(BrushFeature::contours), 300.0);
}

/// Figure 13: the presets that say something of pictures draw the edge of a bright disc.
TEST_P(BrushLookTest, PresetsOfPicturesDrawEdges) {
    const TempFolder files;
    assets::Image disc = assets::make_image(480, 360, 3, assets::PixelType::u8);
    for (int i = 0; i < disc.width * disc.height; ++i) {
        const int x = i % disc.width - 240, y = i / disc.width - 180;
        for (int c = 0; c < 3; ++c) disc.u8()[3 * i + c] = x * x + y * y < 120 * 120 ? 200 : 60;
    }
    assets::write_png(files / "disc.png", disc);
    for (const std::string& name : {preset("drops"), preset("chalked"), std::string("brush")}) {
        SCOPED_TRACE(name);
        PictureScene scene(context(), {480, 360});
        scene.show({.file = (files / "disc.png").string()});
        apply_style(scene.world(), scene.app().types(), find_style(scene.app().types(), name));
        EXPECT_GT(ink(scene), 0.5 * 750) << "of a circle of 750 pixels";
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(BrushLookTest);

} // namespace
} // namespace hachure::test
