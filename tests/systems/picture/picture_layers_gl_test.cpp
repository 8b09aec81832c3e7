// Normals and depth that pictures carry, as others read them, and numbered images.

#include <hachure/runtime/assets/layered_image.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/picture/picture_place.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "../../support/gl_fixture.h"
#include "layered_picture.h"
#include "picture_scene.h"

namespace hachure::test {
namespace {

constexpr Canvas canvas{24, 16};

/// A view in which somebody reads textures of pictures.
class ReadScene : public PictureScene {
public:
    ReadScene(gpu::Context& context, const std::vector<std::string>& names, const Canvas& size = canvas)
        : PictureScene(context, size) {
        app().add_system(Stage::material, "asks",
                         [names](FrameRequests& requests) { requests.textures.insert(names.begin(), names.end()); });
        app().add_system(Stage::render, "reads", [names](World& world) {
            gpu::FrameGraph& graph = world.resource_mutable<RenderContext>().graph;
            for (const std::string& name : names)
                if (const gpu::TextureHandle texture = graph.find(name)) graph.require(texture);
        });
    }

    /// Of the last frame, rows from the top.
    std::vector<float> read(const std::string& name) {
        RenderContext& render = world().resource_mutable<RenderContext>();
        return render.backend->texture(render.graph.texture(render.graph.find(name))).read_floats();
    }
};

/// A pixel that is like no other; a few are empty.
LayeredPixel numbered_pixel(int x, int y) {
    if ((x + y) % 7 == 0) return {};
    const float turn = 0.1f * float(x) - 0.2f * float(y);
    return {.normal = {std::cos(turn) * 0.6f, std::sin(turn) * 0.6f, 0.8f},
            .depth = 1.0f + float(x) + 100.0f * float(y)};
}

using PictureLayersTest = GlTest;

TEST_P(PictureLayersTest, AtItsOwnSizeTheyAreTheFiles) {
    const TempFolder folder;
    write_layers(folder / "i.exr", canvas.width, canvas.height, numbered_pixel);
    ReadScene scene(context(), {"picture_normal", "picture_depth"});
    scene.show({.file = (folder / "i.exr").string()});
    scene.renderer().render_frame();
    const std::vector<float> normal = scene.read("picture_normal"), depth = scene.read("picture_depth");
    for (int y = 0; y < canvas.height; ++y)
        for (int x = 0; x < canvas.width; ++x) {
            const LayeredPixel wanted = numbered_pixel(x, y);
            const std::size_t i = std::size_t(y * canvas.width + x);
            ASSERT_EQ(depth[i], wanted.depth) << x << " " << y;
            for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(normal[4 * i + c], wanted.normal[c], 1e-7);
            ASSERT_EQ(normal[4 * i + 3], wanted.depth < 1e10f ? 1.0f : 0.0f);
        }
    const PictureItem& item = scene.world().resource<PictureList>().items.front();
    EXPECT_TRUE(item.has_normal && item.has_depth);
}

TEST_P(PictureLayersTest, ScaledOnesAreOfTheNearestTexel) {
    const TempFolder folder;
    struct Case {
        int width, height;
        PictureFit fit;
    };
    for (const Case& one : {Case{73, 49, PictureFit::stretch}, Case{7, 5, PictureFit::stretch},
                            Case{48, 16, PictureFit::contain}, Case{5, 9, PictureFit::cover}}) {
        write_layers(folder / "i.exr", one.width, one.height, numbered_pixel);
        ReadScene scene(context(), {"picture_depth", "picture_normal"});
        scene.show({.file = (folder / "i.exr").string(), .fit = one.fit});
        scene.renderer().render_frame();
        const std::vector<float> depth = scene.read("picture_depth"), normal = scene.read("picture_normal");
        const gpu::Rect place = picture_place(one.fit, one.width, one.height, canvas.width, canvas.height);
        const int top = canvas.height - place.y - place.height;
        int wrong = 0;
        for (int y = 0; y < canvas.height; ++y)
            for (int x = 0; x < canvas.width; ++x) {
                const double u = (x - place.x + 0.5) * one.width / place.width;
                const double v = (y - top + 0.5) * one.height / place.height;
                const bool inside = u > 0 && u < one.width && v > 0 && v < one.height;
                // On the border of two texels either is as near.
                bool right = false;
                for (const double across : {-1e-4, 1e-4})
                    for (const double down : {-1e-4, 1e-4}) {
                        const int column = std::clamp(int(u + across), 0, one.width - 1);
                        const int row = std::clamp(int(v + down), 0, one.height - 1);
                        const float wanted = inside ? numbered_pixel(column, row).depth : 1e10f;
                        right = right || depth[std::size_t(y * canvas.width + x)] == wanted;
                    }
                wrong += !right;
                const float* n = normal.data() + 4 * std::size_t(y * canvas.width + x);
                EXPECT_NEAR(std::hypot(n[0], n[1], n[2]),
                            depth[std::size_t(y * canvas.width + x)] < 1e10f ? 1.0f : 0.0f, 1e-6);
            }
        EXPECT_EQ(wrong, 0) << one.width << "x" << one.height;
    }
}

TEST_P(PictureLayersTest, AreMadeForThoseWhoAskAndDecodedAlone) {
    const TempFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    write_layers(folder / "i.exr", 4, 4, [&](int, int) {
        return LayeredPixel{.color = {nan, 0, 0}, .normal = {0, 0, 1}};
    });
    const Picture picture{.file = (folder / "i.exr").string()};
    ReadScene scene(context(), {"picture_normal"}, {4, 4});
    const Entity entity = scene.show(picture, {.show = PictureShow::blank});
    const auto passes = scene.draw_passes();
    EXPECT_TRUE(passes.contains("picture_normal"));
    EXPECT_FALSE(passes.contains("picture_depth") || passes.contains("picture_tone"));
    EXPECT_EQ(scene.read("picture_normal")[2], 1.0f) << "and its colours are not looked at";
    scene.world().get_mutable<PictureCoat>(entity).show = PictureShow::picture;
    try {
        scene.renderer().render_frame();
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("i.exr: has values that are not finite (color, channel R, column 0, row 0)"));
    }
}

TEST_P(PictureLayersTest, APictureInFrontHidesThem) {
    const TempFolder folder;
    write_layers(folder / "i.exr", canvas.width, canvas.height, [](int, int) {
        return LayeredPixel{.normal = {0, 1, 0}, .depth = 3.0f};
    });
    assets::write_png(folder / "front.png",
                      assets::make_image(canvas.height / 2, canvas.height, 3, assets::PixelType::u8));
    ReadScene scene(context(), {"picture_normal", "picture_depth"});
    scene.show({.file = (folder / "i.exr").string()});
    scene.show({.file = (folder / "front.png").string()}); // in the middle
    scene.renderer().render_frame();
    const std::vector<float> depth = scene.read("picture_depth"), normal = scene.read("picture_normal");
    const std::size_t row = 5 * std::size_t(canvas.width), middle = row + 12, side = row + 1;
    EXPECT_EQ(depth[side], 3.0f);
    EXPECT_EQ(depth[middle], 1e10f);
    EXPECT_EQ(normal[4 * side + 1], 1.0f);
    EXPECT_EQ(normal[4 * middle + 3], 0.0f);
    EXPECT_FALSE(scene.world().resource<PictureList>().items.back().has_normal);
}

/// What others wrote as AOVs of ours can be read again.
TEST_P(PictureLayersTest, AovsAreLayersAgain) {
    const TempFolder folder;
    write_layers(folder / "i.exr", canvas.width, canvas.height, numbered_pixel);
    PictureScene scene(context(), canvas);
    scene.show({.file = (folder / "i.exr").string()});
    scene.renderer().request_aov("picture_normal");
    scene.renderer().request_aov("picture_depth");
    scene.renderer().render_frame();
    const assets::Image normal = scene.renderer().read_aov("picture_normal");
    assets::write_exr(folder / "n.exr", normal, std::vector<std::string>{"normal.X", "normal.Y", "normal.Z"});
    assets::write_exr(folder / "d.exr", scene.renderer().read_aov("picture_depth"), std::vector<std::string>{"Z"});
    EXPECT_EQ(assets::read_layers(folder / "d.exr", {.depth = true}).depth->f32()[1], numbered_pixel(1, 0).depth);
    EXPECT_NEAR(assets::read_layers(folder / "n.exr", {.normal = true}).normal->f32()[3],
                numbered_pixel(1, 0).normal[0], 1e-6);
}

/// Files shot.03.exr, 04, 06, of which the tone and the depth say the number.
void write_sequence(const TempFolder& folder) {
    for (const int number : {3, 4, 6}) {
        const float light = float(number) / 10.0f;
        write_layers(folder / ("shot.0" + std::to_string(number) + ".exr"), 8, 4, [&](int, int) {
            return LayeredPixel{.color = {light, light, light}, .depth = float(number)};
        });
    }
}

TEST_P(PictureLayersTest, NumberedImagesShowTheFrameOfTheTime) {
    const TempFolder folder;
    write_sequence(folder);
    ReadScene scene(context(), {"picture_depth"}, {8, 4});
    const Picture picture{.file = (folder / "shot.##.exr").string(), .frames_per_second = 10};
    const Entity entity = scene.show(picture);
    const auto at = [&](double seconds) {
        scene.renderer().render_frame(seconds - scene.world().resource<Time>().elapsed);
        return scene.read("picture_depth")[0];
    };
    testing::internal::CaptureStderr();
    scene.renderer().render_frame();
    for (const auto& [seconds, number] :
         std::map<double, float>{{0.0, 3}, {0.05, 3}, {0.1, 4}, {0.2, 4}, {0.3, 6}, {9.0, 6}})
        EXPECT_EQ(at(seconds), number) << seconds;
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "hachure: warning: " + picture.file +
                  ": frames that are missing (1 of 4, shot.05.exr) show the one before\n");
    scene.world().get_mutable<Picture>(entity).loop = true;
    EXPECT_EQ(at(10.1), 4.0f);
    EXPECT_EQ(at(10.3), 6.0f);
    EXPECT_EQ(at(10.4), 3.0f);
}

TEST_P(PictureLayersTest, AFrameThatIsHeldIsNotDrawnAgain) {
    const TempFolder folder;
    write_sequence(folder);
    ReadScene scene(context(), {"picture_depth"}, {8, 4});
    scene.show({.file = (folder / "shot.##.exr").string(), .frames_per_second = 10});
    const auto runs = [&](double delta) {
        scene.renderer().render_frame(delta);
        return std::ranges::any_of(scene.renderer().pass_stats(),
                                   [](const gpu::PassStats& pass) { return pass.state == gpu::PassState::run; });
    };
    EXPECT_TRUE(runs(0.0));
    EXPECT_FALSE(runs(0.05)) << "the same frame";
    EXPECT_TRUE(runs(0.05));
    EXPECT_FALSE(runs(0.1)) << "number 5 is missing: number 4 stays";
    EXPECT_TRUE(runs(0.1));
    EXPECT_FALSE(runs(5.0)) << "past the end";
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(PictureLayersTest);

} // namespace
} // namespace hachure::test
