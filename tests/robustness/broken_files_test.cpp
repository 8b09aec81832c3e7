#include <hachure/runtime/assets/read_model.h>
#include <hachure/tests/robustness/watched.h>
#include <hachure/tests/support/given_models.h>
#include <hachure/tests/support/temp_folder.h>

namespace hachure::test {
namespace {

constexpr int shards = 8;
constexpr std::size_t render_every = 1;

/// Every file of the pack's broken models, and what lies beside them, sorted.
std::vector<std::filesystem::path> broken_files() {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path root = test::given_models() / "broken";
    if (test::given_models().empty() || !std::filesystem::is_directory(root)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

bool is_model(const std::filesystem::path& file) { return assets::input_kind(file) == assets::InputKind::model; }
bool is_gltf(const std::filesystem::path& file) { return file.extension() == ".gltf" || file.extension() == ".glb"; }

/// A part of the files, so that the parts can run side by side.
class BrokenFiles : public testing::TestWithParam<int> {
protected:
    void SetUp() override {
        files = broken_files();
        if (files.empty()) GTEST_SKIP() << "HACHURE_MODELS names no folder with broken models";
    }

    template <class Visit> void each_of_shard(Visit visit) {
        for (std::size_t i = static_cast<std::size_t>(GetParam()); i < files.size(); i += shards) visit(i, files[i]);
    }

    std::vector<std::filesystem::path> files;
};

TEST_P(BrokenFiles, InfoIsSafe) {
    each_of_shard([&](std::size_t, const std::filesystem::path& file) {
        EXPECT_TRUE(is_safe(forked_command({"info", file.string()}), file.string()));
    });
}

/// Draws into a folder that must stay as it was when the file is refused.
void expect_safe_drawing(const TempFolder& folder, const std::filesystem::path& file, const ProcessResult& result) {
    EXPECT_TRUE(is_safe(result, file.string()));
    const std::set<std::string> expected =
        result.exit_code == 0 ? std::set<std::string>{"out.png"} : std::set<std::string>{};
    EXPECT_EQ(folder.listing(), expected) << file;
    std::filesystem::remove(folder / "out.png");
}

TEST_P(BrokenFiles, RenderIsSafe) {
    const TempFolder folder;
    std::size_t models = 0;
    each_of_shard([&](std::size_t, const std::filesystem::path& file) {
        if (!is_model(file) || (is_gltf(file) && models++ % render_every != 0)) return;
        expect_safe_drawing(
            folder, file, forked_command({"render", file.string(), "-o", "out.png", "--size", "64x48"}, folder.path()));
    });
}

TEST_P(BrokenFiles, TheProgramItselfIsSafe) {
    const TempFolder folder;
    std::size_t models = 0;
    each_of_shard([&](std::size_t, const std::filesystem::path& file) {
        if (!is_model(file) || models++ % 10 != 0) return;
        const std::vector<std::string> command{HACHURE_PROGRAM, "render", file.string(), "-o",
                                               "out.png",       "--size", "64x48"};
        expect_safe_drawing(folder, file, run_process(command, folder.path()));
    });
}

INSTANTIATE_TEST_SUITE_P(Part, BrokenFiles, testing::Range(0, shards));

} // namespace
} // namespace hachure::test
