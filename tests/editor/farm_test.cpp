#include <hachure/tests/editor/program.h>
#include <hachure/tests/support/glb_file.h>
#include <hachure/tests/support/slurm_cluster.h>

#include <map>

namespace hachure::test {
namespace {

const std::filesystem::path farm = std::filesystem::path(HACHURE_SOURCE_DIR) / "samples/farm";

/// The scripts of samples/farm, each against one run of the program.
class Farm : public testing::Test {
protected:
    Farm() {
        folder.write("in.glb", moving_square_glb());
        ::setenv("HACHURE", HACHURE_PROGRAM, 1);
    }
    ~Farm() override { ::unsetenv("HACHURE"); }

    /// What a script is given: a name with a blank in it, too.
    static std::vector<std::string> sequence(const std::string& output) {
        return {"in.glb", "-o", output + ".##.png", "--frames", "0..6", "--size", "64x32"};
    }

    [[nodiscard]] std::map<std::string, std::string> frames(const std::string& output) const {
        std::map<std::string, std::string> result;
        for (const std::string& name : folder.listing())
            if (name.starts_with(output)) result[name.substr(output.size())] = file_text(folder / name);
        return result;
    }

    ProcessResult run(std::vector<std::string> command, const std::string& output) {
        for (std::string& argument : sequence(output)) command.push_back(std::move(argument));
        return run_process(command, folder.path());
    }

    /// Expects that what a script drew is what one run of the program does.
    void expect_same() {
        ASSERT_TRUE(succeeded(run({HACHURE_PROGRAM, "render"}, "one")));
        const auto whole = frames("one");
        EXPECT_EQ(whole.size(), 7u);
        EXPECT_TRUE(frames("far m") == whole) << file_text(folder / "hachure-1_1.log");
    }

    TempFolder folder;
};

TEST_F(Farm, OnOneMachine) {
    if (run_process({"/bin/sh", "-c", "command -v parallel"}).exit_code != 0)
        GTEST_SKIP() << "GNU parallel is not installed";
    const ProcessResult result = run({farm / "farm_local.sh"}, "far m");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    expect_same();
}

TEST_F(Farm, OnSlurm) {
    const SlurmCluster cluster;
    if (!cluster.ready()) GTEST_SKIP() << "no Slurm: " << cluster.reason();
    const ProcessResult result = run({"/usr/bin/env", "sbatch", "--array=1-2", farm / "farm.sbatch"}, "far m");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    ASSERT_TRUE(cluster.finish());
    expect_same();
    EXPECT_TRUE(std::filesystem::exists(folder / "hachure-1_2.log")) << "it was no array of two";
}

} // namespace
} // namespace hachure::test
