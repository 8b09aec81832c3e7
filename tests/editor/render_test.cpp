#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/glb_file.h>

#include <OpenImageIO/imageio.h>

#include <array>
#include <cmath>
#include <memory>
#include <set>

namespace hachure::test {
namespace {

using assets::Image;
using assets::PixelType;

/// Two squares, left and right, that fill the picture; and a tetrahedron.
class Render : public testing::Test {
protected:
    void SetUp() override {
        folder.write("squares.glb", two_squares_glb());
        folder.write("in.obj", tetrahedron_obj);
    }

    ProcessResult render(const std::string& input, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"render", input, "--size", "64x32"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return hachure_program(folder, arguments);
    }

    /// The picture of the squares with these assignments.
    Image squares(const std::vector<std::string>& sets) {
        std::vector<std::string> more{"-o", "out.png", "--set", "edge_lines.width=0"};
        for (const std::string& set : sets) more.insert(more.end(), {"--set", set});
        EXPECT_TRUE(succeeded(render("squares.glb", more)));
        return assets::read_image(folder / "out.png");
    }

    TempFolder folder;
};

std::array<int, 3> pixel(const Image& image, int x, int y) {
    const std::uint8_t* p =
        image.u8() + static_cast<std::size_t>(y * image.width + x) * static_cast<std::size_t>(image.channels);
    return {p[0], p[1], p[2]};
}

const std::array<int, 3> white{255, 255, 255};

TEST_F(Render, PngIsEightBitRgb) {
    ASSERT_TRUE(succeeded(render("in.obj", {"-o", "out.png"})));
    const auto input = OIIO::ImageInput::open((folder / "out.png").string());
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().width, 64);
    EXPECT_EQ(input->spec().height, 32);
    EXPECT_EQ(input->spec().nchannels, 3);
    EXPECT_EQ(input->spec().format, OIIO::TypeDesc::UINT8);
    const Image image = assets::read_image(folder / "out.png");
    EXPECT_EQ(pixel(image, 0, 0), white);
    EXPECT_NE(pixel(image, 32, 16), white);
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"in.obj", "out.png", "squares.glb"}));
}

TEST_F(Render, EveryBackendDraws) {
    for (const char* backend : {"egl", "osmesa", "auto"}) {
        const std::string file = std::string(backend) + ".png";
        const ProcessResult result = render("squares.glb", {"-o", file, "--backend", backend});
        if (result.exit_code == 1 && result.err.starts_with("hachure: error: egl")) continue; // no EGL driver here
        ASSERT_TRUE(succeeded(result)) << backend;
        EXPECT_NE(pixel(assets::read_image(folder / file), 16, 16), white) << backend;
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "osmesa.png"));
}

TEST_F(Render, ReplacesAnOlderPicture) {
    folder.write("out.png", "old");
    ASSERT_TRUE(succeeded(render("in.obj", {"-o", "out.png"})));
    EXPECT_EQ(assets::read_image(folder / "out.png").width, 64);
}

TEST_F(Render, SameInputSamePicture) {
    ASSERT_TRUE(succeeded(render("in.obj", {"-o", "a.png"})));
    ASSERT_TRUE(succeeded(render("in.obj", {"-o", "b.png"})));
    EXPECT_EQ(file_text(folder / "a.png"), file_text(folder / "b.png"));
}

TEST_F(Render, ExrHoldsLinearColor) {
    ASSERT_TRUE(succeeded(render(
        "squares.glb", {"-o", "out.exr", "--set", "surface.visible=false", "--set", "compose.background=0.5 0.25 3"})));
    const Image image = assets::read_image(folder / "out.exr");
    ASSERT_EQ(image.type, PixelType::f32);
    ASSERT_EQ(image.channels, 3);
    EXPECT_NEAR(image.f32()[0], 0.5f, 1e-3f);
    EXPECT_NEAR(image.f32()[1], 0.25f, 1e-3f);
    EXPECT_NEAR(image.f32()[2], 3.0f, 1e-2f);
}

std::set<std::string> channels_of(const std::filesystem::path& file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) return {};
    EXPECT_EQ(input->spec().format, OIIO::TypeDesc::FLOAT) << file;
    return {input->spec().channelnames.begin(), input->spec().channelnames.end()};
}

TEST_F(Render, AovsHaveTheirChannels) {
    ASSERT_TRUE(succeeded(render("squares.glb", {"-o", "out.png", "--aov", "color=c.exr", "--aov", "depth=d.exr",
                                                 "--aov", "normal=n.exr", "--aov", "object_id=i.exr"})));
    EXPECT_EQ(channels_of(folder / "c.exr"), (std::set<std::string>{"R", "G", "B"}));
    EXPECT_EQ(channels_of(folder / "d.exr"), (std::set<std::string>{"Z"}));
    EXPECT_EQ(channels_of(folder / "n.exr"), (std::set<std::string>{"normal.X", "normal.Y", "normal.Z"}));
    EXPECT_EQ(channels_of(folder / "i.exr"), (std::set<std::string>{"object_id"}));
}

TEST_F(Render, AovsHoldWhatTheirNamesSay) {
    ASSERT_TRUE(succeeded(render("squares.glb", {"-o", "out.png", "--aov", "depth=d.exr", "--aov", "normal=n.exr",
                                                 "--aov", "object_id=i.exr"})));
    const std::size_t left = 16 * 64 + 16, right = 16 * 64 + 48;
    const Image depth = assets::read_image(folder / "d.exr"), normal = assets::read_image(folder / "n.exr"),
                id = assets::read_image(folder / "i.exr");
    EXPECT_NEAR(depth.f32()[left], 5.0f, 1e-3f);
    EXPECT_NEAR(normal.f32()[3 * left + 2], 1.0f, 1e-3f);
    EXPECT_NEAR(normal.f32()[3 * left], 0.0f, 1e-3f);
    EXPECT_EQ(id.f32()[left], 1.0f);
    EXPECT_EQ(id.f32()[right], 2.0f);
}

TEST_F(Render, SetChangesEveryEntity) {
    const Image image = squares({"surface.visible=false", "compose.background=#204060"});
    EXPECT_EQ(pixel(image, 16, 16), (std::array<int, 3>{0x20, 0x40, 0x60}));
    EXPECT_EQ(pixel(image, 48, 16), (std::array<int, 3>{0x20, 0x40, 0x60}));
}

TEST_F(Render, SetChangesANamedEntityOnly) {
    const Image image = squares({"left/surface.visible=false"});
    EXPECT_EQ(pixel(image, 16, 16), white);
    EXPECT_NE(pixel(image, 48, 16), white);
}

TEST_F(Render, SetOfAStyleFieldChangesTheTone) {
    const auto without_blue = pixel(squares({"gooch.b=0", "gooch.highlight=0"}), 16, 16);
    const auto with_blue = pixel(squares({"gooch.b=1", "gooch.highlight=0"}), 16, 16);
    EXPECT_EQ(without_blue[0], with_blue[0]);
    EXPECT_GT(with_blue[2], without_blue[2] + 20);
}

TEST_F(Render, LaterSetWins) {
    const Image image = squares({"surface.visible=false", "right/surface.visible=true", "compose.background=#000000"});
    EXPECT_EQ(pixel(image, 16, 16), (std::array<int, 3>{0, 0, 0}));
    EXPECT_NE(pixel(image, 48, 16), (std::array<int, 3>{0, 0, 0}));
}

TEST_F(Render, PresetFileIsAStyle) {
    folder.write("mine.json", R"({"hachure_style": 1, "name": "mine", "doc": "tones without lines",
        "surface": {"gooch": {"b": 0, "y": 0, "alpha": 0, "beta": 0, "highlight": 0}},
        "camera": {"compose": {"background": [0, 1, 0]}}})");
    ASSERT_TRUE(succeeded(
        render("squares.glb", {"-o", "out.png", "--style", "mine.json", "--set", "left/surface.visible=false"})));
    const Image image = assets::read_image(folder / "out.png");
    EXPECT_EQ(pixel(image, 16, 16), (std::array<int, 3>{0, 255, 0}));
    EXPECT_EQ(pixel(image, 48, 16), (std::array<int, 3>{0, 0, 0}));
}

TEST_F(Render, CamerasOfTheFileAreUsed) {
    // Through the file's camera the squares fill the picture, with nothing of the background left at its corners.
    const Image image = squares({});
    for (const int x : {1, 62})
        for (const int y : {1, 30}) EXPECT_NE(pixel(image, x, y), white) << x << " " << y;
}

} // namespace
} // namespace hachure::test
