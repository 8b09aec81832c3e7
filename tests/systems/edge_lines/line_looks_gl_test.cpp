#include <hachure/components/edge_lines.h>
#include <hachure/tests/support/drawn_scene.h>
#include <hachure/tests/support/gl_fixture.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

// How lines look: width in each unit, taper, colours, hidden lines, highlights, lines from the picture.
namespace hachure::test {
namespace {

const glm::quat upright = glm::angleAxis(1.5707963f, glm::vec3(1, 0, 0));

/// RGBA of the AOV line_layer, or another of its kind.
struct Layer {
    assets::Image image;

    [[nodiscard]] glm::vec4 at(int column, int row) const { // from the upper left corner
        const float* p = image.f32() + 4 * (row * image.width + column);
        return {p[0], p[1], p[2], p[3]};
    }
    /// Coverage of one row between two columns, added up: the width of what crosses it there.
    [[nodiscard]] double across(int row, int first, int last) const {
        double sum = 0.0;
        for (int column = first; column < last; ++column) sum += double(at(column, row).a);
        return sum;
    }
    [[nodiscard]] double total() const {
        double sum = 0.0;
        for (int row = 0; row < image.height; ++row) sum += across(row, 0, image.width);
        return sum;
    }
};

/// A world seen by one camera.
class LookStage {
public:
    LookStage(gpu::Context& context, Canvas canvas, const Camera& camera, const Transform& place)
        : scene_(context, canvas) {
        scene_.add(camera, place);
        scene_.renderer().request_aov("line_layer");
        scene_.renderer().request_aov("hidden_lines");
    }

    Entity add(const geometry::Shape& shape, const EdgeLines& lines, const Transform& place = {},
               bool double_sided = true) {
        SurfaceMaterial material;
        material.double_sided = double_sided;
        const Entity entity = scene_.add(surface_mesh(shape, material), place);
        scene_.world().add(entity, lines);
        return entity;
    }

    Layer draw(const char* aov = "line_layer") {
        scene_.renderer().render_frame();
        return {scene_.renderer().read_aov(aov)};
    }

    DrawnScene& scene() { return scene_; }

private:
    DrawnScene scene_;
};

using LineLooksTest = GlTest;

/// The upright left border of a square a metre wide, whose middle is `depth` before the camera.
double border_width(gpu::Context& context, Canvas canvas, const Camera& camera, float depth, const EdgeLines& lines) {
    LookStage stage(context, canvas, camera, {.translation = {0, 0, depth}});
    stage.add(geometry::plane(1.0, 1), lines, {.translation = {0.5f, 0, 0}, .rotation = upright});
    const Layer layer = stage.draw();
    return layer.across(canvas.height / 2, canvas.width / 4, canvas.width / 2 + canvas.width / 8);
}

TEST_P(LineLooksTest, WidthInPixelsIsThatAtAnySizeDistanceAndAngleOfView) {
    const EdgeLines lines{.width = 3.0f};
    for (const int height : {120, 240, 400})
        for (const float depth : {2.0f, 5.0f})
            for (const float yfov : {0.4f, 0.9f})
                EXPECT_NEAR(border_width(context(), {height, height}, {.yfov = yfov}, depth, lines), 3.0, 0.1);
}

TEST_P(LineLooksTest, WidthInThousandthsOfThePictureGrowsWithIt) {
    const EdgeLines lines{.width = 10.0f, .width_unit = LineWidthUnit::picture};
    for (const int height : {150, 300, 600})
        for (const float depth : {2.0f, 4.0f})
            EXPECT_NEAR(border_width(context(), {height, height}, {.yfov = 0.5f}, depth, lines), 0.01 * height, 0.1);
}

TEST_P(LineLooksTest, WidthInTheWorldIsTrueToDistanceAngleOfViewAndSize) {
    const EdgeLines lines{.width = 0.05f, .width_unit = LineWidthUnit::world};
    for (const int height : {200, 400})
        for (const float depth : {2.0f, 5.0f})
            for (const float yfov : {0.4f, 0.9f}) {
                const double pixels = 0.05 * height / (2.0 * double(depth) * std::tan(0.5 * double(yfov)));
                EXPECT_NEAR(border_width(context(), {height, height}, {.yfov = yfov}, depth, lines), pixels, 0.1);
            }
    const Camera flat{.projection = Projection::orthographic, .ymag = 1.5f, .zfar = 100.0f};
    EXPECT_NEAR(border_width(context(), {300, 300}, flat, 7.0f, lines), 0.05 * 100, 0.1);
}

/// A rod that runs away from the eye: its line gets thinner as the distance grows, from end to end.
TEST_P(LineLooksTest, ALineInTheWorldThinsOutWithDistance) {
    LookStage stage(context(), {200, 200}, {.yfov = 0.9f}, {.translation = {0, 0.6f, 3.0f}});
    geometry::Shape strip;
    strip.positions = {{0, 0, 1}, {0, 0, -20}, {3, 0, -20}, {3, 0, 1}};
    strip.normals.assign(4, {0, 1, 0});
    strip.indices = {0, 3, 2, 0, 2, 1};
    stage.add(strip, {.width = 0.08f, .width_unit = LineWidthUnit::world});
    const Layer layer = stage.draw();
    const double pixels_at_1 = 200 / (2.0 * std::tan(0.45));
    for (const double depth : {4.0, 6.0, 10.0}) {
        const int row = static_cast<int>(100.0 + 0.6 / depth * pixels_at_1);
        const double here = 0.6 / ((row + 0.5 - 100.0) / pixels_at_1);
        EXPECT_NEAR(layer.across(row, 60, 110), 0.08 * pixels_at_1 / here, 0.12) << "at " << depth << " m";
    }
}

TEST_P(LineLooksTest, TaperThinsOutTheEndsAndNotTheMiddle) {
    const Camera camera{.projection = Projection::orthographic, .ymag = 1.0f, .zfar = 100.0f};
    for (const LineVisibility visibility : {LineVisibility::depth, LineVisibility::exact}) {
        LookStage stage(context(), {200, 200}, camera, {.translation = {0, 0, 5}});
        geometry::Shape fan = geometry::plane(1.0, 1); // a square; all its sides are one line
        stage.add(fan, {.width = 6.0f, .taper = 5.0f, .visibility = visibility}, {.rotation = upright});
        EXPECT_NEAR(stage.draw().across(100, 20, 80), 6.0, 0.15) << "a closed line has no ends";

        // A roof: its ridge is a crease that begins and ends.
        LookStage open(context(), {200, 200}, camera, {.translation = {0, 0, 5}});
        geometry::Shape roof;
        roof.positions = {{0, -0.8f, 0},         {0, 0.8f, 0},         {-0.5f, 0.8f, -0.8f},
                          {-0.5f, -0.8f, -0.8f}, {0.5f, -0.8f, -0.8f}, {0.5f, 0.8f, -0.8f}};
        roof.normals.assign(6, {0, 0, 1});
        roof.indices = {0, 1, 2, 0, 2, 3, 0, 4, 5, 0, 5, 1};
        open.add(roof, {.border = false, .width = 6.0f, .taper = 5.0f, .visibility = visibility});
        const Layer layer = open.draw();
        EXPECT_NEAR(layer.across(100, 90, 110), 6.0, 0.15);
        EXPECT_NEAR(layer.across(60, 90, 110), 6.0, 0.15); // 40 pixels from the end, past the 30 of the taper
        for (const int row : {25, 30, 40})                 // .5 + row - 20 pixels from it
            EXPECT_NEAR(layer.across(row, 90, 110), 6.0 * std::sqrt((row - 19.5) / 30.0), 0.3) << row;
    }
}

TEST_P(LineLooksTest, EveryKindHasItsColourAndTheLaterKindLiesOnTop) {
    LookStage stage(context(), {200, 200}, {.yfov = 0.5f},
                    {.translation = {2.2f, 2.0f, 2.6f},
                     .rotation = glm::quatLookAt(glm::normalize(glm::vec3(-2.2f, -2.0f, -2.6f)), glm::vec3(0, 1, 0))});
    EdgeLines lines{.width = 4.0f, .color = {1, 0, 0}, .color_by_kind = true, .crease_color = {0, 0, 1}};
    const Entity cube = stage.add(geometry::cube(1.0), lines, {}, false);
    const Layer layer = stage.draw();
    int red = 0, blue = 0, mixed = 0;
    for (int row = 0; row < 200; ++row)
        for (int column = 0; column < 200; ++column) {
            const glm::vec4 p = layer.at(column, row);
            if (p.a < 0.99f) continue;
            EXPECT_EQ(p.g, 0.0f);
            red += p.r > 0.99f && p.b < 0.01f ? 1 : 0;
            blue += p.b > 0.99f && p.r < 0.01f ? 1 : 0;
            mixed += p.r > 0.99f && p.b > 0.01f ? 1 : 0; // a maximum of both would be purple
        }
    EXPECT_GT(red, 600);
    EXPECT_GT(blue, 300);
    EXPECT_EQ(mixed, 0);
    // Creases as highlights: white instead of blue.
    lines.crease_highlight = true;
    stage.scene().world().get_mutable<EdgeLines>(cube) = lines;
    const Layer light = stage.draw();
    int white = 0;
    for (int row = 0; row < 200; ++row)
        for (int column = 0; column < 200; ++column) white += light.at(column, row) == glm::vec4(1.0f) ? 1 : 0;
    EXPECT_GT(white, 300);
    EXPECT_LT(std::abs(white - blue), 30);
}

TEST_P(LineLooksTest, WhereLinesOfOneColourMeetNothingGetsDarkerOrLighter) {
    LookStage stage(context(), {200, 200}, {.yfov = 0.5f}, {.translation = {0, 0, 5}});
    stage.add(geometry::uv_sphere(1.0, 64, 32), {.crease = false, .width = 5.0f, .color = {0.25f, 0.5f, 0.75f}});
    const Layer layer = stage.draw();
    for (int row = 0; row < 200; ++row)
        for (int column = 0; column < 200; ++column) {
            const glm::vec4 p = layer.at(column, row);
            ASSERT_LE(p.a, 1.0f);
            ASSERT_LE(glm::length(glm::vec3(p) - p.a * glm::vec3(0.25f, 0.5f, 0.75f)), 2e-3f);
        }
}

/// A wall that covers the left half of a square behind it.
struct HalfHidden {
    HalfHidden(gpu::Context& context, const EdgeLines& lines)
        : stage(context, {200, 200}, {.projection = Projection::orthographic, .ymag = 1.0f, .zfar = 100.0f},
                {.translation = {0, 0, 5}}) {
        stage.add(geometry::plane(1.2, 1), lines, {.rotation = upright});
        stage.scene().world().remove<EdgeLines>(
            stage.add(geometry::plane(4.0, 1), {}, {.translation = {-2.0f, 0, 1}, .rotation = upright}));
    }
    LookStage stage;
};

TEST_P(LineLooksTest, HiddenLinesAreNoneDashedOrSolidAndALayerOfTheirOwn) {
    for (const LineVisibility visibility : {LineVisibility::depth, LineVisibility::exact})
        for (const HiddenLines hidden : {HiddenLines::none, HiddenLines::dashed, HiddenLines::solid}) {
            SCOPED_TRACE(testing::Message() << "hidden " << int(hidden) << " visibility " << int(visibility));
            HalfHidden half(context(), {.width = 4.0f,
                                        .color = {1, 0, 0},
                                        .hidden = hidden,
                                        .hidden_color = {0, 0, 1},
                                        .hidden_width = 0.5f,
                                        .dash = 5.0f,
                                        .visibility = visibility});
            const Layer layer = half.stage.draw(), apart = half.stage.draw("hidden_lines");
            // The right side is seen, the left one is hidden: 120 pixels of each.
            double seen = 0.0, behind = 0.0, own = 0.0;
            for (int row = 45; row < 155; ++row) {
                seen += layer.across(row, 150, 170) / 110;
                behind += layer.across(row, 30, 50) / 110;
                own += apart.across(row, 30, 50) / 110;
                EXPECT_EQ(apart.across(row, 150, 170), 0.0);
            }
            EXPECT_NEAR(seen, 4.0, 0.1);
            const double expected = hidden == HiddenLines::none ? 0.0 : hidden == HiddenLines::solid ? 2.0 : 1.0;
            EXPECT_NEAR(behind, expected, 0.15);
            EXPECT_NEAR(own, hidden == HiddenLines::dashed ? 1.0 : 2.0, 0.15);
            if (hidden == HiddenLines::dashed) {
                int full = 0, empty = 0;
                for (int row = 45; row < 155; ++row) {
                    full += layer.across(row, 30, 50) > 1.9 ? 1 : 0;
                    empty += layer.across(row, 30, 50) < 0.1 ? 1 : 0;
                }
                EXPECT_GT(full, 30);
                EXPECT_GT(empty, 30);
            }
        }
}

/// Where a box stands on a floor, in one plane with it, its line is whole.
TEST_P(LineLooksTest, ABoxOnAFloorHasAWholeFoot) {
    for (const LineVisibility visibility : {LineVisibility::depth, LineVisibility::exact})
        for (const float turn : {0.0f, 0.3f, 0.7f})
            for (const float height : {0.5f, 1.5f, 4.0f}) {
                const glm::vec3 eye(0.3f, height, 4.0f);
                const glm::quat look = glm::quatLookAt(glm::normalize(glm::vec3(0, 0.4f, 0) - eye), glm::vec3(0, 1, 0));
                LookStage stage(context(), {240, 180}, {.yfov = 0.6f}, {.translation = eye, .rotation = look});
                stage.add(geometry::plane(20.0, 1), {.border = false}, {});
                const glm::quat turned = glm::angleAxis(turn, glm::vec3(0, 1, 0));
                stage.add(geometry::cube(1.0), {.width = 1.0f, .visibility = visibility},
                          {.translation = {0, 0.5f, 0}, .rotation = turned}, false);
                const Layer layer = stage.draw();
                const double pixels = 90.0 / std::tan(0.3);
                for (const float x : {-0.5f, 0.5f}) // the foot of the side that looks at the eye, from its middle
                    for (double t = 0.02; t < 0.98; t += 0.01) {
                        const glm::vec3 foot = turned * glm::vec3(x * float(t), 0.0f, 0.5f);
                        const glm::vec3 p = glm::inverse(look) * (foot - eye);
                        const double column = 120.0 - double(p.x / p.z) * pixels,
                                     row = 90.0 + double(p.y / p.z) * pixels;
                        double most = 0.0;
                        for (int dy = -1; dy <= 1; ++dy)
                            for (int dx = -1; dx <= 1; ++dx) {
                                const int c = static_cast<int>(std::floor(column)) + dx,
                                          r = static_cast<int>(std::floor(row)) + dy;
                                most = std::max(most, double(layer.at(c, r).a));
                            }
                        ASSERT_GE(most, 0.5) << "a gap at " << column << ", " << row << ", turned by " << turn
                                             << " from " << height << " m";
                    }
            }
}

/// Moving everything by whole pixels moves the lines by them and changes nothing else.
TEST_P(LineLooksTest, LinesMoveWithThePicture) {
    const Camera camera{.projection = Projection::orthographic, .ymag = 1.0f, .zfar = 100.0f};
    for (const LineMethod method : {LineMethod::mesh, LineMethod::image}) {
        const auto draw = [&](int right, int up) {
            LookStage stage(context(), {200, 200}, camera,
                            {.translation = {-0.01f * float(right), -0.01f * float(up), 5}});
            stage.add(geometry::torus(0.4, 0.15, 48, 24), {.method = method},
                      {.rotation = glm::angleAxis(0.9f, glm::normalize(glm::vec3(1, 0.4f, 0.2f)))});
            return stage.draw();
        };
        const Layer here = draw(0, 0), there = draw(7, 3);
        double most = 0.0;
        for (int row = 10; row < 190; ++row)
            for (int column = 10; column < 190; ++column)
                most = std::max(most, std::abs(double(here.at(column, row).a - there.at(column + 7, row - 3).a)));
        EXPECT_LT(most, 0.02) << "method " << int(method);
        EXPECT_GT(here.total(), 300.0);
    }
}

TEST_P(LineLooksTest, LinesFromThePictureFollowStepsOfDepthObjectsAndCreases) {
    const Camera camera{.projection = Projection::orthographic, .ymag = 1.0f, .zfar = 100.0f};
    LookStage stage(context(), {200, 200}, camera, {.translation = {0, 0, 5}});
    const EdgeLines lines{.width = 3.0f, .color = {1, 0, 0}, .method = LineMethod::image};
    const Entity cube =
        stage.add(geometry::cube(1.0), lines, {.rotation = glm::angleAxis(0.785398f, glm::vec3(0, 1, 0))}, false);
    const Layer layer = stage.draw();
    // The outline at -.707 and .707, and the crease between its two sides.
    for (const int column : {29, 100, 170}) EXPECT_NEAR(layer.across(100, column - 8, column + 8), 3.0, 0.5) << column;
    EXPECT_NEAR(layer.across(100, 40, 90), 0.0, 1e-6);
    // An object without lines has none, and hides those of others.
    stage.scene().world().remove<EdgeLines>(
        stage.add(geometry::plane(4.0, 1), {}, {.translation = {-2.0f, 0, 1}, .rotation = upright}));
    EXPECT_EQ(stage.draw().at(29, 100).a, 0.0f);
    stage.scene().world().get_mutable<EdgeLines>(cube).width = 0.0f;
    EXPECT_EQ(stage.draw().total(), 0.0);
}

/// Pictures that are no whole number of tiles: a crease goes from rim to rim in all of them.
TEST_P(LineLooksTest, LinesFromThePictureReachItsRims) {
    const Camera camera{.projection = Projection::orthographic, .ymag = 1.0f, .zfar = 100.0f};
    const glm::quat turned = glm::angleAxis(0.785398f, glm::vec3(0, 1, 0));
    for (const bool lying : {false, true})
        for (int size = 60; size < 68; ++size) {
            LookStage stage(context(), {size, size}, camera, {.translation = {0, 0, 5}});
            stage.add(geometry::cube(4.0), {.width = 3.0f, .method = LineMethod::image},
                      {.rotation = lying ? glm::angleAxis(1.5707963f, glm::vec3(0, 0, 1)) * turned : turned}, false);
            const Layer layer = stage.draw();
            for (int along = 0; along < size; ++along) {
                double across = 0.0;
                for (int i = 0; i < size; ++i) across += double(lying ? layer.at(along, i).a : layer.at(i, along).a);
                ASSERT_NEAR(across, 3.0, 0.5) << "at " << along << " of " << size << ", lying " << lying;
            }
        }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(LineLooksTest);

} // namespace
} // namespace hachure::test
