#pragma once

#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/scene/view.h>

#include <algorithm>

namespace hachure {

/// The smallest rectangle around two; one without an area counts for nothing.
[[nodiscard]] inline gpu::Rect united(const gpu::Rect& a, const gpu::Rect& b) {
    if (a.width <= 0 || a.height <= 0) return b;
    if (b.width <= 0 || b.height <= 0) return a;
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

/// What two rectangles share; without an area where they share nothing.
[[nodiscard]] inline gpu::Rect common(const gpu::Rect& a, const gpu::Rect& b) {
    const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    return {x, y, std::max(0, std::min(a.x + a.width, b.x + b.width) - x),
            std::max(0, std::min(a.y + a.height, b.y + b.height) - y)};
}

/// A rectangle with `margin` pixels more on every side, cut to the view.
[[nodiscard]] inline gpu::Rect grown(const gpu::Rect& rect, int margin, const View& view) {
    const int x = std::max(0, rect.x - margin), y = std::max(0, rect.y - margin);
    return {x, y, std::min(view.width, rect.x + rect.width + margin) - x,
            std::min(view.height, rect.y + rect.height + margin) - y};
}

} // namespace hachure
