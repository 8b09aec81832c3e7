#include <hachure/tests/editor/program.h>

#include <gtest/gtest.h>

#include <string>

namespace hachure::test {
namespace {

constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(ThinLines, AreWarnedOfOnce) {
    const TempFolder folder;
    folder.write("square.obj", square);
    const auto render = [&](const std::string& width) {
        return hachure_program(folder, {"render", "square.obj", "-o", "square.##.png", "--style", "lines", "--size",
                                        "64x48", "--frames", "0..2", "--set", "abstracted_lines.width=" + width});
    };
    const ProcessResult thin = render("1.5"), wide = render("3");
    EXPECT_EQ(thin.exit_code, 0);
    EXPECT_EQ(count(thin.err, "lines 1.5 px wide are found as lines of 3 px are"), 1u) << thin.err;
    EXPECT_TRUE(succeeded(wide));
    EXPECT_EQ(wide.err.find("px wide"), wide.err.npos) << wide.err;
}

} // namespace
} // namespace hachure::test
