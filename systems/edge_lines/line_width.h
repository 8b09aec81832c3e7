#pragma once

#include <hachure/components/edge_lines.h>
#include <hachure/runtime/scene/view.h>

namespace hachure {

/// How wide a line is where it is drawn: half_width pixels, divided by the clip w of the point when `by_distance`.
struct LineWidth {
    double half_width = 1.0;
    bool by_distance = false;
};

[[nodiscard]] inline LineWidth width_on_screen(const EdgeLines& lines, const View& view) {
    const double half = 0.5 * double(lines.width);
    switch (lines.width_unit) {
    case LineWidthUnit::pixels:
        break;
    case LineWidthUnit::picture:
        return {half * view.height / 1000.0, false};
    case LineWidthUnit::world:
        // The clip w of a point is its depth in a perspective view and 1 in an orthographic one.
        return {half / double(view.pixel_size), true};
    }
    return {half, false};
}

} // namespace hachure
