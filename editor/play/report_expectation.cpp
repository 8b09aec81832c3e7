#include <hachure/editor/play/report_curve.h>
#include <hachure/editor/play/report_expectation.h>
#include <hachure/editor/play/report_html.h>

#include <fmt/format.h>

#include <iterator>
#include <string_view>

namespace hachure::play {
namespace {

std::string button(std::string_view attributes, std::string_view text) {
    return fmt::format("<button type=\"button\" {}>{}</button>", attributes, text);
}

std::string figure_row(std::string_view name, const std::string& value) {
    return fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", name, value);
}

std::string picture_figures(const PictureEvidence& picture) {
    return "<dl class=\"figures\">" + figure_row("largest difference", html_number(picture.max_difference) + " / 255") +
           figure_row("pixels that differ", html_number(100.0 * picture.differing_share) + " %") +
           figure_row("FLIP, 99th percentile", html_number(picture.flip_p99)) +
           figure_row("FLIP, worst", html_number(picture.flip_max)) +
           figure_row("distance of lines", html_number(picture.line_distance) + " px") + "</dl>";
}

/// Golden and actual picture on one another, parted by a line that is dragged, or side by side, or in turns.
std::string wiping(const PictureEvidence& picture) {
    return "<figure class=\"pair\"><div class=\"stage\">" + html_picture(picture.golden, "golden picture", "golden") +
           html_picture(picture.actual, "actual picture", "actual") +
           "<input type=\"range\" class=\"wipe\" min=\"0\" max=\"100\" step=\"0.5\" value=\"50\" "
           "aria-label=\"how much of the golden picture is shown, percent\"><i class=\"edge\"></i></div>"
           "<figcaption><span>golden</span><span>actual</span></figcaption></figure>";
}

std::string comparison(const PictureEvidence& picture) {
    return "<div class=\"compare\" data-mode=\"wipe\"><div class=\"tools\" role=\"group\" aria-label=\"how to "
           "compare\">" +
           button("data-mode=\"wipe\" aria-pressed=\"true\"", "Wipe") +
           button("data-mode=\"beside\" aria-pressed=\"false\"", "Side by side") +
           button("data-mode=\"blink\" aria-pressed=\"false\"", "Blink") +
           "<label class=\"check\"><input type=\"checkbox\" class=\"brighten\"> Brighten difference</label></div>"
           "<div class=\"pictures\">" +
           wiping(picture) + "<figure class=\"difference\"><div class=\"stage\">" +
           html_picture(picture.difference, "difference", "difference") +
           "</div><figcaption><span>difference</span></figcaption></figure></div>" + picture_figures(picture) +
           "</div>";
}

std::string film_tools() {
    return "<div class=\"tools\" role=\"group\" aria-label=\"play the frames\">" +
           button("class=\"back\" aria-label=\"previous frame\" title=\"previous frame (left)\"", "‹") +
           button("class=\"play\" aria-pressed=\"false\" title=\"play and pause (space)\"", "Play") +
           button("class=\"next\" aria-label=\"next frame\" title=\"next frame (right)\"", "›") +
           "<select class=\"speed\" aria-label=\"speed\"><option value=\"2\">2 a second</option>"
           "<option value=\"5\">5 a second</option><option value=\"12\" selected>12 a second</option>"
           "<option value=\"30\">30 a second</option><option value=\"60\">60 a second</option></select>"
           "<select class=\"layer\" aria-label=\"what is shown\"><option value=\"frame\" selected>frames</option>"
           "<option value=\"onion\">onion skin</option><option value=\"change\">what changes</option></select>"
           "<output></output></div>";
}

/// The frame that is shown at first: the first one whose value is not allowed.
std::size_t first_shown(const ExpectationResult& expectation) {
    for (const Curve& curve : expectation.curves)
        for (const std::int64_t frame : frames_outside(curve)) {
            const std::int64_t index = frame - expectation.first_frame;
            if (index >= 0 && index < std::ssize(expectation.frames)) return static_cast<std::size_t>(index);
        }
    return 0;
}

/// The frames lie on one another; the page's scripts show one of them, or it over the one before.
std::string film(const ExpectationResult& expectation) {
    const std::size_t shown = first_shown(expectation);
    std::string html = fmt::format("<div class=\"film\" data-first=\"{}\">{}<div class=\"stage\" tabindex=\"0\" "
                                   "role=\"group\" aria-label=\"frames\">",
                                   expectation.first_frame, film_tools());
    for (std::size_t i = 0; i < expectation.frames.size(); ++i) {
        const std::int64_t frame = expectation.first_frame + static_cast<std::int64_t>(i);
        html += html_picture(expectation.frames[i], fmt::format("frame {}", frame), i == shown ? "shown" : "");
    }
    return html + fmt::format("</div><input type=\"range\" class=\"seek\" min=\"0\" max=\"{}\" step=\"1\" value=\"{}\" "
                              "aria-label=\"frame\"></div>",
                              expectation.frames.size() - 1, shown);
}

std::string verdict(const ExpectationResult& expectation) {
    if (!expectation.passed) return "failed";
    return expectation.renewed ? "renewed" : "passed";
}

std::string heading(const ExpectationResult& expectation) {
    return fmt::format("<span class=\"mark\" role=\"img\" aria-label=\"{}\"></span><span class=\"what\">{}</span>"
                       "<span class=\"tags\">{}<span class=\"kind\">{}</span></span><span class=\"reason\">{}</span>",
                       verdict(expectation), html_text(expectation.what),
                       expectation.renewed ? "<span class=\"chip\">renewed</span>" : "", html_text(expectation.kind),
                       html_text(expectation.reason));
}

} // namespace

std::string html_expectation(const ExpectationResult& expectation) {
    std::string inside, curves;
    if (expectation.picture) inside += comparison(*expectation.picture);
    if (!expectation.frames.empty()) inside += film(expectation);
    for (const Curve& curve : expectation.curves) curves += html_curve(curve);
    if (!curves.empty()) inside += "<div class=\"values\">" + curves + "</div>";
    if (!expectation.pointer.empty())
        inside += "<p class=\"pointer\">in the play file: <code>" + html_text(expectation.pointer) + "</code></p>";
    return fmt::format(
        "<details class=\"expectation {}\"{}><summary>{}</summary><div class=\"inside\">{}</div></details>\n",
        verdict(expectation), expectation.passed ? "" : " open", heading(expectation), inside);
}

} // namespace hachure::play
