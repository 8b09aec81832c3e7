#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/assets/video_file.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/glb_file.h>

#include <nlohmann/json.hpp>

#include <csignal>
#include <thread>

namespace hachure::test {
namespace {

/// Several frames of two squares, in every kind of file.
class Frames : public testing::Test {
protected:
    void SetUp() override { folder.write("in.glb", two_squares_glb()); }

    ProcessResult render(const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"render", "in.glb", "--size", "64x32"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return hachure_program(folder, arguments); // not forked: reading EXR files starts threads in the test
    }

    TempFolder folder;
};

TEST_F(Frames, NumberedPicturesAndBuffers) {
    ASSERT_TRUE(succeeded(render({"-o", "out.###.png", "--frames", "9..11", "--aov", "depth=d.#.exr"})));
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"in.glb", "out.009.png", "out.010.png", "out.011.png", "d.9.exr",
                                                       "d.10.exr", "d.11.exr"}));
    EXPECT_EQ(assets::read_image(folder / "out.010.png").width, 64);
    EXPECT_NEAR(assets::read_image(folder / "d.10.exr").f32()[16 * 64 + 16], 5.0f, 1e-3f);
}

TEST_F(Frames, NumberedPicturesAreThoseOfStills) {
    ASSERT_TRUE(succeeded(render({"-o", "out.#.png", "--frames", "0..2", "--fps", "4"})));
    ASSERT_TRUE(succeeded(render({"-o", "still.png", "--time", "0.5"})));
    ASSERT_TRUE(succeeded(render({"-o", "alone.#.png", "--frames", "2", "--fps", "4", "--threads", "1"})));
    EXPECT_EQ(file_text(folder / "out.2.png"), file_text(folder / "still.png"));
    EXPECT_EQ(file_text(folder / "out.2.png"), file_text(folder / "alone.2.png"));
}

/// Strokes depend on how the light came to be what it is: runs live through the frames before their first one.
TEST_F(Frames, ShadeStrokesAreTheSameWhereverARunBegins) {
    const std::string model = HACHURE_SOURCE_DIR "/tests/playback/models/shapes.glb";
    const auto draw = [&](const char* out, const char* frames, const char* threads) {
        // The floor's borders are told of on stderr: strokes end there.
        const ProcessResult result = hachure_program(
            folder, {"render", model, "-o", out, "--style", "strokes", "--set", "shade_strokes.cells=300", "--clip",
                     "sun", "--size", "96x64", "--fps", "10", "--frames", frames, "--threads", threads});
        return result.exit_code == 0;
    };
    ASSERT_TRUE(draw("all.#.png", "0..7", "2"));
    ASSERT_TRUE(draw("late.#.png", "6..7", "1"));
    for (const char* number : {"6", "7"})
        EXPECT_TRUE(file_text(folder / (std::string("all.") + number + ".png")) ==
                    file_text(folder / (std::string("late.") + number + ".png")))
            << number;
    EXPECT_FALSE(file_text(folder / "all.0.png") == file_text(folder / "all.7.png")) << "the sun moves";
}

TEST_F(Frames, NumberedExr) {
    ASSERT_TRUE(succeeded(render({"-o", "out.##.exr", "--frames", "0..1"})));
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"in.glb", "out.00.exr", "out.01.exr"}));
}

TEST_F(Frames, WithoutFramesANumberIsZero) {
    ASSERT_TRUE(succeeded(render({"-o", "out.##.png"})));
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"in.glb", "out.00.png"}));
}

TEST_F(Frames, OneFrameNeedsNoNumber) {
    ASSERT_TRUE(succeeded(render({"-o", "out.png", "--frames", "5", "--aov", "depth=d.exr"})));
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"in.glb", "out.png", "d.exr"}));
}

TEST_F(Frames, Films) {
    for (const char* name : {"out.mp4", "out.gif"}) {
        ASSERT_TRUE(succeeded(render({"-o", name, "--frames", "3..7", "--fps", "20", "--stats", "s.json"}))) << name;
        assets::VideoFile film(folder / name);
        EXPECT_EQ(film.width(), 64) << name;
        EXPECT_EQ(film.height(), 32) << name;
        EXPECT_EQ(nlohmann::json::parse(file_text(folder / "s.json"))["frames"].size(), 5u);
    }
    EXPECT_EQ(assets::VideoFile(folder / "out.mp4").frame_count(), 5);
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"in.glb", "out.mp4", "out.gif", "s.json"}));
}

TEST_F(Frames, SameCommandSameFilm) {
    for (const char* name : {"mp4", "gif"}) {
        const std::string a = std::string("a.") + name, b = std::string("b.") + name;
        ASSERT_TRUE(succeeded(render({"-o", a, "--frames", "0..9"})));
        ASSERT_TRUE(succeeded(render({"-o", b, "--frames", "0..9", "--threads", "1"})));
        EXPECT_EQ(file_text(folder / a), file_text(folder / b)) << name;
    }
}

TEST_F(Frames, AnUnknownClipIsRefused) {
    const auto before = folder.listing();
    EXPECT_TRUE(failed(render({"-o", "out.mp4", "--frames", "0..3", "--clip", "Fly"}), 1, "in.glb: has no clip 'Fly'"));
    EXPECT_EQ(folder.listing(), before);
}

TEST_F(Frames, WhatCannotBeWrittenIsRefusedBeforeTheFirstFrame) {
    std::filesystem::create_directory(folder / "d.0.exr");
    const auto before = folder.listing();
    EXPECT_TRUE(failed(render({"-o", "absent/out.mp4", "--frames", "0..3"}), 1, "absent/out.mp4: "));
    EXPECT_TRUE(failed(render({"-o", "out.#.png", "--aov", "depth=d.#.exr", "--frames", "0..3"}), 1, "d.0.exr: "));
    EXPECT_EQ(folder.listing(), before);
}

TEST_F(Frames, AFaultInTheMiddleLeavesOnlyWholeFiles) {
    std::filesystem::create_directory(folder / "out.2.png");
    EXPECT_TRUE(failed(render({"-o", "out.#.png", "--frames", "0..9"}), 1, "out.2.png: "));
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"in.glb", "out.0.png", "out.1.png", "out.2.png"}));
}

/// The test's process is the parent of the program; it is sent a signal as soon as the film has begun.
TEST_F(Frames, AnInterruptedFilmLeavesNothing) {
    folder.write("out.mp4", "old");
    const auto before = folder.listing();
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        static_cast<void>(::chdir(folder.path().c_str()));
        ::execl(HACHURE_PROGRAM, "hachure", "render", "in.glb", "-o", "out.mp4", "--size", "64x32", "--frames",
                "0..999999", nullptr);
        ::_exit(127);
    }
    for (int i = 0; i < 1000 && folder.listing() == before; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_NE(folder.listing(), before) << "the film was never begun";
    ::kill(child, SIGTERM);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM) << status;
    EXPECT_EQ(folder.listing(), before);
    EXPECT_EQ(file_text(folder / "out.mp4"), "old");
}

} // namespace
} // namespace hachure::test
