#include <hachure/runtime/assert.h>
#include <hachure/runtime/picture/percentile.h>
#include <hachure/runtime/picture/pixels.h>
#include <hachure/runtime/picture/popping.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hachure::picture {
namespace {

double change(const assets::Image& a, const assets::Image& b, std::size_t pixel) {
    double largest = 0.0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(channel(a, pixel, c) - channel(b, pixel, c)));
    return largest;
}

double change(const Surroundings& a, const Surroundings& b, std::size_t pixel) {
    float largest = 0.0f;
    for (int c = 0; c < 3; ++c)
        largest = std::max({largest, a.distance(c, pixel, b.value(c, pixel)), b.distance(c, pixel, a.value(c, pixel))});
    return static_cast<double>(largest);
}

template <class Frame> Popping popping_between(const Frame& a, const Frame& b, std::size_t pixels) {
    std::vector<double> changes(pixels);
    for (std::size_t i = 0; i < pixels; ++i) changes[i] = 255.0 * change(a, b, i);
    Popping result;
    result.p999 = percentile(changes, 0.999);
    result.largest = percentile(changes, 1.0);
    return result;
}

} // namespace

std::optional<Popping> PoppingMeter::add(const assets::Image& frame) {
    HACHURE_ASSERT(!last_ || same_size(*last_, frame), "frames have one size");
    std::optional<Popping> result;
    if (reach_ > 0) {
        Surroundings surroundings(frame, reach_);
        if (last_surroundings_) result = popping_between(*last_surroundings_, surroundings, pixel_count(frame));
        last_surroundings_ = std::move(surroundings);
    } else if (last_) {
        result = popping_between(*last_, frame, pixel_count(frame));
    }
    last_ = frame;
    return result;
}

} // namespace hachure::picture
