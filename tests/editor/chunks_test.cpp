#include <hachure/editor/render_outputs.h>
#include <hachure/editor/usage_error.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/glb_file.h>

#include <map>

namespace hachure::test {
namespace {

/// Sequences that are drawn in shares, or a second time.
class Chunks : public testing::Test {
protected:
    void SetUp() override { folder.write("in.glb", moving_square_glb()); }

    [[nodiscard]] std::vector<std::string> command(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"render", "in.glb", "--fps", "10"};
        if (std::ranges::find(more, "--size") == more.end()) arguments.insert(arguments.end(), {"--size", "64x32"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    ProcessResult render(const std::vector<std::string>& more) { return hachure_program(folder, command(more)); }

    /// All files but the model, by name.
    [[nodiscard]] std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> result;
        for (const std::string& name : folder.listing())
            if (name != "in.glb") result[name] = file_text(folder / name);
        return result;
    }

    void remove_files() {
        for (const auto& [name, text] : files()) std::filesystem::remove(folder / name);
    }

    void cut(const char* name, double share) const {
        const auto size = std::filesystem::file_size(folder / name);
        std::filesystem::resize_file(folder / name, static_cast<std::uintmax_t>(static_cast<double>(size) * share));
    }

    TempFolder folder;
};

/// Velocities, too, which need to know the frame before a share's first one.
const std::vector<std::string> sequence{"-o",    "out.##.png",        "--frames", "2..8",
                                        "--aov", "velocity=v.##.exr", "--aov",    "depth=d.##.exr"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST_F(Chunks, SharesDrawnBesideEachOtherAreTheFilesOfOneRun) {
    ASSERT_TRUE(succeeded(render(sequence)));
    const auto whole = files();
    ASSERT_EQ(whole.size(), 21u);
    ASSERT_NE(whole.at("out.02.png"), whole.at("out.08.png")) << "nothing moves";
    remove_files();
    const auto run = [&](const char* share) { // started, not forked: beside each other
        return [this, share] {
            std::vector<std::string> arguments{HACHURE_PROGRAM};
            arguments = with(arguments, command(with(sequence, {"--chunk", share})));
            ::execv(HACHURE_PROGRAM, argument_pointers(arguments).data());
            return 127;
        };
    };
    {
        Process first(run("1/2"), folder.path()), second(run("2/2"), folder.path());
        EXPECT_TRUE(succeeded(first.wait()));
        EXPECT_TRUE(succeeded(second.wait()));
    }
    EXPECT_TRUE(files() == whole);
}

TEST_F(Chunks, AShareIsItsFramesAndNoOthers) {
    ASSERT_TRUE(succeeded(render({"-o", "out.#.png", "--frames", "0..4", "--chunk", "2/2"})));
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"in.glb", "out.2.png", "out.3.png", "out.4.png"}));
}

TEST_F(Chunks, AnEmptyShareIsNoFault) {
    const ProcessResult result = render({"-o", "out.#.png", "--frames", "0..1", "--chunk", "1/3"});
    EXPECT_TRUE(succeeded(result));
    EXPECT_NE(result.out.find("nothing to do"), std::string::npos) << result.out;
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"in.glb"}));
}

/// As the program would check it: that takes 0.2 s a call.
std::string sequence_fault(const char* picture, const char* frames, std::vector<AovOutput> aovs = {}) {
    try {
        check_sequence("--chunk", {picture, std::move(aovs), {}}, parse_frame_plan(frames, "", "30"));
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST_F(Chunks, OnlyNumberedSequencesHaveShares) {
    EXPECT_EQ(sequence_fault("out.#.png", "0..3", {{"depth", "d.#.exr"}}), "");
    EXPECT_EQ(sequence_fault("out.#.png", "3"), "");
    for (const char* name : {"out.mp4", "out.gif", "out.png"})
        EXPECT_NE(sequence_fault(name, "3").find(name), std::string::npos) << name;
    EXPECT_NE(sequence_fault("out.#.png", "").find("--frames"), std::string::npos);
    EXPECT_NE(sequence_fault("out.#.png", "3", {{"depth", "d.exr"}}).find("d.exr"), std::string::npos);
    EXPECT_TRUE(failed(render({"-o", "out.mp4", "--frames", "0..3", "--chunk", "1/2"}), 2, "--chunk: "));
    EXPECT_TRUE(failed(render({"-o", "out.mp4", "--frames", "0..3", "--resume"}), 2, "--resume: "));
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"in.glb"}));
}

TEST_F(Chunks, ResumingDrawsWhatIsMissingOrNotWhole) {
    ASSERT_TRUE(succeeded(render(sequence)));
    const auto whole = files();
    std::filesystem::remove(folder / "out.03.png");
    std::filesystem::remove(folder / "v.05.exr");
    cut("out.06.png", 0.5);
    cut("d.07.exr", 0.9);
    folder.write("out.08.png", "no picture");
    const auto kept = std::filesystem::last_write_time(folder / "out.02.png");
    const auto renewed = std::filesystem::last_write_time(folder / "out.05.png");
    ASSERT_TRUE(succeeded(render(with(sequence, {"--resume", "--stats", "s.json"}))));
    auto now = files();
    const std::string stats = now.extract("s.json").mapped();
    EXPECT_TRUE(now == whole);
    EXPECT_EQ(std::filesystem::last_write_time(folder / "out.02.png"), kept);
    EXPECT_NE(std::filesystem::last_write_time(folder / "out.05.png"), renewed) << "one of its files was missing";
    std::size_t drawn = 0; // each frame has its systems
    for (std::size_t at = stats.find("\"systems\""); at != stats.npos; at = stats.find("\"systems\"", at + 1)) ++drawn;
    EXPECT_EQ(drawn, 5u);
}

/// A file that is cut anywhere is drawn again.
TEST_F(Chunks, WhatIsCutShortIsNotKept) {
    const std::vector<std::string> frame{"-o", "out.#.exr", "--frames", "1", "--aov", "depth=d.#.exr", "--resume"};
    ASSERT_TRUE(succeeded(render(frame)));
    const auto whole = files();
    for (const double share : {0.05, 0.97}) {
        cut("out.1.exr", share);
        const ProcessResult result = render(frame);
        EXPECT_TRUE(succeeded(result));
        EXPECT_EQ(result.out, "") << share;
        EXPECT_TRUE(files() == whole) << share;
    }
}

TEST_F(Chunks, WhatHasAnotherSizeIsNotKept) {
    ASSERT_TRUE(succeeded(render({"-o", "out.#.png", "--frames", "1"})));
    ASSERT_TRUE(succeeded(render({"-o", "out.#.png", "--frames", "1", "--resume", "--size", "32x16"})));
    EXPECT_EQ(assets::read_image(folder / "out.1.png").width, 32);
}

TEST_F(Chunks, WhenAllIsThereNothingIsDone) {
    ASSERT_TRUE(succeeded(render(sequence)));
    const auto kept = std::filesystem::last_write_time(folder / "out.04.png");
    const ProcessResult result = render(with(sequence, {"--resume"}));
    EXPECT_TRUE(succeeded(result));
    EXPECT_NE(result.out.find("all 7 frames are there"), std::string::npos) << result.out;
    EXPECT_EQ(std::filesystem::last_write_time(folder / "out.04.png"), kept);
}

} // namespace
} // namespace hachure::test
