// Images, videos and numbered images on the command line: what they are drawn with, at which size, and which frame
// when.

#include <hachure/editor/open_input.h>
#include <hachure/runtime/assets/frame_pattern.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/tests/editor/forked_command.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/systems/picture/layered_picture.h>
#include <hachure/tests/systems/picture/picture_scene.h>

#include <gmock/gmock.h>

#include <cmath>

namespace hachure::test {
namespace {

using testing::HasSubstr;

class PictureInput : public testing::Test {
protected:
    PictureInput() {
        assets::write_png(folder / "photo.png", noise(61, 37, 3));
        folder.write("plain.json", R"({"hachure_style": 1, "picture": {"picture_coat": {}}})");
        folder.write("surfaces.json", R"({"hachure_style": 1, "surface": {"gooch": {}, "edge_lines": {}}})");
    }

    ProcessResult render(std::vector<std::string> more) const {
        more.insert(more.begin(), {"render"});
        return hachure_program(folder, std::move(more));
    }

    /// The grey of the middle of the left half.
    int grey(const std::string& name) const {
        const assets::Image image = assets::read_image(folder / name);
        return image.u8()[3 * (image.height / 2 * image.width + image.width / 4)];
    }

    TempFolder folder;
};

TEST_F(PictureInput, AnImageKeepsItsSizeAndItsPixels) {
    ASSERT_TRUE(succeeded(render({"photo.png", "-o", "out.png", "--style", "plain.json"})));
    EXPECT_TRUE(assets::read_image(folder / "out.png").pixels == assets::read_image(folder / "photo.png").pixels);
    ASSERT_TRUE(succeeded(render({"photo.png", "-o", "tone.png", "--style", "plain.json", "--size", "30x20", "--set",
                                  "picture_coat.show=tone", "--aov", "picture_tone=tone.exr"})));
    EXPECT_EQ(assets::read_image(folder / "tone.png").width, 30);
    EXPECT_EQ(assets::read_image(folder / "tone.exr").height, 20);
}

TEST_F(PictureInput, AVideoPlaysAtItsOwnRate) {
    write_film(folder, 32, 16, 6, {25, 2});
    ASSERT_TRUE(succeeded(render({"film.mp4", "-o", "f.#.png", "--style", "plain.json", "--frames", "0..8"})));
    for (int i = 0; i < 9; ++i)
        EXPECT_NEAR(grey("f." + std::to_string(i) + ".png"), 20 + 16 * std::min(i, 5), 3) << "the last one stays";
    ASSERT_TRUE(succeeded(render({"film.mp4", "-o", "first.png", "--style", "plain.json"})));
    EXPECT_TRUE(file_text(folder / "first.png") == file_text(folder / "f.0.png"));
    EXPECT_EQ(assets::read_image(folder / "first.png").width, 32);
    ASSERT_TRUE(succeeded(render({"film.mp4", "-o", "t.png", "--style", "plain.json", "--time", "0.25"})));
    EXPECT_TRUE(file_text(folder / "t.png") == file_text(folder / "f.3.png"));
    ASSERT_TRUE(succeeded(
        render({"film.mp4", "-o", "slow.#.png", "--style", "plain.json", "--frames", "7..8", "--fps", "25"})));
    EXPECT_TRUE(file_text(folder / "slow.7.png") == file_text(folder / "f.3.png")) << "frame k shows second k / fps";
    EXPECT_TRUE(file_text(folder / "slow.8.png") == file_text(folder / "f.4.png"));
}

TEST_F(PictureInput, AVideoBecomesAVideo) {
    write_film(folder, 32, 16, 6, {25, 2});
    ASSERT_TRUE(succeeded(render({"film.mp4", "-o", "out.mp4", "--style", "plain.json", "--frames", "0..5"})));
    assets::VideoFile out(folder / "out.mp4");
    EXPECT_EQ(out.frame_count(), 6);
    EXPECT_EQ(out.frame_rate(), (assets::FrameRate{25, 2}));
    EXPECT_NEAR(out.read_frame(4).u8()[0], 20 + 64, 4);
}

TEST_F(PictureInput, AFilmShowsAllOfAVideoUnlessFramesAreAskedFor) {
    write_film(folder, 32, 16, 6, {25, 2});
    ASSERT_TRUE(succeeded(render({"film.mp4", "-o", "out.mp4", "--style", "plain.json"})));
    EXPECT_EQ(assets::VideoFile(folder / "out.mp4").frame_count(), 6);
    ASSERT_TRUE(succeeded(render({"film.mp4", "-o", "twice.##.png", "--style", "plain.json", "--fps", "25"})));
    EXPECT_TRUE(std::filesystem::exists(folder / "twice.11.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "twice.12.png"));
    EXPECT_NEAR(grey("twice.11.png"), 20 + 16 * 5, 3);
    ASSERT_TRUE(succeeded(render({"film.mp4", "-o", "one.mp4", "--style", "plain.json", "--frames", "3"})));
    EXPECT_EQ(assets::VideoFile(folder / "one.mp4").frame_count(), 1);
    EXPECT_TRUE(failed(render({"photo.png", "-o", "out.mp4", "--style", "plain.json"}), 2, "--frames A..B"))
        << "an image has no length";
}

/// The program is started, not forked: OpenEXR has written with threads, which a fork does not have.
class NumberedInput : public PictureInput {
protected:
    NumberedInput() {
        for (int number = 7; number <= 11; ++number)
            write_layers(assets::frame_file(folder / "shot.####.exr", number), 32, 16, [&](int x, int) {
                const float light = float(number) / 20.0f;
                return LayeredPixel{.color = {light, light, light},
                                    .normal = {0, 0, x < 16 ? 1.0f : 0.0f},
                                    .depth = x < 16 ? float(number) : 1e10f};
            });
    }

    static int grey_of(int number) {
        return int(std::lround(255.0 * (1.055 * std::pow(number / 20.0, 1 / 2.4) - 0.055)));
    }
};

TEST_F(NumberedInput, FramesAreTheFilesFromTheLowestNumber) {
    ASSERT_TRUE(succeeded(render({"shot.####.exr", "-o", "f.#.png", "--style", "plain.json"})));
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(grey("f." + std::to_string(i) + ".png"), grey_of(7 + i), 1) << i;
    EXPECT_FALSE(std::filesystem::exists(folder / "f.5.png"));
    ASSERT_TRUE(succeeded(render({"shot.####.exr", "-o", "first.png", "--style", "plain.json"})));
    EXPECT_TRUE(file_text(folder / "first.png") == file_text(folder / "f.0.png"));
    ASSERT_TRUE(succeeded(render({"shot.####.exr", "-o", "t.png", "--style", "plain.json", "--time", "0.14"})));
    EXPECT_TRUE(file_text(folder / "t.png") == file_text(folder / "f.4.png")) << "30 frames are a second";
    ASSERT_TRUE(succeeded(
        render({"shot.####.exr", "-o", "slow.#.png", "--style", "plain.json", "--frames", "3", "--fps", "60"})));
    EXPECT_TRUE(file_text(folder / "slow.3.png") == file_text(folder / "f.1.png")) << "frame k shows second k / fps";
}

TEST_F(NumberedInput, AMissingOneShowsTheOneBefore) {
    std::filesystem::remove(folder / "shot.0010.exr");
    const ProcessResult result = render({"shot.####.exr", "-o", "f.#.png", "--style", "plain.json"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err,
              "hachure: warning: shot.####.exr: frames that are missing (1 of 5, shot.0010.exr) show the one before\n");
    EXPECT_TRUE(file_text(folder / "f.3.png") == file_text(folder / "f.2.png"));
    EXPECT_NEAR(grey("f.4.png"), grey_of(11), 1);
}

TEST_F(NumberedInput, BecomeAFilmAtTheirRate) {
    ASSERT_TRUE(succeeded(render({"shot.####.exr", "-o", "out.mp4", "--style", "plain.json"})));
    assets::VideoFile out(folder / "out.mp4");
    EXPECT_EQ(out.frame_count(), 5);
    EXPECT_EQ(out.frame_rate(), (assets::FrameRate{30, 1}));
    EXPECT_NEAR(out.read_frame(4).u8()[0], grey_of(11), 4);
    ASSERT_TRUE(succeeded(render(
        {"shot.####.exr", "-o", "rate.mp4", "--style", "plain.json", "--set", "picture.frames_per_second=23.976"})));
    assets::VideoFile rate(folder / "rate.mp4");
    EXPECT_EQ(rate.frame_count(), 5);
    EXPECT_EQ(rate.frame_rate(), (assets::FrameRate{2997, 125}));
    EXPECT_NEAR(rate.read_frame(1).u8()[0], grey_of(8), 4);
}

TEST_F(NumberedInput, LayersAreAovs) {
    ASSERT_TRUE(succeeded(render({"shot.####.exr", "-o", "f.#.png", "--style", "plain.json", "--aov",
                                  "picture_depth=d.#.exr", "--aov", "picture_normal=n.#.exr"})));
    const assets::Image depth = assets::read_image(folder / "d.3.exr"), normal = assets::read_image(folder / "n.0.exr");
    EXPECT_EQ(depth.f32()[0], 10.0f);
    EXPECT_EQ(depth.f32()[31], 1e10f);
    EXPECT_EQ(normal.f32()[2], 1.0f);
    EXPECT_EQ(normal.f32()[3 * 31 + 2], 0.0f);
}

TEST_F(NumberedInput, InfoTellsFramesAndLayers) {
    std::filesystem::remove(folder / "shot.0010.exr");
    const ProcessResult result = hachure_program(folder, {"info", "shot.####.exr"});
    ASSERT_TRUE(succeeded(result));
    EXPECT_THAT(result.out,
                testing::AllOf(HasSubstr("kind           numbered images\n"), HasSubstr("size           32x16\n"),
                               HasSubstr("frames         5, numbers 7 to 11, 1 missing\n"),
                               HasSubstr("color          R G B\n"), HasSubstr("normal         N.X N.Y N.Z\n"),
                               HasSubstr("depth          Z\n")));
    EXPECT_THAT(hachure_program(folder, {"info", "shot.0008.exr"}).out,
                testing::AllOf(HasSubstr("kind           image\n"), HasSubstr("depth          Z\n")));
    EXPECT_THAT(hachure_program(folder, {"info", "photo.png"}).out,
                testing::AllOf(HasSubstr("channels       3 x 8 bit\n"), testing::Not(HasSubstr("depth"))));
}

TEST_F(NumberedInput, ArePlayedAndShownInScenes) {
    std::filesystem::remove(folder / "shot.0010.exr");
    folder.write("t.play.json", R"({"hachure_play": 1, "scene": "shot.####.exr", "style": "plain.json", "fps": 30,
        "size": [32, 16], "frames": 6, "expect": [{"frame": 3, "passes": []}, {"frame": 4, "passes": ["picture", "targets"]},
                                                  {"frame": 5, "passes": []}]})");
    EXPECT_EQ(hachure_program(folder, {"play", "t.play.json"}).exit_code, 0);
    folder.write("s.scene.json", R"({"hachure_scene": 1, "style": "plain.json", "entities": [
        {"name": "shot", "picture": {"file": "shot.####.exr", "frames_per_second": 10}}]})");
    EXPECT_EQ(hachure_program(folder, {"validate", "s.scene.json"}).out, "1 file, 0 faults, 0 warnings\n");
    EXPECT_EQ(render({"s.scene.json", "-o", "out.png", "--size", "32x16", "--time", "0.2"}).exit_code, 0);
    EXPECT_NEAR(grey("out.png"), grey_of(9), 1);
    assets::write_png(folder / "shot.0008.exr", noise(5, 5, 3)); // another size, and no EXR
    EXPECT_THAT(hachure_program(folder, {"validate", "s.scene.json"}).out, HasSubstr("shot.0008.exr: "));
}

TEST_F(NumberedInput, FaultsAreOneLine) {
    const auto expect_fault = [&](const char* input, const std::string& fault) {
        EXPECT_TRUE(failed(render({input, "-o", "out.png", "--style", "plain.json"}), 1, fault));
        EXPECT_FALSE(std::filesystem::exists(folder / "out.png"));
    };
    expect_fault("none.####.exr", "none.####.exr: names no file that is there, such as none.0001.exr");
    expect_fault("shot.##.##.exr", "shot.##.##.exr: ");
    expect_fault("absent/shot.##.exr", "absent/shot.##.exr: ");
    write_layers(folder / "shot.0009.exr", 31, 16, [](int, int) { return LayeredPixel{}; });
    expect_fault("shot.####.exr", "shot.0009.exr: has 31x16 pixels, not the 32x16 that the sequence's first, "
                                  "shot.0007.exr, has");
    write_layers(folder / "shot.0009.exr", 32, 16, [](int x, int y) {
        return LayeredPixel{.color = {x == 3 && y == 2 ? std::nanf("") : 0.0f, 0, 0}};
    });
    EXPECT_TRUE(failed(render({"shot.####.exr", "-o", "out.mp4", "--style", "plain.json"}), 1,
                       "shot.0009.exr: has values that are not finite (color, channel R, column 3, row 2)"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out.mp4"));
}

TEST_F(PictureInput, StylesOfSurfacesAloneAreRefused) {
    write_film(folder, 32, 16, 2, {25, 1});
    for (const char* input : {"photo.png", "film.mp4"})
        for (const char* style : {"gooch", "metal", "toon", "surfaces.json"}) {
            EXPECT_TRUE(failed(forked_command({"render", input, "-o", "out.png", "--style", style}, folder.path()), 1,
                               std::string(input) + ": has no surfaces, and style '" + style + "'"));
            EXPECT_FALSE(std::filesystem::exists(folder / "out.png"));
        }
}

TEST_F(PictureInput, FaultsAreOneLine) {
    std::string broken = file_text(folder / "photo.png");
    broken[broken.size() / 2] ^= 0x55;
    folder.write("broken.png", broken);
    folder.write("short.jpg", "\xff\xd8\xff");
    folder.write("text.mp4", "no film");
    write_film(folder, 32, 16, 2, {25, 1});
    folder.write("cut.mp4", file_text(folder / "film.mp4").substr(0, 900));
    for (const char* input : {"broken.png", "short.jpg", "text.mp4", "cut.mp4", "absent.png", "absent.mp4"}) {
        EXPECT_TRUE(failed(render({input, "-o", "out.png", "--style", "plain.json"}), 1, std::string(input) + ": "));
        EXPECT_FALSE(std::filesystem::exists(folder / "out.png"));
    }
    EXPECT_TRUE(failed(render({"photo.png", "-o", "out.png", "--style", "plain.json", "--clip", "walk"}), 1,
                       "photo.png: is a picture, which has no clips"));
    EXPECT_TRUE(failed(render({"photo.png", "-o", "out.png", "--style", "plain.json", "--size", "0x3"}), 2, "0x3"));
}

TEST_F(PictureInput, ScenesShowPicturesBehindModels) {
    folder.write("a.obj", tetrahedron_obj);
    folder.write("s.scene.json", R"({"hachure_scene": 1, "style": "toon", "entities": [
        {"model": "a.obj"}, {"name": "backdrop", "picture": {"file": "photo.png", "fit": "stretch"}}]})");
    EXPECT_EQ(forked_command({"validate", "s.scene.json"}, folder.path()).out, "1 file, 0 faults, 0 warnings\n");
    ASSERT_TRUE(succeeded(render({"s.scene.json", "-o", "out.png", "--size", "61x37"})));
    const assets::Image out = assets::read_image(folder / "out.png"), photo = assets::read_image(folder / "photo.png");
    int alike = 0;
    for (int i = 0; i < 61 * 37; ++i) alike += std::equal(out.u8() + 3 * i, out.u8() + 3 * i + 3, photo.u8() + 3 * i);
    EXPECT_GT(alike, 61 * 37 / 4);
    EXPECT_LT(alike, 61 * 37 * 9 / 10);
    folder.write("bad.scene.json", "{\"hachure_scene\": 1,\n \"entities\": [{\"picture\": {\"file\": \"none.mp4\"}}]}");
    EXPECT_THAT(forked_command({"validate", "bad.scene.json"}, folder.path()).out,
                testing::AllOf(HasSubstr("none.mp4: is not a file that can be read"),
                               HasSubstr("(line 2, column 36: /entities/0/picture/file)")));
}

} // namespace
} // namespace hachure::test
