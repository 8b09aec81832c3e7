#include <hachure/editor/play/play_report.h>
#include <hachure/editor/play/report_files.h>
#include <hachure/editor/play/report_html.h>
#include <hachure/editor/play/report_result.h>
#include <hachure/runtime/assets/atomic_file.h>
#include <hachure/runtime/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <vector>

namespace hachure::play {
namespace {

/// What the summary counts.
struct Totals {
    std::size_t all = 0, failed = 0, renewed = 0;
    double seconds = 0.0;
    std::int64_t frames = 0;
};

Totals totals_of(std::span<const PlayResult> results) {
    Totals totals;
    totals.all = results.size();
    for (const PlayResult& result : results) {
        totals.failed += !result.passed;
        totals.renewed += has_renewed(result);
        totals.seconds += result.seconds;
        totals.frames += result.frames;
    }
    return totals;
}

std::string tests_in_words(std::size_t count) { return fmt::format("{} {}", count, count == 1 ? "test" : "tests"); }

std::string outcome(const Totals& totals) {
    if (totals.all == 0) return "No tests";
    if (totals.failed == 0)
        return totals.all == 1 ? "The test passed" : "All " + tests_in_words(totals.all) + " passed";
    return fmt::format("{} of {} failed", totals.failed, tests_in_words(totals.all));
}

/// The rules of the page: nothing is fetched from anywhere.
constexpr std::string_view head = R"(<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<link rel="icon" href="data:,">
)";

std::string embedded(std::string_view extension, std::string_view element) {
    std::string html;
    for (const ReportFile& file : report_files())
        if (std::string_view(file.name).ends_with(extension))
            html += fmt::format("<{0}>\n{1}</{0}>\n", element, file.text);
    return html;
}

std::string filter(std::string_view value, std::string_view text, std::size_t count, bool chosen) {
    return fmt::format("<label><input type=\"radio\" name=\"filter\" value=\"{}\"{}><span>{} <b>{}</b></span></label>",
                       value, chosen ? " checked" : "", text, count);
}

std::string filters(const Totals& totals) {
    std::string html = "<div class=\"filters\" role=\"radiogroup\" aria-label=\"which tests are shown\">";
    html += filter("all", "All", totals.all, true) + filter("failed", "Failed", totals.failed, false) +
            filter("passed", "Passed", totals.all - totals.failed, false);
    if (totals.renewed > 0) html += filter("renewed", "Renewed", totals.renewed, false);
    return html + "</div>";
}

std::string header(const Totals& totals) {
    const std::size_t passed = totals.all - totals.failed;
    return fmt::format(
        "<header class=\"{}\"><p class=\"eyebrow\">Hachure playback tests</p><h1>{}</h1>"
        "<p class=\"sum\">{} frames in {}</p>"
        "<div class=\"bar\" aria-hidden=\"true\"><i class=\"failed\" style=\"flex-grow:{}\"></i>"
        "<i class=\"passed\" style=\"flex-grow:{}\"></i></div>"
        "<nav aria-label=\"tests\">{}<input type=\"search\" placeholder=\"Find a test\" aria-label=\"find a test\">"
        "<span class=\"spring\"></span><button type=\"button\" class=\"fold\">Open all</button>"
        "<button type=\"button\" class=\"theme\" title=\"light, dark, or as the system\">Theme: system</button></nav>"
        "</header>\n",
        totals.failed > 0 ? "failed" : "passed", outcome(totals), totals.frames, html_seconds(totals.seconds),
        totals.failed, passed, filters(totals));
}

constexpr std::string_view footer =
    "<p class=\"nothing\" hidden>No test matches.</p></main>\n"
    "<footer><span><kbd>j</kbd> <kbd>k</kbd> next and previous test</span>"
    "<span><kbd>enter</kbd> open and close</span><span><kbd>/</kbd> find</span><span><kbd>f</kbd> failed only</span>"
    "</footer>\n";

} // namespace

std::string report_page(std::span<const PlayResult> results) {
    const Totals totals = totals_of(results);
    std::vector<const PlayResult*> ordered;
    for (const PlayResult& result : results) ordered.push_back(&result);
    std::ranges::stable_sort(ordered, {}, &PlayResult::passed);
    std::string page = "<!doctype html>\n<html lang=\"en\">\n<head>\n";
    page += fmt::format("{}<title>{}</title>\n{}</head>\n<body>\n{}<main>\n", head, outcome(totals),
                        embedded(".css", "style"), header(totals));
    for (std::size_t i = 0; i < ordered.size(); ++i) page += html_result(*ordered[i], i);
    page += footer;
    return page + embedded(".js", "script") + "</body>\n</html>\n";
}

void write_report(const std::filesystem::path& folder, std::span<const PlayResult> results) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault) throw Error(folder.string(), "can't be made", fault.message());
    const std::string page = report_page(results);
    assets::write_file_atomically(folder / "index.html", std::as_bytes(std::span(page.data(), page.size())));
}

} // namespace hachure::play
