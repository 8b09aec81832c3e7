#include <hachure/runtime/assert.h>
#include <hachure/runtime/picture/flicker.h>
#include <hachure/runtime/picture/line_distance.h>
#include <hachure/runtime/picture/percentile.h>
#include <hachure/runtime/picture/pixels.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hachure::picture {
namespace {

double flicker_of(const Surroundings& a, const Surroundings& b, const Surroundings& c, std::size_t pixel) {
    float largest = 0.0f;
    for (int k = 0; k < 3; ++k) {
        const float now = b.value(k, pixel);
        const float flash = std::min(a.distance(k, pixel, now), c.distance(k, pixel, now));
        const float gap = std::min(b.distance(k, pixel, a.value(k, pixel)), b.distance(k, pixel, c.value(k, pixel)));
        largest = std::max({largest, flash, gap});
    }
    return static_cast<double>(largest);
}

} // namespace

void FlickerMeter::mark_active(const assets::Image& frame) {
    const std::vector<bool> lines = line_pixels(frame);
    for (std::size_t i = 0; i < active_.size(); ++i) {
        double changed = 0.0;
        for (int c = 0; c < 3 && last_; ++c)
            changed = std::max(changed, std::abs(channel(*last_, i, c) - channel(frame, i, c)));
        if (lines[i] || changed > 1.5 / 255.0) active_[i] = true;
    }
}

std::optional<double> FlickerMeter::add(const assets::Image& frame) {
    HACHURE_ASSERT(!last_ || same_size(*last_, frame), "frames have one size");
    sums_.resize(pixel_count(frame));
    active_.resize(pixel_count(frame));
    mark_active(frame);
    last_ = frame;
    frames_.emplace_back(frame, reach_);
    if (frames_.size() < 3) return std::nullopt;
    std::vector<double> now;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const double flicker = flicker_of(frames_[0], frames_[1], frames_[2], i);
        sums_[i] += flicker;
        if (active_[i]) now.push_back(flicker);
    }
    frames_.pop_front();
    ++triples_;
    return percentile(now, 0.99);
}

Flicker FlickerMeter::result() const {
    std::vector<double> values;
    for (std::size_t i = 0; i < sums_.size() && triples_ > 0; ++i)
        if (active_[i]) values.push_back(sums_[i] / triples_);
    if (values.empty()) return {};
    Flicker result;
    result.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    result.p99 = percentile(values, 0.99);
    result.largest = percentile(values, 1.0);
    return result;
}

} // namespace hachure::picture
