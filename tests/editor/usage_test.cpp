#include <hachure/tests/editor/forked_command.h>
#include <hachure/tests/editor/program.h>

namespace hachure::test {
namespace {

TEST(Usage, EveryCommandHelps) {
    const TempFolder folder;
    for (const char* command : {"render", "info", "list"}) {
        const ProcessResult result = forked_command({command, "--help"}, folder.path());
        EXPECT_TRUE(succeeded(result)) << command;
        EXPECT_NE(result.out.find(command), std::string::npos) << result.out;
    }
}

TEST(Usage, HelpNamesEveryCommandAndOption) {
    const TempFolder folder;
    const ProcessResult all = forked_command({"--help"}, folder.path());
    EXPECT_TRUE(succeeded(all));
    for (const char* command : {"render", "info", "list"})
        EXPECT_NE(all.out.find(command), std::string::npos) << command;
    const std::string render = forked_command({"render", "--help"}, folder.path()).out;
    for (const char* option : {"--output", "--style", "--size", "--backend", "--aov", "--set", "--stats", "--threads",
                               "--frames", "--time", "--fps", "--clip"})
        EXPECT_NE(render.find(option), std::string::npos) << option;
}

TEST(Usage, TellsItsVersion) {
    const TempFolder folder;
    const ProcessResult result = hachure_program(folder, {"--version"}); // the program itself, once
    EXPECT_TRUE(succeeded(result));
    EXPECT_TRUE(result.out.starts_with("hachure ")) << result.out;
}

/// Arguments that make no sense, and what the message must name. The input exists, so that it can't be the fault.
struct WrongUsage {
    const char* name;
    std::vector<std::string> arguments;
    const char* says;
};

class UsageTest : public testing::TestWithParam<WrongUsage> {};

TEST_P(UsageTest, ExitsWithTwoAndWritesNothing) {
    const TempFolder folder;
    folder.write("in.obj", tetrahedron_obj);
    const auto before = folder.listing();
    EXPECT_TRUE(failed(forked_command(GetParam().arguments, folder.path()), 2, GetParam().says));
    EXPECT_EQ(folder.listing(), before);
}

/// Arguments of which the output is one.
WrongUsage film(const char* name, std::vector<std::string> more, const char* says) {
    more.insert(more.begin(), {"render", "in.obj", "-o"});
    return {name, more, says};
}

WrongUsage render(const char* name, std::vector<std::string> more, const char* says) {
    std::vector<std::string> arguments{"render", "in.obj", "-o", "out.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return {name, arguments, says};
}

INSTANTIATE_TEST_SUITE_P(
    Arguments, UsageTest,
    testing::Values(
        WrongUsage{"NoCommand", {}, "subcommand"}, WrongUsage{"UnknownCommand", {"paint"}, "subcommand"},
        WrongUsage{"NoInput", {"render", "-o", "out.png"}, "INPUT"},
        WrongUsage{"NoOutput", {"render", "in.obj"}, "--output"},
        WrongUsage{"UnknownInfoOption", {"info", "in.obj", "--deep"}, "--deep"},
        WrongUsage{"TwoInputs", {"info", "in.obj", "in.obj"}, "in.obj"},
        WrongUsage{"UnknownKind", {"list", "colours"}, "colours"}, WrongUsage{"NoKind", {"list"}, "KIND"},
        WrongUsage{"OutputOfNoKind", {"render", "in.obj", "-o", "out.txt"}, "out.txt"},
        WrongUsage{"OutputWithoutExtension", {"render", "in.obj", "-o", "out"}, "out"},
        render("UnknownOption", {"--colour", "red"}, "--colour"), render("OptionWithoutValue", {"--size"}, "--size"),
        render("SizeZero", {"--size", "0x10"}, "0x10"), render("SizeNegative", {"--size=-4x10"}, "-4x10"),
        render("SizeHalf", {"--size", "640"}, "640"), render("SizeTrailing", {"--size", "64x48px"}, "64x48px"),
        render("SizeOverflow", {"--size", "99999999999x1"}, "99999999999x1"),
        render("SizeTooLarge", {"--size", "20000x10"}, "16384"),
        render("UnknownBackend", {"--backend", "vulkan"}, "vulkan"),
        render("UnknownAov", {"--aov", "heat=h.exr"}, "heat"), render("AovWithoutFile", {"--aov", "depth"}, "depth"),
        render("AovEmptyFile", {"--aov", "depth="}, "depth="), render("AovOfNoKind", {"--aov", "depth=d.png"}, "d.png"),
        render("SameFileTwice", {"--aov", "depth=d.exr", "--aov", "normal=d.exr"}, "d.exr"),
        render("ThreadsZero", {"--threads", "0"}, "--threads"),
        render("ThreadsNegative", {"--threads=-2"}, "--threads"),
        render("ThreadsNoNumber", {"--threads", "many"}, "many"), render("ThreadsHalf", {"--threads", "1.5"}, "1.5"),
        render("UnknownStyle", {"--style", "cubism"}, "cubism"),
        render("SetWithoutValue", {"--set", "gooch.b"}, "gooch.b"),
        render("SetWithoutField", {"--set", "gooch=1"}, "gooch"),
        render("SetUnknownComponent", {"--set", "glow.x=1"}, "glow"),
        render("SetUnknownField", {"--set", "gooch.blue=1"}, "blue"),
        render("SetNoNumber", {"--set", "gooch.b=blue"}, "blue"),
        render("SetOutOfRange", {"--set", "gooch.b=7"}, "gooch.b"),
        render("SetNotANumber", {"--set", "gooch.b=nan"}, "gooch.b"),
        render("SetTooFewNumbers", {"--set", "compose.background=1 1"}, "compose.background"),
        render("SetUnknownChoice", {"--set", "light.kind=sun"}, "sun"),
        render("SeveralFramesInOnePicture", {"--frames", "0..3"}, "out.####.png"),
        render("SeveralFramesInOneBuffer", {"--frames", "0..3", "--aov", "depth=d.exr"}, "out.png"),
        render("FramesBackwards", {"--frames", "3..1"}, "3..1"), render("FramesNegative", {"--frames=-3..1"}, "-3..1"),
        render("FramesNoNumbers", {"--frames", "a..b"}, "a..b"), render("FramesHalf", {"--frames", "1.."}, "1.."),
        render("FramesTooMany", {"--frames", "0..2000000"}, "1000000"),
        render("FramesAndTime", {"--frames", "1", "--time", "1"}, "--frames"),
        render("TimeNegative", {"--time=-1"}, "-1"), render("TimeNoNumber", {"--time", "soon"}, "soon"),
        render("FpsZero", {"--fps", "0"}, "--fps"), render("FpsTooMany", {"--fps", "1001"}, "1001"),
        render("FpsNoNumber", {"--fps", "fast"}, "fast")),
    [](const auto& wrong) { return std::string(wrong.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Frames, UsageTest,
    testing::Values(
        film("ExrOfSeveralFrames", {"out.exr", "--frames", "0..1"}, "out.####.exr"),
        film("BufferOfSeveralFrames", {"a.#.png", "--frames", "0..3", "--aov", "depth=d.exr"}, "d.####.exr"),
        film("GifWithoutFrames", {"out.gif"}, "--frames"), film("Mp4WithoutFrames", {"out.mp4"}, "--frames"),
        film("FilmOfATime", {"out.mp4", "--time", "1"}, "--frames"),
        film("NumberedFilm", {"out.##.mp4", "--frames", "0..3"}, "out.##.mp4"),
        film("TwoNumbers", {"a#b#.png", "--frames", "0..3"}, "a#b#.png"),
        film("NumberOfATime", {"out.#.png", "--time", "1"}, "--time"),
        film("GifTooFast", {"out.gif", "--frames", "0..3", "--fps", "60"}, "50"),
        film("SameFileByNumber", {"a.#.png", "--frames", "0..20", "--aov", "depth=d0#.exr", "--aov", "normal=d##.exr"},
             "d00.exr"),
        film("SameFileByOtherWords", {"a.png", "--aov", "depth=d.exr", "--aov", "normal=./d.exr"}, "d.exr"),
        film("StatsOverAFrame", {"a.#.exr", "--frames", "0..20", "--stats", "a.7.exr"}, "a.7.exr")),
    [](const auto& wrong) { return std::string(wrong.param.name); });

} // namespace
} // namespace hachure::test
