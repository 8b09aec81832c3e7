#include <hachure/runtime/app/progress.h>
#include <hachure/tests/support/process.h>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <thread>

namespace hachure {
namespace {

TEST(Progress, SaysHowLongTheRestTakes) {
    EXPECT_EQ(progress_line("drawing", 0, 120, 3.0), "drawing 0/120");
    EXPECT_EQ(progress_line("drawing", 30, 120, 3.0), "drawing 30/120, 0:09 left");
    EXPECT_EQ(progress_line("drawing", 1, 101, 1.0), "drawing 1/101, 1:40 left");
    EXPECT_EQ(progress_line("drawing", 1, 3601, 1.5), "drawing 1/3601, 1:30:00 left");
    EXPECT_EQ(progress_line("drawing", 120, 120, 3.0), "drawing 120/120");
}

/// Half a second of steps, then one more.
int show_steps() {
    Progress progress("drawing");
    progress.step(1, 4);
    std::this_thread::sleep_for(std::chrono::milliseconds(550));
    progress.step(2, 4);
    return 0;
}

TEST(Progress, ShowsNothingWithoutATerminal) {
    test::Process process(show_steps);
    EXPECT_EQ(process.wait().err, "");
}

TEST(Progress, RewritesALineOfATerminalAndClearsIt) {
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) GTEST_SKIP() << "no terminals here";
    const std::string name = ::ptsname(terminal);
    test::Process process([&name] {
        const int own = ::open(name.c_str(), O_RDWR | O_NOCTTY);
        ::dup2(own, STDERR_FILENO);
        return show_steps();
    });
    std::string shown;
    char bytes[256];
    for (ssize_t got = 0; (got = ::read(terminal, bytes, sizeof bytes)) > 0;)
        shown.append(bytes, static_cast<std::size_t>(got));
    ::close(terminal);
    EXPECT_EQ(process.wait().exit_code, 0);
    EXPECT_EQ(shown, "\r\033[Kdrawing 2/4, 0:01 left\r\033[K");
}

} // namespace
} // namespace hachure
