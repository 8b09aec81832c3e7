#include <hachure/systems/abstracted_lines/tone_line_style.h>

#include <algorithm>

namespace hachure {
namespace {

float on_screen(float width, const AbstractedLines& lines, const View& view) {
    const float pixels = lines.width_unit == ToneLineUnit::picture ? 0.001f * static_cast<float>(view.height) : 1.0f;
    return std::clamp(width * pixels, 0.0f, widest_line);
}

} // namespace

float full_width(const AbstractedLines& lines, const View& view) { return on_screen(lines.width, lines, view); }

float least_width(const AbstractedLines& lines, const View& view) {
    if (lines.width_by == LineAbstraction::constant) return full_width(lines, view);
    return on_screen(std::min(lines.min_width, lines.width), lines, view);
}

bool draws_anything(const AbstractedLines& lines) {
    return lines.width > 0.0f && (lines.dark || lines.highlight || lines.specular || lines.specular_dark);
}

ToneLineStyle line_style(const AbstractedLines& lines, const View& view) {
    const auto flag = [](bool is) { return is ? 1.0f : 0.0f; };
    return {.color = glm::vec4(lines.color, lines.beta),
            .highlight_color = glm::vec4(lines.highlight_color, lines.fade),
            .thresholds = {lines.dark_low, std::max(lines.dark_high, lines.dark_low + 1e-5f), lines.highlight_low,
                           std::max(lines.highlight_high, lines.highlight_low + 1e-5f)},
            .kinds = {flag(lines.dark), flag(lines.highlight), flag(lines.specular), flag(lines.specular_dark)},
            .line = {full_width(lines, view), flag(lines.method == ToneLineMethod::pixels), lines.counterchange, 1.0f}};
}

float least_curvature(const AbstractedLines& lines) {
    float least = 1.0f;
    if (lines.dark || lines.specular_dark) least = std::min(least, lines.dark_low);
    if (lines.highlight || lines.specular) least = std::min(least, lines.highlight_low);
    return least;
}

} // namespace hachure
