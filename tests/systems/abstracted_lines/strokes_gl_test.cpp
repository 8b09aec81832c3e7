#include <hachure/components/abstracted_lines.h>
#include <hachure/components/light.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/parallel.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/stroke_set.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/temp_folder.h>

#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

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

/// A place on a stroke of the left torus.
struct Mark {
    glm::vec2 place;
    StrokeKind kind;
    int axis;     ///< that its texture follows most
    double along; ///< the texture's coordinate there, pixels, as it shows
    glm::vec3 on_entity;
};

double shown(const Stroke& stroke, int axis, double arc) {
    const double u =
        arc + double(stroke.phase.ahead[axis]) - double(stroke.phase.fraction[axis]) * double(stroke.line.length);
    if (!stroke.line.closed) return std::abs(u);
    const double round = double(stroke.line.length), d = u - round * std::floor(u / round);
    return std::min(d, round - d);
}

int main_axis(const geometry::StrokePhase& phase) {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (phase.weights[i] > phase.weights[axis]) axis = i;
    return axis;
}

/// Every three pixels of strokes of some length and opacity, with where on the entity they are by the AOV `depth`.
std::vector<Mark> marks_of(DrawnScene& drawn, Entity entity, const glm::mat4& entity_from_world) {
    const StrokeSet& set = drawn.world().resource<StrokeSet>();
    const View& view = drawn.world().resource<View>();
    const assets::Image depth = drawn.renderer().read_aov("depth");
    std::vector<Mark> marks;
    for (const Stroke& stroke : set.strokes) {
        if (stroke.entity != entity || stroke.line.length < 15.0f) continue;
        double arc = 0.0;
        for (std::uint32_t i = stroke.line.first + 1; i < stroke.line.first + stroke.line.count; ++i) {
            const geometry::LinePoint &a = set.points[i - 1], &b = set.points[i];
            const double length = double(glm::distance(a.place, b.place));
            for (double at = std::ceil(arc / 3.0) * 3.0; at < arc + length; at += 3.0) {
                const glm::vec2 p = glm::mix(a.place, b.place, static_cast<float>((at - arc) / length));
                const auto pixel = static_cast<std::size_t>((set.height - 1 - static_cast<int>(p.y)) * set.width +
                                                            static_cast<int>(p.x));
                const float away = depth.f32()[pixel];
                if (away > 100.0f || std::min(a.opacity, b.opacity) < 0.3f) continue;
                const glm::vec2 middle = p - 0.5f * glm::vec2(set.width, set.height);
                const glm::vec3 seen(middle * view.pixel_size * away, -away);
                const glm::vec3 world(glm::inverse(view.view_from_world) * glm::vec4(seen, 1.0f));
                const int axis = main_axis(stroke.phase);
                marks.push_back({p, stroke.kind, axis, shown(stroke, axis, at),
                                 glm::vec3(entity_from_world * glm::vec4(world, 1.0f))});
            }
            arc += length;
        }
    }
    return marks;
}

/// How far textures slide over the entity from one frame to the next, pixels, ascending.
std::vector<double> slips(const std::vector<Mark>& before, const std::vector<Mark>& after,
                          const glm::mat4& clip_from_entity, glm::vec2 viewport) {
    std::vector<double> result;
    for (const Mark& mark : before) {
        const glm::vec4 clip = clip_from_entity * glm::vec4(mark.on_entity, 1.0f);
        const glm::vec2 expected = (0.5f * glm::vec2(clip) / clip.w + 0.5f) * viewport;
        const Mark* nearest = nullptr;
        for (const Mark& other : after)
            if (other.kind == mark.kind &&
                (!nearest || glm::distance(other.place, expected) < glm::distance(nearest->place, expected)))
                nearest = &other;
        // Marks are three pixels apart along the line; what is farther went elsewhere, as lines of tone do.
        if (!nearest || nearest->axis != mark.axis || glm::distance(nearest->place, expected) > 3.0f) continue;
        result.push_back(
            std::max(0.0, std::abs(nearest->along - mark.along) - double(glm::distance(nearest->place, expected))));
    }
    std::ranges::sort(result);
    return result;
}

/// The texture is nailed to what moves: an entity that turns or is shifted takes it along. A line that splits slides by
/// more; at a degree a frame one does.
TEST_P(Strokes, TexturesMoveWithTheirEntity) {
    const auto measure = [&](double degrees, glm::vec3 shift) {
        std::vector<double> all;
        std::vector<Mark> before;
        for (int frame = 0; frame < 5; ++frame) {
            Scene scene(context(), stroked(), 20.0 + degrees * frame, static_cast<float>(frame) * shift);
            scene.drawn.renderer().request_aov("depth");
            scene.drawn.renderer().render_frame();
            const DrawList& list = scene.drawn.world().resource<DrawList>();
            const auto item = std::ranges::find(list.items, scene.left, &DrawItem::entity);
            const View& view = scene.drawn.world().resource<View>();
            std::vector<Mark> marks = marks_of(scene.drawn, scene.left, glm::inverse(item->world_from_entity));
            if (frame > 0) {
                const std::vector<double> found =
                    slips(before, marks, view.clip_from_world * item->world_from_entity, {view.width, view.height});
                all.insert(all.end(), found.begin(), found.end());
            }
            before = std::move(marks);
        }
        std::ranges::sort(all);
        return all;
    };
    struct Motion {
        const char* name;
        double degrees;
        glm::vec3 shift;
        double median, most_of; ///< pixels: of half the marks, and of nine tenths
    };
    for (const Motion& motion :
         {Motion{"shift of 3 px", 0.0, {0.07f, 0.02f, 0.0f}, 2.0, 8.0}, Motion{"turn of 1 degree", 1.0, {}, 6.0, 14.0},
          Motion{"turn of 1/2 degree", 0.5, {}, 1.0, 6.0},
          Motion{"towards the eye by 1 %", 0.0, {0.0f, 0.0f, 0.06f}, 1.5, 8.0}}) {
        const std::vector<double> found = measure(motion.degrees, motion.shift);
        ASSERT_GT(found.size(), 100u) << motion.name;
        const double median = found[found.size() / 2], most_of = found[found.size() * 9 / 10];
        const auto jumped = std::ranges::count_if(found, [](double slip) { return slip > 12.0; });
        RecordProperty(motion.name, std::to_string(median) + " px, nine tenths " + std::to_string(most_of) +
                                        ", jumped " + std::to_string(jumped) + " of " + std::to_string(found.size()));
        EXPECT_LE(median, motion.median) << motion.name;
        EXPECT_LE(most_of, motion.most_of) << motion.name << ": of a period of 120";
        EXPECT_LE(jumped, static_cast<std::ptrdiff_t>(found.size() / 10))
            << motion.name << ": lines that split or merge";
    }
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

HACHURE_INSTANTIATE_GL_TESTS_ONCE(Strokes);

} // namespace
} // namespace hachure::test
