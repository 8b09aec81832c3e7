#pragma once

namespace hachure::gpu {

/// A rectangle of pixels; (x, y) is its lower left corner.
struct Rect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    friend bool operator==(const Rect&, const Rect&) = default;
};

} // namespace hachure::gpu
