#include <hachure/editor/play/play_report.h>
#include <hachure/runtime/error.h>
#include <hachure/tests/editor/play/synthetic_results.h>

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <vector>

namespace hachure::test {
namespace {

using namespace play;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// The page without what its scripts and styles say.
std::string markup(const std::string& page) {
    std::string text = page;
    for (const std::string element : {"script", "style"})
        for (std::size_t at = text.find("<" + element + ">"); at != text.npos; at = text.find("<" + element + ">"))
            text.erase(at, text.find("</" + element + ">", at) + element.size() + 3 - at);
    return text;
}

/// Empty when every element is closed where it should be.
std::string unbalanced(const std::string& html) {
    const std::set<std::string> empty{"meta", "link", "img", "input"};
    std::vector<std::string> open;
    const std::regex tag("<(/?)([a-z0-9]+)(\\s[^<>]*)?(/?)>");
    // Data URIs are too long for a regular expression.
    std::string rest;
    for (std::size_t at = 0; at < html.size();) {
        const std::size_t data = html.find("base64,", at);
        rest += html.substr(at, data == html.npos ? data : data - at);
        at = data == html.npos ? html.size() : html.find('"', data);
    }
    for (auto i = std::sregex_iterator(rest.begin(), rest.end(), tag); i != std::sregex_iterator(); ++i) {
        const std::string name = (*i)[2];
        if (empty.contains(name) || (*i)[3].str().ends_with('/') || (*i)[4].length() > 0) continue;
        if ((*i)[1].length() == 0) {
            open.push_back(name);
        } else {
            if (open.empty() || open.back() != name) return "</" + name + "> at " + std::to_string(i->position());
            open.pop_back();
        }
    }
    return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

TEST(PlayReport, HasEveryPartOfATest) {
    const TempFolder folder;
    const std::string page = markup(report_page(synthetic_results(folder)));
    EXPECT_EQ(unbalanced(page), "");
    EXPECT_EQ(count(page, "<details class=\"test "), 5u);
    EXPECT_NE(page.find("<h1>2 of 5 tests failed</h1>"), std::string::npos);
    EXPECT_NE(page.find("<h2>fox_run</h2>"), std::string::npos);
    EXPECT_NE(page.find("tests/playback/fox_run.play.json</dd>"), std::string::npos);
    EXPECT_NE(page.find("while the light turns once"), std::string::npos);
    EXPECT_NE(page.find("attempt to index a nil value"), std::string::npos);
    EXPECT_NE(page.find("fox.lua:14: wind is nil"), std::string::npos);
    EXPECT_NE(page.find("12.4 s"), std::string::npos);
    EXPECT_NE(page.find("hachure play tests/playback/fox_run.play.json --from 30</code>"), std::string::npos);
    EXPECT_NE(page.find("FLIP p99 is 0.214"), std::string::npos);
    EXPECT_EQ(count(page, "class=\"wipe\""), 4u);
    EXPECT_EQ(count(page, "class=\"film\""), 1u);
    EXPECT_EQ(count(page, "class=\"strip\""), 1u);
    EXPECT_EQ(count(page, "<table>"), 4u);
    EXPECT_EQ(count(page, "<figure class=\"curve\""), 4u + 3u);
    EXPECT_EQ(count(page, "<img "), 4u * 3u + 12u + 12u);
    EXPECT_NE(page.find("<th scope=\"row\">edge_lines</th>"), std::string::npos);
    EXPECT_NE(page.find("<td>61</td><td>29</td><td>0</td><td>220.13</td><td>–</td>"), std::string::npos);
}

TEST(PlayReport, FailedTestsComeFirstAndAreOpen) {
    const TempFolder folder;
    const std::string page = report_page(synthetic_results(folder));
    std::vector<std::string> statuses;
    const std::regex test(
        "<details class=\"test (failed|passed)\" id=\"test-[0-9]+\" data-status=\"[a-z ]+\"( open)?>");
    const std::string text = markup(page);
    for (std::size_t at = text.find("<details class=\"test "); at != text.npos;
         at = text.find("<details class=\"test ", at + 1)) {
        std::smatch match;
        const std::string line = text.substr(at, text.find('\n', at) - at);
        ASSERT_TRUE(std::regex_match(line, match, test)) << line;
        statuses.push_back(match[1].str() + match[2].str());
    }
    EXPECT_EQ(statuses, (std::vector<std::string>{"failed open", "failed open", "passed", "passed", "passed"}));
}

TEST(PlayReport, AFilmBeginsWithTheFrameThatIsWrong) {
    const TempFolder folder;
    const std::string page = report_page(std::vector{failing_result(folder)});
    EXPECT_EQ(count(page, "<img class=\"shown\" alt=\"frame 26\""), 1u);
    EXPECT_EQ(count(page, "<img class=\"shown\""), 1u);
    EXPECT_NE(page.find("max=\"11\" step=\"1\" value=\"6\""), std::string::npos);
}

/// Pictures of the strip that stand for frames in which something failed: 24 to 31 (26, 27, 30) and 56 to 63.
TEST(PlayReport, TheStripMarksWhatFailed) {
    const TempFolder folder;
    const std::string page = report_page(std::vector{failing_result(folder)});
    std::vector<std::string> marked;
    const std::string figure = "<figure class=\"wrong\"><img class=\"\" alt=\"frame ";
    for (std::size_t at = page.find(figure); at != page.npos; at = page.find(figure, at + 1))
        marked.push_back(page.substr(at + figure.size(), 2));
    EXPECT_EQ(marked, (std::vector<std::string>{"24", "56"}));
}

/// A page that needs nothing but itself.
TEST(PlayReport, AsksForNothing) {
    const TempFolder folder;
    const std::string page = report_page(synthetic_results(folder));
    for (const char* part : {"http:", "https:", "url(", "@import", "<iframe", "<object", "fetch(", "XMLHttp"})
        EXPECT_EQ(page.find(part), std::string::npos) << part;
    const std::string text = markup(page);
    EXPECT_EQ(count(text, "src="), count(text, "src=\"data:image/png;base64,"));
    EXPECT_EQ(count(text, "href="), count(text, "href=\"data:,\""));
}

/// Names that would be markup, end attributes, or are no text at all.
TEST(PlayReport, NothingFromFilesIsMarkup) {
    const std::string evil = "<script>alert(1)</script>\"' onload=\"x\" \xFF\xC3 </details></pre>-->";
    PlayResult result{.file = "x/" + evil + ".play.json", .doc = evil, .error = evil, .renderer = evil, .log = {evil}};
    Curve curve{.name = evil, .unit = evil, .values = {1, 2}};
    ExpectationResult expectation{.kind = evil, .what = evil, .pointer = evil, .reason = evil};
    expectation.picture = PictureEvidence{evil, evil, evil};
    expectation.curves = {curve};
    expectation.frames = {evil, evil};
    result.expectations = {expectation};
    result.curves = {curve};
    result.passes = {{evil, 1, 2, 3}};
    result.strip = {{0, evil}};
    result.replay = evil;
    const std::string page = report_page(std::vector{result});
    EXPECT_EQ(count(page, "<script>"), count(page, "</script>"));
    const std::string text = markup(page);
    EXPECT_EQ(unbalanced(text), "");
    EXPECT_EQ(text.find("<script>"), std::string::npos);
    EXPECT_EQ(text.find("alert(1)</"), std::string::npos);
    EXPECT_EQ(text.find("onload=\"x"), std::string::npos);
    EXPECT_EQ(text.find('\xFF'), std::string::npos);
    EXPECT_GE(count(text, "&lt;script&gt;alert(1)&lt;/script&gt;&quot;&#39; onload=&quot;x&quot;"), 13u);
}

TEST(PlayReport, ShowsResultsThatHaveNothing) {
    EXPECT_EQ(unbalanced(markup(report_page({}))), "");
    EXPECT_NE(report_page({}).find("<h1>No tests</h1>"), std::string::npos);
    const std::string page = markup(report_page(std::vector{PlayResult{.passed = true}}));
    EXPECT_EQ(unbalanced(page), "");
    EXPECT_NE(page.find("<h1>The test passed</h1>"), std::string::npos);
    ExpectationResult bare{.kind = "picture", .passed = true};
    bare.picture = PictureEvidence{};
    EXPECT_EQ(unbalanced(markup(report_page(std::vector{PlayResult{.expectations = {bare}}}))), "");
}

TEST(PlayReport, IsWrittenWholeIntoAFolderThatItMakes) {
    const TempFolder folder;
    const std::vector<PlayResult> results{{.file = "a.play.json", .passed = true}};
    write_report(folder / "new/report", results);
    EXPECT_EQ(folder.listing(), (std::set<std::string>{"new", "new/report", "new/report/index.html"}));
    EXPECT_EQ(file_text(folder / "new/report/index.html"), report_page(results));
    folder.write("file", "x");
    EXPECT_THROW(write_report(folder / "file", results), Error);
    std::filesystem::create_directories(folder / "taken/index.html");
    EXPECT_THROW(write_report(folder / "taken", results), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "taken/index.html"));
}

} // namespace
} // namespace hachure::test
