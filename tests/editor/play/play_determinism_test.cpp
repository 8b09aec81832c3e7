#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/editor/play/played.h>
#include <hachure/tests/editor/program.h>

#include <fmt/format.h>

// The same frame is the same, bit for bit, however it was come to.
namespace hachure::test {
namespace {

using nlohmann::json;
using PlayDeterminism = Played;

/// An arm that bends; every expectation is of exact bits.
json arm_test(const std::string& golden) {
    json test{
        {"hachure_play", 1}, {"scene", playback_model("arm.glb")}, {"fps", 30}, {"size", {160, 120}}, {"frames", 21}};
    for (const int frame : {0, 10, 20})
        test["expect"].push_back({{"frame", frame},
                                  {"picture", fmt::format("{}{}.png", golden, frame)},
                                  {"gates", {{"difference", 0}, {"share", 0}}}});
    test["expect"].push_back({{"frame", 20},
                              {"aov", "velocity"},
                              {"picture", golden + ".exr"},
                              {"gates", {{"difference", 0}, {"share", 0}}}});
    return test;
}

TEST_F(PlayDeterminism, DoesNotDependOnThreads) {
    EXPECT_EQ(failure(play(arm_test("g"), {.update = true}, 1)), "");
    for (const int threads : {1, 2, 4}) EXPECT_EQ(failure(play(arm_test("g"), {}, threads)), "") << threads;
}

TEST_F(PlayDeterminism, DoesNotDependOnWhichFramesAreDrawn) {
    EXPECT_EQ(failure(play(arm_test("g"), {.update = true})), "");
    for (const std::int64_t from : {1, 10, 20}) {
        const play::PlayResult result = play(arm_test("g"), {.from = from});
        EXPECT_EQ(failure(result), "") << from;
        EXPECT_EQ(result.frames, 21);
        EXPECT_NE(result.expectations.at(0).reason.find("not looked at"), std::string::npos);
    }
    std::filesystem::create_directory(folder_ / "evidence");
    EXPECT_EQ(failure(play(arm_test("g"), {.evidence = folder_ / "evidence"})), "") << "with the frames of the strip";
}

TEST_F(PlayDeterminism, DoesNotDependOnJobs) {
    for (int i = 0; i < 5; ++i) folder_.write(fmt::format("t{}.play.json", i), arm_test(fmt::format("g{}", i)).dump());
    ASSERT_TRUE(succeeded(hachure_program(folder_, {"play", ".", "--update"})));
    const ProcessResult one = hachure_program(folder_, {"play", "."});
    const ProcessResult four = hachure_program(folder_, {"play", ".", "--jobs", "4", "--threads", "2"});
    EXPECT_TRUE(succeeded(one)) << one.out;
    EXPECT_TRUE(succeeded(four)) << four.out;
    std::size_t at = 0;
    for (int i = 0; i < 5; ++i) {
        at = four.out.find(fmt::format("ok     ./t{}", i), at);
        ASSERT_NE(at, four.out.npos) << "in their order\n" << four.out;
    }
}

} // namespace
} // namespace hachure::test
