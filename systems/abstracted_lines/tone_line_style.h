#pragma once

#include <hachure/components/abstracted_lines.h>
#include <hachure/runtime/scene/view.h>

#include <glm/vec4.hpp>

namespace hachure {

/// What the line shader knows of an entity's AbstractedLines; as ToneLineStyle of
/// shaders/abstracted_lines/style.glsl.
struct ToneLineStyle {
    glm::vec4 color{0.0f};           ///< of dark lines; w: beta
    glm::vec4 highlight_color{0.0f}; ///< w: fade
    glm::vec4 thresholds{1.0f};      ///< c_l and c_u of dark lines, then of highlight lines
    glm::vec4 kinds{0.0f};           ///< 1 where dark, highlight, specular, specular dark lines are wanted
    glm::vec4 line{0.0f};            ///< width px; 1 where pixels draw; counterchange; 1 where there are lines at all

    friend bool operator==(const ToneLineStyle&, const ToneLineStyle&) = default;
};

/// Lines are searched for as if they were at least this wide, px: below, the picture's own pixels are larger than what
/// is looked for, bilinear samples move lines by .02 px, and noise moves them by pixels. Thinner lines are drawn
/// thinner.
inline constexpr float narrowest_search = 3.0f;
inline constexpr float widest_line = 64.0f; ///< px

/// Of a line where nothing makes it thinner, px.
[[nodiscard]] float full_width(const AbstractedLines& lines, const View& view);
/// The least that it can have, px.
[[nodiscard]] float least_width(const AbstractedLines& lines, const View& view);

[[nodiscard]] bool draws_anything(const AbstractedLines& lines);

[[nodiscard]] ToneLineStyle line_style(const AbstractedLines& lines, const View& view);

/// The least curvature from which any of its lines shows.
[[nodiscard]] float least_curvature(const AbstractedLines& lines);

} // namespace hachure
