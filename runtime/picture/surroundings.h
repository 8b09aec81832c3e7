#pragma once

#include <hachure/runtime/assets/image.h>

#include <array>
#include <vector>

namespace hachure::picture {

/// What a frame shows around each pixel: what may stand at the pixel in the next frame if things moved by no more than
/// `reach` pixels. Pictures are blurred first (5x5 binomial, standard deviation 1 px), so that a line looks the same
/// wherever it lies between pixels, and the range is widened by a quarter at both ends for what is left of that.
class Surroundings {
public:
    /// Of a picture of 3 or more channels, at least 1x1.
    Surroundings(const assets::Image& picture, int reach);

    /// The blurred channel (0 to 2), [0, 1].
    [[nodiscard]] float value(int c, std::size_t pixel) const { return at(values_, c, pixel); }

    /// How far a value of that channel is from all that stands around the pixel; 0 when it is among it.
    [[nodiscard]] float distance(int c, std::size_t pixel, float value) const {
        const float below = at(low_, c, pixel) - value, above = value - at(high_, c, pixel);
        return below > 0.0f ? below : above > 0.0f ? above : 0.0f;
    }

private:
    using Planes = std::array<std::vector<float>, 3>;
    static float at(const Planes& planes, int c, std::size_t pixel) {
        return planes[static_cast<std::size_t>(c)][pixel];
    }

    Planes values_, low_, high_;
};

} // namespace hachure::picture
