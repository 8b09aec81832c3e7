// Images and videos on the command line: what they are drawn with, at which size, and which frame when.

#include <hachure/editor/open_input.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/tests/editor/forked_command.h>
#include <hachure/tests/editor/program.h>
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
