#include <hachure/editor/play/play_report.h>
#include <hachure/tests/editor/play/synthetic_results.h>
#include <hachure/tests/support/process.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace hachure::test {
namespace {

using namespace play;

/// The report in a browser without a window. HACHURE_REPORT_PICTURES=FOLDER keeps pictures of it, to be looked at.
class ReportBrowser : public testing::Test {
protected:
    void SetUp() override {
        chromium_ = run_process({"/bin/sh", "-c", "command -v chromium"}).out;
        if (chromium_.empty()) GTEST_SKIP() << "chromium is not installed";
        chromium_.pop_back();
        write_report(folder.path(), synthetic_results(pictures));
    }

    ProcessResult browse(const std::vector<std::string>& options, const std::string& fragment = "") const {
        std::vector<std::string> command{chromium_,
                                         "--headless",
                                         "--no-sandbox",
                                         "--disable-gpu",
                                         "--disable-dev-shm-usage",
                                         "--no-first-run",
                                         "--hide-scrollbars",
                                         "--user-data-dir=" + (profile.path() / "profile").string()};
        command.insert(command.end(), options.begin(), options.end());
        command.push_back("file://" + (folder / "index.html").string() + fragment);
        return run_process(command);
    }

    TempFolder folder, pictures, profile;

private:
    std::string chromium_;
};

/// What the page finds when it uses itself: slider, blinking, film, cursor, filters, keys.
TEST_F(ReportBrowser, ThePageWorks) {
    for (const char* size : {"--window-size=1280,900", "--window-size=500,900"}) {
        const ProcessResult result = browse({"--dump-dom", "--virtual-time-budget=4000", size}, "#selftest");
        const std::size_t at = result.out.find("SELFTEST ", result.out.find("id=\"selftest-result\""));
        ASSERT_NE(at, std::string::npos) << result.out.size() << " bytes\n" << result.err;
        EXPECT_EQ(result.out.substr(at, result.out.find("</pre>", at) - at), "SELFTEST PASS") << size;
    }
}

TEST_F(ReportBrowser, ThePageShowsAPicture) {
    const std::filesystem::path file = profile / "page.png";
    const ProcessResult result = browse({"--screenshot=" + file.string(), "--window-size=1280,900"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const assets::Image image = assets::read_image(file);
    EXPECT_EQ(image.width, 1280);
    std::set<std::uint32_t> colors;
    for (std::size_t i = 0; i < image.pixels.size(); i += static_cast<std::size_t>(image.channels))
        colors.insert(image.u8()[i] << 16u | image.u8()[i + 1] << 8u | image.u8()[i + 2]);
    EXPECT_GT(colors.size(), 1000u) << "letters, and pictures in many tones";
    if (const char* keep = std::getenv("HACHURE_REPORT_PICTURES")) write_report(keep, synthetic_results(pictures));
}

} // namespace
} // namespace hachure::test
