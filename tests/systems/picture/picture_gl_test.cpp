#include <hachure/components/compose.h>
#include <hachure/components/edge_lines.h>
#include <hachure/components/gooch.h>
#include <hachure/components/metal.h>
#include <hachure/components/toon.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/picture/picture_place.h>
#include <hachure/systems/picture/tone.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "picture_scene.h"

namespace hachure::test {
namespace {

using gpu::PassState;

constexpr Canvas picture_canvas{64, 48};

/// Largest difference of two float images.
double largest_difference(const assets::Image& a, const std::vector<double>& b) {
    EXPECT_EQ(a.pixels.size(), b.size() * sizeof(float));
    double most = 0.0;
    for (std::size_t i = 0; i < b.size(); ++i) most = std::max(most, std::abs(double(a.f32()[i]) - b[i]));
    return most;
}

/// The mean of `tones` over the pixel (x, y), counted from the top left, of a picture that lies at `place` (from the
/// bottom, as the engine has it) of a view `height` high: exact integrals over texels for smaller ones, lines between
/// texels' middles for larger ones.
double mean_tone(const std::vector<float>& tones, int w, int h, const gpu::Rect& place, int height, int x, int y) {
    const auto weights = [](int pixel, int start, int size, int count) {
        std::vector<std::pair<int, double>> result;
        const double texels = double(count) / size, low = (pixel - start) * texels, high = low + texels;
        if (texels >= 1.0) {
            for (int i = int(low); i < count && i < high; ++i)
                result.emplace_back(i, (std::min(high, i + 1.0) - std::max(low, double(i))) / texels);
            return result;
        }
        const double at = 0.5 * (low + high) - 0.5, left = std::floor(at);
        result.emplace_back(std::clamp(int(left), 0, count - 1), 1.0 - (at - left));
        result.emplace_back(std::clamp(int(left) + 1, 0, count - 1), at - left);
        return result;
    };
    double sum = 0.0;
    for (const auto& [row, by_row] : weights(y, height - place.y - place.height, place.height, h))
        for (const auto& [column, by_column] : weights(x, place.x, place.width, w))
            sum += by_row * by_column * double(tones[std::size_t(row * w + column)]);
    return sum;
}

using PictureTest = GlTest;

TEST_P(PictureTest, AtItsOwnSizeEveryPixelIsExact) {
    const TempFolder folder;
    assets::Image linear = assets::make_image(picture_canvas.width, picture_canvas.height, 3, assets::PixelType::f32);
    const assets::Image bytes = noise(picture_canvas.width, picture_canvas.height, 3);
    for (std::size_t i = 0; i < bytes.pixels.size(); ++i) linear.f32()[i] = float(bytes.u8()[i]) / 200.0f;
    assets::write_png(folder / "i.png", bytes);
    assets::write_exr(folder / "i.exr", linear, std::vector<std::string>{"R", "G", "B"});
    for (const auto& [name, image] :
         std::map<std::string, const assets::Image*>{{"i.png", &bytes}, {"i.exr", &linear}}) {
        PictureScene scene(context(), picture_canvas);
        scene.show({.file = (folder / name).string()});
        const std::vector<float> tones = picture_tones(*image);
        const assets::Image drawn = scene.tones();
        ASSERT_EQ(drawn.channels, 1);
        for (std::size_t i = 0; i < tones.size(); ++i) ASSERT_EQ(drawn.f32()[i], tones[i]) << name << " " << i;
    }
    PictureScene scene(context(), picture_canvas);
    scene.show({.file = (folder / "i.png").string()});
    const assets::Image drawn = scene.draw();
    int worst = 0;
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i)
        worst = std::max(worst, std::abs(int(drawn.u8()[i]) - int(bytes.u8()[i])));
    EXPECT_EQ(worst, 0) << "the picture is its file";
}

TEST_P(PictureTest, ScaledPixelsAreMeans) {
    const TempFolder folder;
    struct Case {
        int width, height;
        PictureFit fit;
    };
    for (const Case& one : {Case{256, 192, PictureFit::contain}, Case{151, 97, PictureFit::contain},
                            Case{151, 97, PictureFit::cover}, Case{200, 30, PictureFit::stretch},
                            Case{11, 9, PictureFit::cover}, Case{11, 9, PictureFit::contain}, Case{1, 1, {}}}) {
        const assets::Image image = noise(one.width, one.height, 3);
        assets::write_png(folder / "i.png", image);
        PictureScene scene(context(), picture_canvas);
        scene.show({.file = (folder / "i.png").string(), .fit = one.fit});
        const gpu::Rect place =
            picture_place(one.fit, one.width, one.height, picture_canvas.width, picture_canvas.height);
        const std::vector<float> tones = picture_tones(image);
        std::vector<double> wanted;
        for (int y = 0; y < picture_canvas.height; ++y)
            for (int x = 0; x < picture_canvas.width; ++x) {
                const int up = picture_canvas.height - 1 - y;
                const bool inside =
                    x >= place.x && x < place.x + place.width && up >= place.y && up < place.y + place.height;
                wanted.push_back(inside ? mean_tone(tones, one.width, one.height, place, picture_canvas.height, x, y)
                                        : 1.0);
            }
        EXPECT_LT(largest_difference(scene.tones(), wanted), 2e-5) << one.width << "x" << one.height;
    }
}

/// What a mean over the whole pixel is for: stripes a texel wide are grey, at any ratio.
TEST_P(PictureTest, SmallerPicturesDoNotAlias) {
    const TempFolder folder;
    for (const int width : {256, 300, 333}) {
        assets::Image stripes = assets::make_image(width, 48, 1, assets::PixelType::u8);
        for (int i = 0; i < width * 48; ++i) stripes.u8()[i] = i % width % 2 ? 255 : 0;
        assets::write_png(folder / "s.png", stripes);
        PictureScene scene(context(), picture_canvas);
        scene.show({.file = (folder / "s.png").string(), .fit = PictureFit::stretch});
        const assets::Image tones = scene.tones();
        // A pixel's edge may cut a stripe: off by at most half a texel of its four or five.
        for (int x = 0; x < picture_canvas.width; ++x)
            EXPECT_NEAR(tones.f32()[x], 0.5, 0.51 * picture_canvas.width / width) << width << " " << x;
    }
}

/// A cube of a metre in front of the camera, which covers the middle of the view.
Entity add_cube(PictureScene& scene, float z) {
    return scene.add(surface_mesh(geometry::cube(1.0)), {.translation = {0.0f, 0.0f, z}});
}

TEST_P(PictureTest, LiesBehindSurfacesWithANumberOfItsOwn) {
    const TempFolder folder;
    assets::write_png(folder / "i.png", noise(picture_canvas.width, picture_canvas.height, 3));
    PictureScene scene(context(), picture_canvas);
    scene.renderer().request_aov("object_id");
    scene.renderer().request_aov("depth");
    add_cube(scene, -6.0f);
    const Entity picture = scene.show({.file = (folder / "i.png").string()});
    const Entity cube = add_cube(scene, -4.0f);
    const auto ids = [&] {
        scene.renderer().render_frame();
        return scene.renderer().read_aov("object_id");
    };
    const std::size_t corner = 0, middle = std::size_t(picture_canvas.width) * 24 + 32;
    assets::Image drawn = ids();
    EXPECT_EQ(drawn.f32()[corner], 2.0f) << "the picture, made second";
    EXPECT_EQ(drawn.f32()[middle], 3.0f);
    EXPECT_EQ(scene.renderer().read_aov("depth").f32()[corner], 1e10f) << "nothing is there";
    scene.world().get_mutable<Transform>(cube).translation.z = 4.0f; // behind the eye
    drawn = ids();
    EXPECT_EQ(drawn.f32()[corner], 2.0f);
    EXPECT_EQ(drawn.f32()[middle], 1.0f);
    EXPECT_EQ(scene.world().resource<DrawList>().pictures.front().object_id, 2u);
    scene.world().get_mutable<Picture>(picture).visible = false;
    drawn = ids();
    EXPECT_EQ(drawn.f32()[corner], 0.0f);
}

TEST_P(PictureTest, StylesOfSurfacesDoNoHarm) {
    const TempFolder folder;
    assets::write_png(folder / "i.png", noise(picture_canvas.width, picture_canvas.height, 3));
    assets::Image pictures[2];
    for (const bool styled : {false, true}) {
        PictureScene scene(context(), picture_canvas);
        const Entity picture = scene.show({.file = (folder / "i.png").string()});
        const Entity cube = add_cube(scene, -4.0f);
        scene.world().add(cube, EdgeLines{.method = LineMethod::image});
        if (styled) {
            scene.world().add(picture, Gooch{});
            scene.world().add(picture, Metal{});
            scene.world().add(picture, Toon{});
            scene.world().add(picture, EdgeLines{.method = LineMethod::image});
        }
        pictures[styled] = scene.draw();
    }
    EXPECT_TRUE(pictures[0].pixels == pictures[1].pixels);
}

/// Four fields of colours, the last one red, each so wide that its middle is flat.
class Fields {
public:
    static constexpr int width = 16, height = 2;
    static constexpr std::uint8_t colors[12] = {0, 0, 0, 110, 110, 110, 255, 255, 255, 255, 0, 0};

    explicit Fields(const std::filesystem::path& file) {
        assets::Image image = assets::make_image(width, height, 3, assets::PixelType::u8);
        for (int i = 0; i < width * height; ++i) std::copy_n(colors + 3 * (i % width / 4), 3, image.u8() + 3 * i);
        assets::write_png(file, image);
    }

    static std::vector<int> of(const assets::Image& image) {
        std::vector<int> result;
        for (int field = 0; field < 4; ++field)
            for (int c = 0; c < 3; ++c) result.push_back(image.u8()[3 * (4 * field + 1) + c]);
        return result;
    }
};

TEST_P(PictureTest, CoatsSayWhatIsDrawn) {
    const TempFolder folder;
    const Fields fields(folder / "i.png");
    const auto drawn = [&](const PictureCoat& coat, const glm::vec3& background = glm::vec3(1)) {
        PictureScene scene(context(), {Fields::width, Fields::height});
        scene.show({.file = (folder / "i.png").string()}, coat);
        scene.set_background(background);
        return Fields::of(scene.draw());
    };
    const auto near = [](const std::vector<int>& values) {
        std::vector<testing::Matcher<int>> matchers;
        for (const int value : values)
            matchers.push_back(testing::AllOf(testing::Ge(value - 1), testing::Le(value + 1)));
        return testing::ElementsAreArray(matchers);
    };
    const std::vector<int> own(Fields::colors, Fields::colors + 12);
    EXPECT_EQ(drawn({}), own);
    const glm::vec3 black(0), white(1), red(1, 0, 0), blue(0, 0, 1);
    EXPECT_THAT(drawn({.show = PictureShow::tone, .light = white, .shade = black}),
                near({0, 0, 0, 110, 110, 110, 255, 255, 255, 127, 127, 127}));
    EXPECT_THAT(drawn({.show = PictureShow::tone, .light = white, .shade = red}),
                near({255, 0, 0, 255, 110, 110, 255, 255, 255, 255, 127, 127}));
    EXPECT_EQ(drawn({.show = PictureShow::bands, .bands = 2, .smoothing = 0, .light = white, .shade = red}),
              (std::vector<int>{255, 0, 0, 255, 0, 0, 255, 255, 255, 255, 0, 0}));
    EXPECT_EQ(drawn({.show = PictureShow::blank}, blue),
              (std::vector<int>{0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0, 255}));
    EXPECT_THAT(drawn({.show = PictureShow::tone, .color = 1, .light = white, .shade = black}), near(own))
        << "the hue stays, and the tone is the one of grey";
}

/// Bands of a ramp: their number and their evenness, with anti-aliased edges.
TEST_P(PictureTest, BandsAreEvenAndTheirEdgesSmooth) {
    const TempFolder folder;
    assets::Image ramp = assets::make_image(256, 4, 1, assets::PixelType::u8);
    for (int i = 0; i < 1024; ++i) ramp.u8()[i] = static_cast<std::uint8_t>(i % 256);
    assets::write_png(folder / "r.png", ramp);
    PictureScene scene(context(), {256, 4});
    scene.show({.file = (folder / "r.png").string()},
               {.show = PictureShow::bands, .bands = 4, .light = glm::vec3(1), .shade = glm::vec3(0)});
    const assets::Image drawn = scene.draw();
    for (int x = 0; x < 256; ++x) {
        const double edge = std::fmod(x, 63.75);
        if (edge < 2.0 || edge > 61.75) continue;
        EXPECT_EQ(drawn.u8()[3 * x], int(x / 63.75) * 85) << x;
    }
    EXPECT_THAT(int(drawn.u8()[3 * 64]), testing::AllOf(testing::Gt(0), testing::Lt(85)));
}

TEST_P(PictureTest, WhatIsTransparentShowsTheBackground) {
    const TempFolder folder;
    assets::Image image = assets::make_image(2, 1, 4, assets::PixelType::u8);
    const std::uint8_t pixels[8] = {200, 30, 60, 255, 9, 9, 9, 0};
    std::copy_n(pixels, 8, image.u8());
    assets::write_png(folder / "i.png", image);
    PictureScene scene(context(), {2, 1});
    scene.show({.file = (folder / "i.png").string()});
    scene.set_background({0, 1, 0});
    const assets::Image drawn = scene.draw();
    EXPECT_THAT(std::vector<int>(drawn.u8(), drawn.u8() + 6), testing::ElementsAre(200, 30, 60, 0, 255, 0));
    const assets::Image tones = scene.tones();
    EXPECT_EQ(tones.f32()[1], 1.0f) << "of what is transparent, on white";
}

TEST_P(PictureTest, TheOneMadeLastLiesInFront) {
    const TempFolder folder;
    assets::write_png(folder / "a.png", noise(picture_canvas.width, picture_canvas.height, 3));
    assets::Image plain = assets::make_image(64, 16, 3, assets::PixelType::u8);
    assets::write_png(folder / "b.png", plain);
    PictureScene scene(context(), picture_canvas);
    scene.show({.file = (folder / "a.png").string()});
    scene.show({.file = (folder / "b.png").string()});
    const assets::Image tones = scene.tones();
    EXPECT_EQ(tones.f32()[std::size_t(24 * picture_canvas.width + 5)], 0.0f);
    EXPECT_GT(*std::max_element(tones.f32(), tones.f32() + 64), 0.9f);
}

TEST_P(PictureTest, OthersReadColours) {
    const TempFolder folder;
    assets::Image image = assets::make_image(2, 1, 4, assets::PixelType::u8);
    const std::uint8_t pixels[8] = {255, 188, 0, 255, 255, 255, 255, 51};
    std::copy_n(pixels, 8, image.u8());
    assets::write_png(folder / "i.png", image);
    PictureScene scene(context(), {2, 1});
    scene.app().add_system(Stage::material, "asks",
                           [](FrameRequests& requests) { requests.textures.insert("picture_color"); });
    scene.app().add_system(Stage::render, "reads", [](World& world) {
        gpu::FrameGraph& graph = world.resource_mutable<RenderContext>().graph;
        graph.require(graph.find("picture_color"));
    });
    scene.show({.file = (folder / "i.png").string()});
    scene.renderer().render_frame();
    RenderContext& render = scene.world().resource_mutable<RenderContext>();
    const std::vector<float> colors =
        render.backend->texture(render.graph.texture(render.graph.find("picture_color"))).read_floats();
    EXPECT_NEAR(colors[0], 1.0, 1e-3);
    EXPECT_NEAR(colors[1], 0.503, 1e-3);
    EXPECT_EQ(colors[2], 0.0f);
    EXPECT_NEAR(colors[4], 0.2, 1e-3);
    EXPECT_NEAR(colors[7], 0.2, 1e-3);
}

/// The mean tone of the left and right half.
std::pair<double, double> halves(const assets::Image& tones) {
    double left = 0.0, right = 0.0;
    for (int i = 0; i < tones.width * tones.height; ++i)
        (i % tones.width < tones.width / 2 ? left : right) += 2.0 * double(tones.f32()[i]);
    return {left / (tones.width * tones.height), right / (tones.width * tones.height)};
}

TEST_P(PictureTest, AVideoShowsTheFrameOfTheTime) {
    const TempFolder folder;
    const std::string film = write_film(folder, 32, 16, 8, {25, 1});
    PictureScene scene(context(), {32, 16});
    scene.show({.file = film});
    scene.renderer().request_aov("picture_tone");
    const auto at = [&](double seconds) {
        scene.renderer().render_frame(seconds - scene.world().resource<Time>().elapsed);
        return halves(scene.renderer().read_aov("picture_tone"));
    };
    scene.renderer().render_frame();
    for (const int frame : {0, 1, 2, 5, 7, 30}) {
        const int shown = std::min(frame, 7);
        const auto [left, right] = at(frame / 25.0);
        EXPECT_NEAR(left, (20 + 16 * shown) / 255.0, 0.012) << frame;
        EXPECT_NEAR(right, (60 + 16 * shown) / 255.0, 0.012) << frame;
    }
}

TEST_P(PictureTest, FramesOfAVideoAreTheSameInAnyOrder) {
    const TempFolder folder;
    const std::string film = write_film(folder, 32, 16, 8, {25, 1});
    PictureScene scene(context(), {32, 16});
    const Entity picture = scene.show({.file = film, .speed = 0.0f});
    const auto frame = [&](int number) {
        scene.world().get_mutable<Picture>(picture).time_offset = float(number) / 25.0f + 0.001f;
        return scene.tones().pixels;
    };
    std::vector<std::vector<std::byte>> in_order;
    for (int i = 0; i < 8; ++i) in_order.push_back(frame(i));
    for (const int i : {7, 0, 5, 4, 1, 6}) EXPECT_TRUE(frame(i) == in_order[std::size_t(i)]) << i;
    EXPECT_FALSE(in_order[3] == in_order[4]);
}

TEST_P(PictureTest, WhatStandsStillIsNotDrawnAgain) {
    const TempFolder folder;
    const std::string film = write_film(folder, 32, 16, 3, {25, 1});
    PictureScene scene(context(), {32, 16});
    EXPECT_FALSE(scene.draw_passes().contains("picture")) << "without a picture there is no pass";
    const Entity picture = scene.show({.file = film});
    scene.renderer().request_aov("picture_tone");
    EXPECT_EQ(scene.draw_passes().at("picture"), PassState::run);
    const auto passes = [&](double seconds) {
        scene.renderer().render_frame(seconds);
        std::vector<std::string> names;
        for (const gpu::PassStats& pass : scene.renderer().pass_stats())
            if (pass.state == PassState::run) names.push_back(pass.name);
        return names;
    };
    EXPECT_THAT(passes(0.01), testing::IsEmpty()) << "the same frame of the film";
    EXPECT_THAT(passes(0.04), testing::IsSupersetOf({"picture", "picture_tone"}));
    EXPECT_THAT(passes(0.04), testing::IsSupersetOf({"picture", "picture_tone"}));
    EXPECT_THAT(passes(5.0), testing::IsEmpty()) << "past its end";
    scene.world().get_mutable<PictureCoat>(picture).show = PictureShow::tone;
    EXPECT_THAT(passes(1.0), testing::IsSupersetOf({"picture"}));
    EXPECT_THAT(passes(1.0), testing::IsEmpty());
}

TEST_P(PictureTest, FaultsOfFilesEndTheFrame) {
    const TempFolder folder;
    assets::write_png(folder / "i.png", noise(picture_canvas.width, picture_canvas.height, 3));
    std::string broken = file_text(folder / "i.png");
    broken[broken.size() / 2] ^= 0x55;
    folder.write("broken.png", broken);
    for (const char* name : {"broken.png", "absent.png", "absent.mp4"}) {
        PictureScene scene(context(), picture_canvas);
        scene.show({.file = (folder / name).string()});
        try {
            scene.renderer().render_frame();
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(name));
        }
    }
    PictureScene scene(context(), picture_canvas);
    scene.show({});
    EXPECT_FALSE(scene.draw_passes().contains("picture")) << "no file, nothing to draw";
}

HACHURE_INSTANTIATE_GL_TESTS(PictureTest);

} // namespace
} // namespace hachure::test
