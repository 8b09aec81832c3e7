#include <hachure/runtime/assets/image_file.h>
#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/glb_file.h>

#include <csignal>
#include <thread>

namespace hachure::test {
namespace {

/// Ctrl-C in the middle of long work.
class Interrupted : public testing::Test {
protected:
    void SetUp() override { folder.write("in.glb", two_squares_glb()); }

    /// Starts rendering to `output`, sends SIGINT as soon as `begun` says so, and expects it to be what ends the
    /// program.
    template <class Begun> void interrupt(const char* output, Begun begun) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            static_cast<void>(::chdir(folder.path().c_str()));
            ::execl(HACHURE_PROGRAM, "hachure", "render", "in.glb", "-o", output, "--size", "64x32", "--frames",
                    "0..999999", nullptr);
            ::_exit(127);
        }
        bool seen = false;
        for (int i = 0; i < 5000 && !(seen = begun()); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        EXPECT_TRUE(seen) << "it was never begun";
        ::kill(child, SIGINT);
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
    }

    TempFolder folder;
};

TEST_F(Interrupted, ASequenceKeepsItsWholePictures) {
    interrupt("out.#.png", [this] { return std::filesystem::exists(folder / "out.20.png"); });
    const std::set<std::string> names = folder.listing();
    ASSERT_GE(names.size(), 22u);
    for (std::size_t i = 0; i + 1 < names.size(); ++i) { // no gap, and nothing else
        const std::string name = "out." + std::to_string(i) + ".png";
        ASSERT_TRUE(names.contains(name)) << name;
        EXPECT_EQ(assets::read_image(folder / name).width, 64);
    }
}

TEST_F(Interrupted, AFilmLeavesTheOlderOne) {
    folder.write("out.mp4", "old");
    const std::set<std::string> before = folder.listing();
    interrupt("out.mp4", [&] {
        // Its temporary file grows once frames have been encoded.
        for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
            if (entry.path().filename().string().starts_with(".out.mp4.") && entry.file_size() > 10'000) return true;
        return false;
    });
    EXPECT_EQ(folder.listing(), before);
    EXPECT_EQ(file_text(folder / "out.mp4"), "old");
}

} // namespace
} // namespace hachure::test
