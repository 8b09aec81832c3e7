#include <hachure/editor/play/report_curve.h>
#include <hachure/editor/play/report_html.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace hachure::play {
namespace {

constexpr double width = 1000.0, height = 200.0; // of the drawing, which is stretched to its place
constexpr int value_intervals = 4, frame_intervals = 6;

bool outside(const Curve& curve, double value) {
    if (!curve.at_least && !curve.at_most) return false;
    return !std::isfinite(value) || (curve.at_least && value < *curve.at_least) ||
           (curve.at_most && value > *curve.at_most);
}

/// 1, 2 or 5 times a power of ten, such that about `intervals` of them cover `range`.
double nice_step(double range, int intervals) {
    const double rough = range / intervals;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough * 0.999) return factor * power;
    return 10.0 * power;
}

/// What the vertical axis shows.
struct Scale {
    double low = 0.0, high = 1.0, step = 0.25;

    /// Percent from the top.
    [[nodiscard]] double at(double value) const { return 100.0 * std::clamp((high - value) / (high - low), 0.0, 1.0); }
};

Scale scale_of(const Curve& curve) {
    std::vector<double> shown;
    for (const double value : curve.values)
        if (std::abs(value) < 1e100) shown.push_back(value); // as axes can have, and no NaN
    for (const std::optional<double>& limit : {curve.at_least, curve.at_most})
        if (limit && std::abs(*limit) < 1e100) shown.push_back(*limit);
    if (shown.empty()) return {};
    double low = *std::ranges::min_element(shown), high = *std::ranges::max_element(shown);
    if (low >= 0.0 && low < 0.6 * high) low = 0.0; // zero is near enough to be the ground
    const double least = std::max({std::abs(low), std::abs(high), 1e-9}) * 1e-6;
    if (high - low < least) {
        const double room = std::max(0.5 * std::abs(high), 0.5);
        low -= room;
        high += room;
    }
    const double step = nice_step(high - low, value_intervals);
    const double room = 0.12 * (high - low); // to see what is not allowed
    return {curve.at_least ? low - room : std::floor(low / step + 1e-9) * step,
            curve.at_most ? high + room : std::ceil(high / step - 1e-9) * step, step};
}

/// Percent from the left of value number `i`.
double across(const Curve& curve, std::size_t i) {
    if (curve.values.size() < 2) return 50.0;
    return 100.0 * static_cast<double>(i) / static_cast<double>(curve.values.size() - 1);
}

/// Lines between neighbours that are numbers; a number alone is a dot.
std::string line_path(const Curve& curve, const Scale& scale) {
    std::string path;
    bool drawing = false;
    for (std::size_t i = 0; i < curve.values.size(); ++i) {
        const bool number = std::isfinite(curve.values[i]);
        if (number)
            path += fmt::format("{}{:.2f} {:.2f}", drawing ? 'L' : 'M', across(curve, i) * width / 100.0,
                                scale.at(curve.values[i]) * height / 100.0);
        const bool alone = number && !drawing && (i + 1 == curve.values.size() || !std::isfinite(curve.values[i + 1]));
        if (alone) path += "h.01";
        drawing = number;
    }
    return path;
}

/// The frames that are outside, each shaded half way to its neighbours.
std::string bands(const Curve& curve) {
    std::string html;
    const double half = curve.values.size() < 2 ? 50.0 : 50.0 / static_cast<double>(curve.values.size() - 1);
    for (std::size_t i = 0; i < curve.values.size(); ++i) {
        if (!outside(curve, curve.values[i])) continue;
        const std::size_t first = i;
        while (i + 1 < curve.values.size() && outside(curve, curve.values[i + 1])) ++i;
        const double left = std::max(across(curve, first) - half, 0.0);
        const double right = std::min(across(curve, i) + half, 100.0);
        html += fmt::format("<i class=\"band\" style=\"left:{:.3f}%;width:{:.3f}%\"></i>", left, right - left);
    }
    return html;
}

std::string limits(const Curve& curve, const Scale& scale) {
    std::string html;
    if (curve.at_most)
        html += fmt::format("<i class=\"zone\" style=\"top:0;height:{0:.3f}%\"></i>"
                            "<i class=\"limit\" style=\"top:{0:.3f}%\"><b>at most {1}</b></i>",
                            scale.at(*curve.at_most), html_number(*curve.at_most));
    if (curve.at_least)
        html += fmt::format("<i class=\"zone\" style=\"top:{0:.3f}%;bottom:0\"></i>"
                            "<i class=\"limit least\" style=\"top:{0:.3f}%\"><b>at least {1}</b></i>",
                            scale.at(*curve.at_least), html_number(*curve.at_least));
    return html;
}

std::string value_axis(const Scale& scale) {
    std::string html;
    const double last = std::floor(scale.high / scale.step + 1e-9);
    for (double i = std::ceil(scale.low / scale.step - 1e-9); i <= last; ++i)
        html += fmt::format("<i class=\"grid\" style=\"top:{:.3f}%\"><b>{}</b></i>", scale.at(i * scale.step),
                            html_number(i == 0.0 ? 0.0 : i * scale.step)); // no "-0"
    return html;
}

std::string frame_axis(const Curve& curve) {
    if (curve.values.size() < 2) return fmt::format("<b style=\"left:50%\">{}</b>", curve.first_frame);
    std::string html;
    const auto count = static_cast<std::int64_t>(curve.values.size());
    const auto step =
        std::max<std::int64_t>(1, std::llround(nice_step(static_cast<double>(count - 1), frame_intervals)));
    for (std::int64_t frame = (curve.first_frame + step - 1) / step * step; frame < curve.first_frame + count;
         frame += step)
        html += fmt::format("<b style=\"left:{:.3f}%\">{}</b>",
                            across(curve, static_cast<std::size_t>(frame - curve.first_frame)), frame);
    return html;
}

/// For the cursor: exact enough to be read.
std::string values_text(const Curve& curve) {
    std::string text;
    for (const double value : curve.values)
        text += (text.empty() ? "" : " ") + (std::isfinite(value) ? fmt::format("{:.6g}", value) : "x");
    return text;
}

} // namespace

std::vector<std::int64_t> frames_outside(const Curve& curve) {
    std::vector<std::int64_t> frames;
    for (std::size_t i = 0; i < curve.values.size(); ++i)
        if (outside(curve, curve.values[i])) frames.push_back(curve.first_frame + static_cast<std::int64_t>(i));
    return frames;
}

std::string html_curve(const Curve& curve) {
    const Scale scale = scale_of(curve);
    const std::size_t wrong = frames_outside(curve).size();
    const std::string unit = curve.unit.empty() ? "" : " <small>" + html_text(curve.unit) + "</small>";
    const std::string verdict =
        wrong == 0 ? "" : fmt::format("<span class=\"wrong\">{} of {} outside</span>", wrong, curve.values.size());
    std::string html = fmt::format(
        "<figure class=\"curve\" data-first=\"{}\" data-low=\"{:.9g}\" data-high=\"{:.9g}\" data-unit=\"{}\" "
        "data-values=\"{}\"><figcaption><span class=\"what\">{}{}</span>{}<output></output></figcaption>",
        curve.first_frame, scale.low, scale.high, html_text(curve.unit), values_text(curve), html_text(curve.name),
        unit, verdict);
    html += fmt::format("<div class=\"plot\" tabindex=\"0\" role=\"img\" aria-label=\"{} over frames {} to {}\">",
                        html_text(curve.name), curve.first_frame,
                        curve.first_frame + std::max<std::int64_t>(std::ssize(curve.values), 1) - 1);
    html += value_axis(scale) + limits(curve, scale) + bands(curve);
    html += fmt::format("<svg viewBox=\"0 0 {} {}\" preserveAspectRatio=\"none\" aria-hidden=\"true\"><path d=\"{}\" "
                        "vector-effect=\"non-scaling-stroke\"/></svg>",
                        width, height, line_path(curve, scale));
    html += "<i class=\"cursor\" hidden></i><i class=\"point\" hidden></i></div>";
    return html + "<div class=\"frames\">" + frame_axis(curve) + "</div></figure>\n";
}

} // namespace hachure::play
