#include <hachure/systems/implicit_brush/convolution_plan.h>
#include <hachure/systems/implicit_brush/convolve_job.h>
#include <hachure/systems/implicit_brush/tip_textures.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

/// Of one channel where the colour is known.
gpu::Format sums_format(const ConvolveJob& job) {
    const bool half = job.sums == gpu::Format::rgba16f;
    if (job.sums_opacity()) return half ? gpu::Format::r16f : gpu::Format::r32f;
    return half ? gpu::Format::rgba16f : gpu::Format::rgba32f;
}

} // namespace

bool ConvolveJob::sums_opacity() const { return same_color && !(bitmap != nullptr && bitmap->colored); }

bool ConvolveJob::may_use(BrushMethod which) const {
    const bool disks = footprint.tip == BrushTip::disk && footprint.round();
    if (which == BrushMethod::sums && !disks) return false;
    return method == which || method == BrushMethod::automatic || (method == BrushMethod::sums && !disks);
}

std::vector<gpu::TextureDesc> ConvolveJob::scratch(int width, int height) const {
    using gpu::Format;
    const gpu::TextureDesc marks{(width + 31) / 32, height, Format::r32ui};
    const gpu::TextureDesc tiles{tiles_of(width), tiles_of(height), Format::r32ui};
    std::vector<gpu::TextureDesc> made = {marks, marks, tiles, tiles};
    const bool splats = may_use(BrushMethod::splat), running = may_use(BrushMethod::sums);
    if (splats || running) made.push_back({width, height, Format::r32ui});
    if (splats) made.push_back({width, height, sums_format(*this)});
    if (running) made.push_back({(sums_opacity() ? 1 : 4) * width, height, Format::r32ui});
    return made;
}

int ConvolveJob::reach() const {
    const double shift = same_place ? std::hypot(double(same_place->x), double(same_place->y)) : double(largest_shift);
    return static_cast<int>(std::ceil(footprint.reach(double(largest_radius)) + shift));
}

gpu::Rect ConvolveJob::painted(int width, int height) const {
    if (stamps.width <= 0 || stamps.height <= 0) return {};
    const int far = reach();
    const int x0 = std::max(stamps.x - far, 0), y0 = std::max(stamps.y - far, 0);
    const int x1 = std::min(stamps.x + stamps.width + far, width),
              y1 = std::min(stamps.y + stamps.height + far, height);
    return {x0, y0, std::max(x1 - x0, 0), std::max(y1 - y0, 0)};
}

} // namespace hachure
