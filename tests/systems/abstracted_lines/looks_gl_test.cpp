// The looks of samples/styles/lines: presets that match the paper's figures.

#include <hachure/components/abstracted_lines.h>
#include <hachure/components/paper.h>
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

const std::filesystem::path folder = HACHURE_SOURCE_DIR "/samples/styles/lines";

std::vector<std::filesystem::path> presets() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// A torus that leans towards the eye, in one look.
class Look {
public:
    Look(gpu::Context& context, const std::filesystem::path& file) : scene_(context, {320, 240}) {
        scene_.add(surface_mesh(geometry::torus(1.0, 0.45, 128, 64)),
                   {.rotation = glm::angleAxis(0.9f, glm::normalize(glm::vec3(1.0f, 0.3f, 0.2f)))});
        camera_ = scene_.add(Camera{.yfov = 0.7f}, {.translation = {0, 0, 4.5f}});
        static_cast<void>(spawn_default_light(scene_.world()));
        style_ = find_style(scene_.app().types(), file.string());
        apply_style(scene_.world(), scene_.app().types(), style_);
        scene_.renderer().request_aov("line_opacity");
        scene_.renderer().request_aov("color");
        scene_.renderer().render_frame();
    }

    [[nodiscard]] const Style& style() const { return style_; }

    /// Pixels of lines.
    [[nodiscard]] double lines() { return sum(scene_.renderer().read_aov("line_opacity")); }

    [[nodiscard]] bool on_paper() { return scene_.world().has<Paper>(camera_); }

    /// What became of the pass that draws the paper; of a picture drawn anew.
    [[nodiscard]] bool paper_is_drawn() {
        for (const gpu::PassStats& pass : scene_.renderer().pass_stats())
            if (pass.name == "paper") return pass.state == gpu::PassState::run;
        return false;
    }

    /// Pixels that are not as the one in the corner.
    [[nodiscard]] std::size_t drawn_pixels() {
        const assets::Image image = scene_.renderer().read_aov("color");
        std::size_t count = 0;
        for (int i = 0; i < image.width * image.height; ++i) {
            const float* pixel = image.f32() + 3 * i;
            EXPECT_TRUE(std::isfinite(pixel[0] + pixel[1] + pixel[2]));
            count += std::equal(pixel, pixel + 3, image.f32()) ? 0 : 1;
        }
        return count;
    }

private:
    static double sum(const assets::Image& image) {
        double result = 0.0;
        for (int i = 0; i < image.width * image.height * image.channels; ++i) result += double(image.f32()[i]);
        return result;
    }

    DrawnScene scene_;
    Entity camera_ = Entity::null;
    Style style_;
};

using LinesLookTest = GlTest;

TEST_P(LinesLookTest, EveryPresetParsesAndDraws) {
    ASSERT_GE(presets().size(), 15u);
    for (const std::filesystem::path& file : presets()) {
        SCOPED_TRACE(file.filename().string());
        Look look(context(), file);
        EXPECT_EQ(look.style().name, file.stem().string());
        EXPECT_NE(look.style().doc.find("figure"), std::string::npos) << look.style().doc;
        EXPECT_GT(look.lines(), 50.0);
        EXPECT_GT(look.drawn_pixels(), 200u);
        EXPECT_EQ(look.paper_is_drawn(), look.on_paper());
    }
}

/// Figure 4: the larger beta, the fewer edges of tones are lines.
TEST_P(LinesLookTest, BetaTakesEdgesAway) {
    const double all = Look(context(), folder / "beta_0.json").lines();
    const double strong = Look(context(), folder / "beta_20.json").lines();
    const double none = Look(context(), folder / "beta_100.json").lines();
    EXPECT_GT(all, 1.02 * strong);
    EXPECT_GT(strong, none);
}

/// Figure 5: a soft threshold lets weak lines come faintly, fading thins lines, counterchange takes from light places.
TEST_P(LinesLookTest, OpacityIsControlledAsInFigure5) {
    const double soft = Look(context(), folder / "soft.json").lines();
    EXPECT_LT(Look(context(), folder / "faded.json").lines(), 0.9 * soft);
    EXPECT_LT(Look(context(), folder / "counterchange.json").lines(), 0.9 * soft);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(LinesLookTest);

} // namespace
} // namespace hachure::test
