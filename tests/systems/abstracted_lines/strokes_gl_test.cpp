#include <hachure/components/abstracted_lines.h>
#include <hachure/components/light.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/parallel.h>
#include <hachure/runtime/scene/stroke_set.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/temp_folder.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

namespace hachure::test {
namespace {

class Strokes : public GlTest {
protected:
    /// Two tori seen from the front, with lines.
    struct Scene {
        DrawnScene drawn;
        Entity left, right;

        Scene(gpu::Context& context, const AbstractedLines& lines, double yaw = 20.0, glm::vec3 shift = glm::vec3(0.0f))
            : drawn(context, {320, 240}) {
            drawn.add(Camera{}, Transform{.translation = {0.0f, 0.0f, 6.0f}});
            const auto turn = glm::angleAxis(static_cast<float>(yaw * 0.0174532925), glm::vec3(0.3f, 0.9f, 0.1f));
            const SurfaceMesh mesh = surface_mesh(geometry::torus(1.0, 0.4, 96, 48));
            left = drawn.add(mesh, Transform{.translation = glm::vec3(-1.2f, 0.2f, 0.0f) + shift, .rotation = turn});
            right = drawn.add(mesh, Transform{.translation = {1.5f, -0.3f, -0.5f}, .rotation = turn});
            drawn.world().add(left, lines);
            drawn.world().add(right, lines);
        }
        [[nodiscard]] const StrokeSet& set() { return drawn.world().resource<StrokeSet>(); }
    };

    static AbstractedLines stroked() {
        AbstractedLines lines;
        lines.method = ToneLineMethod::strokes;
        lines.counterchange = 0.0f;
        return lines;
    }
};

bool same(const StrokeSet& a, const StrokeSet& b) {
    const auto equal_points = [](const geometry::LinePoint& p, const geometry::LinePoint& q) {
        return p.place == q.place && p.width == q.width && p.opacity == q.opacity;
    };
    const auto equal_strokes = [](const Stroke& s, const Stroke& t) {
        return s.entity == t.entity && s.kind == t.kind && s.line.first == t.line.first &&
               s.line.count == t.line.count && s.line.closed == t.line.closed && s.phase.ahead == t.phase.ahead &&
               s.phase.fraction == t.phase.fraction && s.phase.weights == t.phase.weights &&
               s.phase.turn == t.phase.turn;
    };
    return std::ranges::equal(a.points, b.points, equal_points) &&
           std::ranges::equal(a.strokes, b.strokes, equal_strokes);
}

TEST_P(Strokes, LieWherePixelsDrawLines) {
    AbstractedLines lines = stroked();
    lines.taper = 0.0f;
    lines.texture_strength = 0.0f;
    Scene strokes(context(), lines);
    strokes.drawn.renderer().request_aov("line_layer");
    strokes.drawn.renderer().render_frame();
    const assets::Image drawn = strokes.drawn.renderer().read_aov("line_layer");
    lines.method = ToneLineMethod::pixels;
    Scene pixels(context(), lines);
    pixels.drawn.renderer().request_aov("line_layer");
    pixels.drawn.renderer().render_frame();
    const assets::Image wanted = pixels.drawn.renderer().read_aov("line_layer");
    ASSERT_GT(strokes.set().strokes.size(), 3u);
    int lined = 0, missing = 0, elsewhere = 0;
    const auto opacity = [](const assets::Image& image, int x, int y) {
        return image.f32()[4 * static_cast<std::size_t>(y * image.width + x) + 3];
    };
    const auto near = [&](const assets::Image& image, int x, int y, float least) {
        for (int j = std::max(0, y - 2); j <= std::min(image.height - 1, y + 2); ++j)
            for (int i = std::max(0, x - 2); i <= std::min(image.width - 1, x + 2); ++i)
                if (opacity(image, i, j) >= least) return true;
        return false;
    };
    for (int y = 0; y < wanted.height; ++y)
        for (int x = 0; x < wanted.width; ++x) {
            lined += opacity(wanted, x, y) >= 0.5f;
            missing += opacity(wanted, x, y) >= 0.5f && opacity(drawn, x, y) < 0.1f;
            elsewhere += opacity(drawn, x, y) >= 0.5f && !near(wanted, x, y, 0.1f);
        }
    EXPECT_GT(lined, 400);
    EXPECT_LE(missing, lined / 50) << "spurs are left out";
    EXPECT_LE(elsewhere, lined / 50) << "gaps are closed";
}

TEST_P(Strokes, AreTheSameInEveryRunAndOnAnyNumberOfThreads) {
    Scene first(context(), stroked());
    const assets::Image picture = first.drawn.draw();
    ASSERT_GT(first.set().strokes.size(), 3u);
    set_thread_limit(1);
    Scene alone(context(), stroked());
    const assets::Image again = alone.drawn.draw();
    set_thread_limit(4);
    Scene many(context(), stroked());
    static_cast<void>(many.drawn.draw());
    EXPECT_EQ(picture.pixels, again.pixels);
    EXPECT_TRUE(same(first.set(), alone.set()));
    EXPECT_TRUE(same(first.set(), many.set()));
}

TEST_P(Strokes, OfASceneThatStandsStillAreMadeOnce) {
    Scene scene(context(), stroked());
    EXPECT_EQ(scene.drawn.draw_passes().at("strokes"), gpu::PassState::run);
    const StrokeSet before = scene.set();
    const auto states = scene.drawn.draw_passes();
    EXPECT_EQ(states.at("strokes"), gpu::PassState::reused);
    EXPECT_EQ(states.at("stroke_lines"), gpu::PassState::reused);
    EXPECT_TRUE(same(before, scene.set()));
}

TEST_P(Strokes, AreMadeForThoseWhoWantThem) {
    AbstractedLines lines;
    lines.counterchange = 0.0f;
    Scene scene(context(), lines);
    EXPECT_FALSE(scene.drawn.draw_passes().contains("strokes"));
    EXPECT_TRUE(scene.set().strokes.empty());
    scene.drawn.world().resource_mutable<StrokeSet>().wanted = true;
    const auto states = scene.drawn.draw_passes();
    EXPECT_EQ(states.at("strokes"), gpu::PassState::run);
    EXPECT_FALSE(states.contains("stroke_lines")) << "pixels draw them";
    ASSERT_FALSE(scene.set().strokes.empty());
    EXPECT_FALSE(scene.set().strokes.front().drawn);
    // Two entities, each with its own.
    const auto of = [&](Entity entity) { return std::ranges::count(scene.set().strokes, entity, &Stroke::entity); };
    EXPECT_GT(of(scene.left), 0);
    EXPECT_GT(of(scene.right), 0);
    scene.drawn.world().destroy(scene.left);
    scene.drawn.renderer().render_frame();
    EXPECT_EQ(of(scene.left), 0);
    EXPECT_GT(of(scene.right), 0);
    scene.drawn.world().resource_mutable<StrokeSet>().wanted = false;
    scene.drawn.renderer().render_frame();
    EXPECT_TRUE(scene.set().strokes.empty());
}

/// The texture is nailed to what moves: an entity that is shifted across the picture takes it along.
TEST_P(Strokes, TexturesMoveWithTheirEntity) {
    Scene here(context(), stroked()), there(context(), stroked(), 20.0, {0.05f, -0.03f, 0.0f});
    static_cast<void>(here.drawn.draw());
    static_cast<void>(there.drawn.draw());
    // 0.05 m of 6 m away, as the default camera sees it.
    const View& view = here.drawn.world().resource<View>();
    const glm::vec2 shift = glm::vec2(0.05f, -0.03f) / (6.0f * view.pixel_size);
    int compared = 0, slid = 0;
    for (const Stroke& a : here.set().strokes) {
        if (a.entity != here.left || a.line.length < 12.0f) continue;
        for (const Stroke& b : there.set().strokes) {
            if (b.kind != a.kind || b.entity != there.left || std::abs(a.line.length - b.line.length) > 2.0f) continue;
            const glm::vec2 p = here.set().points[a.line.first].place + shift;
            if (glm::distance(p, there.set().points[b.line.first].place) > 1.5f) continue;
            int axis = 0;
            for (int i = 1; i < 3; ++i)
                if (a.phase.weights[i] > a.phase.weights[axis]) axis = i;
            const float u = a.phase.ahead[axis] - a.phase.fraction[axis] * a.line.length;
            const float v = b.phase.ahead[axis] - b.phase.fraction[axis] * b.line.length;
            ++compared;
            slid += std::abs(u - v) > 2.5f; // of a period of 96 pixels; perspective and ends have their share
        }
    }
    EXPECT_GT(compared, 1);
    EXPECT_LE(slid, compared / 4);
}

TEST_P(Strokes, TakeTheirTextureFromAFile) {
    const TempFolder folder;
    assets::Image white = assets::make_image(8, 4, 3, assets::PixelType::u8);
    std::ranges::fill(white.pixels, std::byte{255});
    assets::write_png(folder / "white.png", white);
    AbstractedLines lines = stroked();
    lines.texture_strength = 1.0f;
    lines.stroke_texture = (folder / "white.png").string();
    Scene scene(context(), lines);
    scene.drawn.renderer().request_aov("line_layer");
    scene.drawn.renderer().render_frame();
    const assets::Image layer = scene.drawn.renderer().read_aov("line_layer");
    const float* values = layer.f32();
    EXPECT_TRUE(std::all_of(values, values + 4 * layer.width * layer.height, [](float v) { return v < 1e-3f; }))
        << "white is no ink";
    lines.stroke_texture = (folder / "none.png").string();
    scene.drawn.world().add(scene.left, lines);
    EXPECT_THROW(scene.drawn.renderer().render_frame(), Error);
}

HACHURE_INSTANTIATE_GL_TESTS(Strokes);

} // namespace
} // namespace hachure::test
