#include <hachure/systems/picture/picture_place.h>

#include <algorithm>
#include <cmath>

namespace hachure {

gpu::Rect picture_place(PictureFit fit, int width, int height, int view_width, int view_height) {
    if (fit == PictureFit::stretch) return {0, 0, view_width, view_height};
    const double across = double(view_width) / width, up = double(view_height) / height;
    const double scale = fit == PictureFit::contain ? std::min(across, up) : std::max(across, up);
    const int w = std::max(1, static_cast<int>(std::lround(width * scale)));
    const int h = std::max(1, static_cast<int>(std::lround(height * scale)));
    // Half of what is left, rounded down on either side of zero.
    const auto middle = [](int left) { return left >= 0 ? left / 2 : -((1 - left) / 2); };
    return {middle(view_width - w), middle(view_height - h), w, h};
}

gpu::Rect cut_to_view(const gpu::Rect& place, int view_width, int view_height) {
    const int left = std::max(place.x, 0), bottom = std::max(place.y, 0);
    const int right = std::min(place.x + place.width, view_width), top = std::min(place.y + place.height, view_height);
    return right > left && top > bottom ? gpu::Rect{left, bottom, right - left, top - bottom} : gpu::Rect{};
}

} // namespace hachure
