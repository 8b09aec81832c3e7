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

/// Figure 5: lines of one weight have more ink than lines that fade where features are weak.
TEST_P(BrushLookTest, WeakValleysFade) {
    const double binary = Look(context(), preset("binary")).ink_of(BrushFeature::valleys);
    const double fading = Look(context(), preset("fading")).ink_of(BrushFeature::valleys);
    EXPECT_GT(binary, 10.0);
    EXPECT_GT(fading, 0.0);
    EXPECT_LT(fading, 2.0 * binary);
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

HACHURE_INSTANTIATE_GL_TESTS(BrushLookTest);

} // namespace
} // namespace hachure::test
