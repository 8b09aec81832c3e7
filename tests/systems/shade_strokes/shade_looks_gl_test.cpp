// The looks of samples/styles/strokes, and the style `strokes` itself.

#include <hachure/components/shade_strokes.h>
#include <hachure/systems/light/light.h>
#include <hachure/systems/styles/style.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace hachure::test {
namespace {

const std::filesystem::path shade_folder = HACHURE_SOURCE_DIR "/samples/styles/strokes";

std::vector<std::filesystem::path> shade_presets() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(shade_folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// A torus that leans towards the eye, in one look.
class ShadeLook {
public:
    ShadeLook(gpu::Context& context, const std::string& name) : scene_(context, {240, 180}) {
        surface_ = scene_.add(surface_mesh(geometry::torus(1.0, 0.45, 64, 32)),
                              {.rotation = glm::angleAxis(0.9f, glm::normalize(glm::vec3(1.0f, 0.3f, 0.2f)))});
        scene_.add(Camera{.yfov = 0.7f}, {.translation = {0, 0, 4.5f}});
        static_cast<void>(spawn_default_light(scene_.world()));
        style_ = find_style(scene_.app().types(), name);
        apply_style(scene_.world(), scene_.app().types(), style_);
        scene_.renderer().request_aov("stroke_coverage");
        scene_.renderer().request_aov("color");
    }

    [[nodiscard]] const Style& style() const { return style_; }
    [[nodiscard]] const ShadeStrokes& strokes() { return scene_.world().get<ShadeStrokes>(surface_); }
    void hide_strokes() { scene_.world().get_mutable<ShadeStrokes>(surface_).opacity = 0.0f; }

    /// Pixels of strokes.
    [[nodiscard]] double coverage() {
        scene_.renderer().render_frame();
        const assets::Image image = scene_.renderer().read_aov("stroke_coverage");
        double sum = 0.0;
        for (int i = 0; i < image.width * image.height; ++i) sum += double(image.f32()[i]);
        return sum;
    }

    [[nodiscard]] assets::Image color() {
        scene_.renderer().render_frame();
        return scene_.renderer().read_aov("color");
    }

private:
    DrawnScene scene_;
    Entity surface_ = Entity::null;
    Style style_;
};

/// How much darker one picture is than another, over all pixels.
double darker(const assets::Image& a, const assets::Image& b) {
    double sum = 0.0;
    for (int i = 0; i < a.width * a.height * a.channels; ++i) {
        EXPECT_TRUE(std::isfinite(a.f32()[i]));
        sum += double(b.f32()[i]) - double(a.f32()[i]);
    }
    return sum / a.channels;
}

using ShadeLookTest = GlTest;

TEST_P(ShadeLookTest, EveryPresetParsesAndDrawsStrokes) {
    ASSERT_GE(shade_presets().size(), 8u);
    for (const std::filesystem::path& file : shade_presets()) {
        SCOPED_TRACE(file.filename().string());
        ShadeLook look(context(), file.string());
        EXPECT_EQ(look.style().name, file.stem().string());
        EXPECT_FALSE(look.style().doc.empty());
        EXPECT_GT(look.coverage(), 200.0);
        const assets::Image drawn = look.color();
        look.hide_strokes();
        EXPECT_GT(darker(drawn, look.color()), 50.0) << "strokes are seen on what lies under them";
        EXPECT_EQ(look.coverage(), 0.0);
    }
}

TEST_P(ShadeLookTest, TheStyleIsBuiltIn) {
    ShadeLook look(context(), "strokes");
    EXPECT_EQ(look.strokes(), ShadeStrokes{});
    EXPECT_GT(look.coverage(), 200.0);
    const assets::Image drawn = look.color();
    look.hide_strokes();
    EXPECT_GT(darker(drawn, look.color()), 50.0);
}

/// Each tip leaves marks of its own.
TEST_P(ShadeLookTest, TipsDiffer) {
    const std::vector<std::string> tips{"pencil", "ink", "charcoal"};
    for (std::size_t i = 0; i < tips.size(); ++i) {
        ShadeLook look(context(), (shade_folder / tips[i]).string() + ".json");
        EXPECT_EQ(look.strokes().tip, static_cast<ShadeTip>(i));
    }
}

HACHURE_INSTANTIATE_GL_TESTS(ShadeLookTest);

} // namespace
} // namespace hachure::test
