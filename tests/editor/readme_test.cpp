// README.md's first scene and first playback test, run from its own text: what a newcomer copies works.

#include <hachure/tests/support/process.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace hachure {
namespace {

/// The fenced block after each "<!-- MARKER ARGUMENT -->" of README.md.
struct Block {
    std::string argument;
    std::string text;
};

std::vector<Block> blocks_of(const std::string& marker) {
    const std::string start = "<!-- " + marker;
    std::vector<Block> result;
    std::ifstream page(std::filesystem::path(HACHURE_SOURCE_DIR) / "README.md");
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with(start)) continue;
        std::istringstream rest(line.substr(start.size()));
        Block block;
        rest >> block.argument;
        std::getline(page, line);
        EXPECT_TRUE(line.starts_with("```")) << "after " << start << block.argument;
        while (std::getline(page, line) && line != "```") block.text += line + "\n";
        result.push_back(std::move(block));
    }
    return result;
}

class ReadmeScene : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists("/usr/share/glmark2/models/bunny.obj")) GTEST_SKIP() << "the bunny is not there";
        for (const Block& file : blocks_of("save as:")) folder_.write(file.argument, file.text);
    }

    /// Runs a line of the README: the program of this build, in a folder that holds its files.
    test::ProcessResult run(const std::string& line) {
        std::istringstream words(line);
        std::vector<std::string> command;
        for (std::string word; words >> word;) command.push_back(command.empty() ? HACHURE_PROGRAM : word);
        return test::run_process(command, folder_.path());
    }

    test::TempFolder folder_;
};

TEST_F(ReadmeScene, WorksAsWritten) {
    std::size_t commands = 0;
    for (const Block& block : blocks_of("run")) {
        std::istringstream lines(block.text);
        for (std::string line; std::getline(lines, line); ++commands) {
            EXPECT_TRUE(line.starts_with("hachure ")) << line;
            const test::ProcessResult result = run(line);
            EXPECT_EQ(result.exit_code, 0) << line << "\n" << result.out << result.err;
            EXPECT_EQ(result.err, "") << line;
        }
    }
    EXPECT_GE(commands, 3u);
    EXPECT_GE(folder_.listing().size(), 6u);
}

TEST_F(ReadmeScene, TestFailsWhenTheScriptIsWrong) {
    const std::string good = test::file_text(folder_ / "spin.lua");
    const std::size_t at = good.find("time.seconds");
    ASSERT_NE(at, good.npos);
    folder_.write("spin.lua", good.substr(0, at) + "2 * " + good.substr(at));
    ASSERT_EQ(run("hachure play first.play.json --update").exit_code, 1) << "the field's value is not updated";
    const test::ProcessResult result = run("hachure play first.play.json");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE((result.out + result.err).find("transform.rotation"), std::string::npos) << result.out << result.err;
}

} // namespace
} // namespace hachure
