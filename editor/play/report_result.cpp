#include <hachure/editor/play/report_curve.h>
#include <hachure/editor/play/report_expectation.h>
#include <hachure/editor/play/report_html.h>
#include <hachure/editor/play/report_result.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace hachure::play {
namespace {

std::string section(std::string_view title, const std::string& inside) {
    return inside.empty() ? "" : fmt::format("<section><h3>{}</h3>{}</section>\n", title, inside);
}

std::string fact(std::string_view name, const std::string& value) {
    return value.empty() ? "" : fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, value);
}

std::string facts(const PlayResult& result) {
    const std::string size = result.width > 0 ? fmt::format("{} × {}", result.width, result.height) : "";
    return "<dl class=\"facts\">" + fact("file", html_path(result.file)) +
           fact("frames", fmt::format("{}", result.frames)) + fact("size", size) +
           fact("renderer", html_text(result.renderer)) + "</dl>\n";
}

std::string expectations(const PlayResult& result) {
    std::vector<const ExpectationResult*> ordered;
    for (const ExpectationResult& expectation : result.expectations) ordered.push_back(&expectation);
    std::ranges::stable_sort(ordered, {}, &ExpectationResult::passed);
    std::string html;
    for (const ExpectationResult* expectation : ordered) html += html_expectation(*expectation);
    return html;
}

/// Whether an expectation failed in [first, end): by its curves where they tell the frames, else anywhere it looks.
bool fails_in(const ExpectationResult& expectation, std::int64_t first, std::int64_t end) {
    std::vector<std::int64_t> frames;
    for (const Curve& curve : expectation.curves) std::ranges::copy(frames_outside(curve), std::back_inserter(frames));
    if (expectation.passed) return false;
    if (frames.empty()) return expectation.first_frame < end && expectation.last_frame >= first;
    return std::ranges::any_of(frames, [&](std::int64_t frame) { return first <= frame && frame < end; });
}

/// A picture stands for the frames up to the next one.
std::string film_strip(const PlayResult& result) {
    std::string html = "<div class=\"strip\" tabindex=\"0\" role=\"group\" aria-label=\"film strip\">";
    for (std::size_t i = 0; i < result.strip.size(); ++i) {
        const StripFrame& frame = result.strip[i];
        const std::int64_t end = i + 1 < result.strip.size() ? result.strip[i + 1].frame : result.frames;
        const bool wrong = std::ranges::any_of(result.expectations, [&](const ExpectationResult& expectation) {
            return fails_in(expectation, frame.frame, end);
        });
        html += fmt::format("<figure{}>{}<figcaption>{}</figcaption></figure>", wrong ? " class=\"wrong\"" : "",
                            html_picture(frame.picture, fmt::format("frame {}", frame.frame)), frame.frame);
    }
    return result.strip.empty() ? "" : html + "</div>";
}

std::string milliseconds(double sum) { return sum > 0.0 ? fmt::format("{:.2f}", sum) : "–"; }

/// The frames in which the pass ran, was reused and was culled, as lengths.
std::string pass_bar(const PassSummary& pass) {
    std::string html;
    for (const auto& [name, frames] :
         {std::pair("run", pass.run), std::pair("reused", pass.reused), std::pair("culled", pass.culled)})
        if (frames > 0) html += fmt::format("<i class=\"{}\" style=\"flex-grow:{}\"></i>", name, frames);
    return "<span class=\"bar\" aria-hidden=\"true\">" + html + "</span>";
}

std::string pass_row(const PassSummary& pass) {
    return fmt::format("<tr><th scope=\"row\">{}</th><td class=\"share\">{}</td><td>{}</td><td>{}</td><td>{}</td>"
                       "<td>{}</td><td>{}</td></tr>",
                       html_text(pass.name), pass_bar(pass), pass.run, pass.reused, pass.culled,
                       milliseconds(pass.cpu_ms), milliseconds(pass.gpu_ms));
}

std::string pass_table(const PlayResult& result) {
    if (result.passes.empty()) return "";
    std::string html = "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"passes\"><table><thead><tr>"
                       "<th scope=\"col\">pass</th><th scope=\"col\" class=\"share\">frames</th>"
                       "<th scope=\"col\"><i class=\"run\"></i>run</th><th scope=\"col\"><i class=\"reused\"></i>reused"
                       "</th><th scope=\"col\"><i class=\"culled\"></i>culled</th>"
                       "<th scope=\"col\">CPU ms</th><th scope=\"col\">GPU ms</th></tr></thead><tbody>";
    for (const PassSummary& pass : result.passes) html += pass_row(pass);
    return html + "</tbody></table></div>";
}

std::string replay(const PlayResult& result) {
    if (result.replay.empty()) return "";
    return "<div class=\"replay\"><code>" + html_text(result.replay) +
           "</code><button type=\"button\" class=\"copy\">Copy</button></div>";
}

std::string log(const PlayResult& result) {
    if (result.log.empty()) return "";
    std::string lines;
    for (const std::string& line : result.log) lines += html_text(line) + "\n";
    return fmt::format("<details class=\"log\"{}><summary>Log <small>{} {}</small></summary><pre tabindex=\"0\">{}"
                       "</pre></details>\n",
                       result.error.empty() ? "" : " open", result.log.size(),
                       result.log.size() == 1 ? "line" : "lines", lines);
}

std::string score(const PlayResult& result) {
    const auto passed = std::ranges::count_if(result.expectations, &ExpectationResult::passed);
    if (result.expectations.empty()) return "";
    return fmt::format("<span class=\"score\">{}/{}</span>", passed, result.expectations.size());
}

std::string heading(const PlayResult& result) {
    return fmt::format("<summary><span class=\"mark\" role=\"img\" aria-label=\"{}\"></span><h2>{}</h2>"
                       "<span class=\"doc\">{}</span>{}{}<span class=\"time\">{}</span></summary>\n",
                       result.passed ? "passed" : "failed", html_text(test_name(result)), html_text(result.doc),
                       has_renewed(result) ? "<span class=\"chip\">renewed</span>" : "", score(result),
                       html_seconds(result.seconds));
}

} // namespace

std::string test_name(const PlayResult& result) {
    constexpr std::string_view extension = ".play.json";
    std::string name = result.file.filename().string();
    if (name.size() > extension.size() && name.ends_with(extension)) name.resize(name.size() - extension.size());
    return name;
}

bool has_renewed(const PlayResult& result) {
    return std::ranges::any_of(result.expectations, &ExpectationResult::renewed);
}

std::string html_result(const PlayResult& result, std::size_t index) {
    const char* status = result.passed ? "passed" : "failed";
    std::string html = fmt::format("<details class=\"test {0}\" id=\"test-{1}\" data-status=\"{0}{2}\"{3}>\n", status,
                                   index + 1, has_renewed(result) ? " renewed" : "", result.passed ? "" : " open");
    html += heading(result) + "<div class=\"body\">\n";
    if (!result.error.empty()) html += "<p class=\"error\">" + html_text(result.error) + "</p>\n";
    html += facts(result) + replay(result);
    html += section("Expectations", expectations(result));
    html += section("Film strip", film_strip(result));
    std::string curves;
    for (const Curve& curve : result.curves) curves += html_curve(curve);
    html += section("Over time", curves.empty() ? "" : "<div class=\"curves\">" + curves + "</div>");
    html += section("Passes", pass_table(result));
    return html + log(result) + "</div></details>\n";
}

} // namespace hachure::play
