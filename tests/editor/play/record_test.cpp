#include <hachure/editor/play/record.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/context.h>
#include <hachure/tests/editor/play/played.h>
#include <hachure/tests/editor/program.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <csignal>
#include <cstdlib>

namespace hachure::test {
namespace {

bool has_display() { return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY"); }

/// What a window would call, called by hand; in a process of its own, since windows have threads.
TEST(Record, TakesWhatAWindowSays) {
    if (!has_display()) GTEST_SKIP() << "there is no display";
    const TempFolder folder;
    const ProcessResult result = Process([&] {
                                     const auto context = gpu::make_context(
                                         {.backend = gpu::Backend::glfw, .width = 100, .height = 50, .visible = false});
                                     play::WindowInput input(context->window(), {200, 100});
                                     input.key(GLFW_KEY_SPACE, GLFW_PRESS);
                                     input.key(GLFW_KEY_SPACE, GLFW_REPEAT);
                                     input.key(GLFW_KEY_A, GLFW_RELEASE);
                                     input.move(1, 2);
                                     input.move(10, 5);
                                     input.button(GLFW_MOUSE_BUTTON_RIGHT, GLFW_PRESS);
                                     input.scroll(0, -1);
                                     play::write_recording(folder / "r.input.json", {{3, input.take()}});
                                     return input.take().empty() ? 0 : 1;
                                 }).wait();
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::vector<InputEvent> expected{{InputKind::key_down, "space", {}},
                                           {InputKind::key_up, "a", {}},
                                           {InputKind::pointer_move, "", {20.0f, 10.0f}},
                                           {InputKind::button_down, "right", {}},
                                           {InputKind::scroll, "", {0.0f, -1.0f}}};
    EXPECT_EQ(play::read_recording(folder / "r.input.json").at(3), expected);
}

/// Until a signal closes it (one: a second one would end it at once); then the recording is whole, and a test can
/// replay it.
TEST(Record, WritesARecordingThatReplays) {
    if (!has_display()) GTEST_SKIP() << "there is no display";
    const TempFolder folder;
    nlohmann::json test = still_test({{"frame", 0}, {"count", "surface"}, {"is", 4}});
    folder.write("t.play.json", test.dump());
    const ProcessResult result = run_process({"/usr/bin/timeout", "--foreground", "-s", "INT", "4", HACHURE_PROGRAM,
                                              "play", "t.play.json", "--record", "r.input.json"},
                                             folder.path());
    EXPECT_NE(result.out.find("frames recorded"), std::string::npos) << result.out << result.err;
    test["recording"] = "r.input.json";
    folder.write("t.play.json", test.dump());
    const ProcessResult replayed = hachure_program(folder, {"play", "t.play.json"});
    EXPECT_TRUE(succeeded(replayed)) << replayed.out;
}

TEST(Record, NeedsADisplay) {
    const TempFolder folder;
    folder.write("t.play.json", still_test({{"frame", 0}, {"count", "surface"}, {"is", 4}}).dump());
    const ProcessResult result = run_process({"/usr/bin/env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", HACHURE_PROGRAM,
                                              "play", "t.play.json", "--record", "r.input.json"},
                                             folder.path());
    EXPECT_TRUE(failed(result, 1, "glfw"));
    EXPECT_FALSE(std::filesystem::exists(folder / "r.input.json"));
}

} // namespace
} // namespace hachure::test
