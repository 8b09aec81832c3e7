#include <hachure/editor/play/junit.h>
#include <hachure/tests/editor/play/played.h>
#include <hachure/tests/editor/program.h>

#include <limits>

namespace hachure::test {
namespace {

using nlohmann::json;

json count_test(int surfaces) { return still_test({{"frame", 0}, {"count", "surface"}, {"is", surfaces}}); }

/// It never ends in time.
json long_test() {
    json test = still_test({{"frames", {0, 999999}}, {"passes", json::array()}});
    test["frames"] = 1000000;
    return test;
}

bool says(const ProcessResult& result, const std::string& text) { return result.out.find(text) != std::string::npos; }

TEST(PlayCommand, FindsTestsInFoldersAndFailsWithReasons) {
    const TempFolder folder;
    std::filesystem::create_directories(folder / "a/b");
    folder.write("a/two.play.json", count_test(5).dump());
    folder.write("a/b/one.play.json", count_test(4).dump());
    folder.write("a/other.json", "{}");
    const ProcessResult result = hachure_program(folder, {"play", "a", "--junit", "j.xml"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(says(result, "ok     a/b/one.play.json")) << result.out;
    EXPECT_TRUE(says(result, "FAILED a/two.play.json"));
    EXPECT_TRUE(says(result, "/expect/0: frame 0: 5 of surface: there are 4, not 5"));
    EXPECT_NE(result.err.find("1 of 2 playback tests failed"), std::string::npos) << result.err;
    const std::string xml = file_text(folder / "j.xml");
    EXPECT_NE(xml.find("<failure message=\"there are 4, not 5\"/>"), std::string::npos) << xml;
}

TEST(PlayCommand, ABadTestIsAFailedOne) {
    const TempFolder folder;
    folder.write("bad.play.json",
                 R"({"hachure_play": 1, "scene": "x.glb", "expect": [{"frame": 0, "count": "surface"}]})");
    folder.write("gone.play.json",
                 R"({"hachure_play": 1, "scene": "x.glb", "expect": [{"frame": 0, "count": "surface", "is": 1}]})");
    folder.write("good.play.json", count_test(4).dump());
    const ProcessResult result = hachure_program(folder, {"play", "."});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(says(result, "either is, or at_least and at_most (line 1, column")) << result.out;
    EXPECT_TRUE(says(result, "x.glb")) << result.out;
    EXPECT_TRUE(says(result, "ok     ./good.play.json"));
}

TEST(PlayCommand, ATestThatHangsIsStopped) {
    const TempFolder folder;
    folder.write("a.play.json", long_test().dump());
    folder.write("b.play.json", count_test(4).dump());
    const ProcessResult result = hachure_program(folder, {"play", ".", "--limit", "3", "--jobs", "2"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(says(result, "it had not ended after 3 s and was stopped")) << result.out;
    EXPECT_TRUE(says(result, "ok     ./b.play.json"));
}

/// The system ends a process that takes more than a second of CPU time.
TEST(PlayCommand, ATestThatCrashesIsAFailedOne) {
    const TempFolder folder;
    folder.write("a.play.json", long_test().dump());
    folder.write("b.play.json", count_test(4).dump());
    const ProcessResult result =
        run_process({"/bin/sh", "-c", "ulimit -t 1; exec \"$0\" play . --junit j.xml", HACHURE_PROGRAM}, folder.path());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(says(result, "it crashed: ")) << result.out;
    EXPECT_TRUE(says(result, "ok     ./b.play.json")) << result.out;
    EXPECT_NE(file_text(folder / "j.xml").find("<error message=\"it crashed"), std::string::npos);
}

TEST(PlayCommand, LeavesNothingBehindButWhatItWasAskedFor) {
    const TempFolder folder, temporary;
    folder.write("t.play.json", still_test({{"frame", 1}, {"picture", "golden/g.png"}}).dump());
    const ProcessResult updated = run_process(
        {"/usr/bin/env", "TMPDIR=" + temporary.path().string(), HACHURE_PROGRAM, "play", "t.play.json", "--update"},
        folder.path());
    EXPECT_TRUE(succeeded(updated));
    EXPECT_NE(updated.out.find("written: golden/g.png"), std::string::npos) << updated.out;
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"golden", "golden/g.png", "t.play.json"}));
    EXPECT_TRUE(temporary.listing().empty());
    EXPECT_TRUE(succeeded(hachure_program(folder, {"play", "t.play.json", "--report", "r"})));
    EXPECT_TRUE(std::filesystem::exists(folder / "r/index.html"));
}

TEST(PlayCommand, ASignalEndsItWithNothingLeft) {
    const TempFolder folder, temporary;
    folder.write("t.play.json", long_test().dump());
    const ProcessResult result = run_process({"/usr/bin/env", "TMPDIR=" + temporary.path().string(), "/usr/bin/timeout",
                                              "--foreground", "-s", "INT", "2", HACHURE_PROGRAM, "play", "."},
                                             folder.path());
    EXPECT_NE(result.exit_code, 0);
    EXPECT_TRUE(temporary.listing().empty());
    EXPECT_EQ(folder.listing().size(), 1u);
}

TEST(PlayCommand, ChecksItsUse) {
    const TempFolder folder;
    std::filesystem::create_directory(folder / "empty");
    folder.write("t.play.json", count_test(4).dump());
    EXPECT_TRUE(failed(hachure_program(folder, {"play", "missing"}), 1, "there is no such file or folder"));
    EXPECT_TRUE(failed(hachure_program(folder, {"play", "empty"}), 1, "holds no playback test"));
    EXPECT_TRUE(failed(hachure_program(folder, {"play", "t.play.json", "--backend", "vulkan"}), 2, "vulkan"));
    EXPECT_TRUE(failed(hachure_program(folder, {"play", "t.play.json", "--update", "--from", "1"}), 2, "--update"));
    EXPECT_TRUE(
        failed(hachure_program(folder, {"play", "t.play.json", "t.play.json", "--record", "r.json"}), 2, "--record"));
}

TEST(PlayResultJson, ComesBackAsItWas) {
    play::PlayResult r;
    r.file = "a.play.json";
    r.error = "it said \"no\"";
    r.frames = 3;
    r.log = {"one", "two"};
    r.passes = {{"gooch", 1, 2, 3, 0.5, 0.25}};
    r.strip = {{7, "s.png"}};
    play::ExpectationResult e{
        .kind = "picture", .what = "frame 1", .pointer = "/expect/0", .passed = true, .reason = "x"};
    e.picture =
        play::PictureEvidence{"g.png", "a.png", "d.png", 3, 0.5, 0.25, 1, std::numeric_limits<double>::infinity()};
    e.curves = {{"popping", "1/255", 4, {1, std::numeric_limits<double>::quiet_NaN()}, std::nullopt, 8.0}};
    e.frames = {"f.png"};
    r.expectations = {e};
    const json written = play::to_json(r);
    const play::PlayResult back = play::result_from_json(json::parse(written.dump()));
    EXPECT_EQ(play::to_json(back), written);
    EXPECT_TRUE(std::isinf(back.expectations.at(0).picture->line_distance));
    EXPECT_TRUE(std::isnan(back.expectations[0].curves[0].values[1]));
    EXPECT_FALSE(back.expectations[0].curves[0].at_least.has_value());
}

TEST(Junit, CountsAndEscapes) {
    play::PlayResult r;
    r.file = "a&b.play.json";
    r.error = "<crash>\x01";
    r.expectations = {{.kind = "count", .what = "1 < 2", .pointer = "/expect/0", .passed = false, .reason = "\"so\""},
                      {.kind = "count", .what = "fine", .pointer = "/expect/1", .passed = true}};
    const std::string xml = play::junit_xml(std::span(&r, 1));
    EXPECT_NE(xml.find("name=\"a&amp;b.play.json\" tests=\"3\" failures=\"1\" errors=\"1\""), std::string::npos) << xml;
    EXPECT_NE(xml.find("<failure message=\"&quot;so&quot;\"/>"), std::string::npos);
    EXPECT_NE(xml.find("<error message=\"&lt;crash&gt;?\"/>"), std::string::npos);
    EXPECT_NE(xml.find("name=\"/expect/0 1 &lt; 2\""), std::string::npos);
}

} // namespace
} // namespace hachure::test
