#include <hachure/tests/editor/program.h>

#include <unistd.h>

namespace hachure::test {
namespace {

/// A folder with a model in it, to render from and into.
class OutputErrors : public testing::Test {
protected:
    void SetUp() override { folder.write("in.obj", tetrahedron_obj); }

    ProcessResult render(const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"render", "in.obj", "--size", "32x24"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return hachure_program(folder, arguments);
    }

    void expect_refused(const std::vector<std::string>& more, const std::string& file) {
        const auto before = folder.listing();
        EXPECT_TRUE(failed(render(more), 1, file + ": "));
        EXPECT_EQ(folder.listing(), before);
    }

    TempFolder folder;
};

TEST_F(OutputErrors, FolderIsMissing) {
    expect_refused({"-o", "absent/out.png"}, "absent/out.png");
    expect_refused({"-o", "out.png", "--aov", "depth=absent/d.exr"}, "absent/d.exr");
    expect_refused({"-o", "out.png", "--stats", "absent/s.json"}, "absent/s.json");
}

TEST_F(OutputErrors, TargetIsAFolder) {
    std::filesystem::create_directory(folder / "out.png");
    std::filesystem::create_directory(folder / "d.exr");
    expect_refused({"-o", "out.png", "--aov", "normal=n.exr", "--stats", "s.json"}, "out.png");
    expect_refused({"-o", "other.png", "--aov", "normal=n.exr", "--aov", "depth=d.exr"}, "d.exr");
}

TEST_F(OutputErrors, FolderIsReadOnly) {
    if (::geteuid() == 0) GTEST_SKIP() << "root writes everywhere";
    std::filesystem::create_directory(folder / "shut");
    std::filesystem::permissions(folder / "shut",
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    expect_refused({"-o", "shut/out.png"}, "shut/out.png");
}

TEST_F(OutputErrors, NothingLeftWhenTheDriverRefuses) {
    // Without a display GLFW makes no context; the picture of an earlier run must survive that.
    folder.write("out.png", "old");
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    const auto before = folder.listing();
    EXPECT_TRUE(failed(render({"-o", "out.png", "--backend", "glfw"}), 1, "glfw"));
    EXPECT_EQ(folder.listing(), before);
    EXPECT_EQ(file_text(folder / "out.png"), "old");
}

} // namespace
} // namespace hachure::test
