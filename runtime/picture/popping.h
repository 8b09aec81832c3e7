#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/picture/surroundings.h>

#include <optional>

namespace hachure::picture {

/// How much pixels change from a frame to the next, in 255ths of a channel.
struct Popping {
    double largest = 0.0; ///< of any pixel
    double p999 = 0.0;    ///< 99.9 % of the pixels change by no more
};

/// Measures a sequence of frames, frame by frame: what pops is a change that does not become smaller when the step that
/// causes it does.
class PoppingMeter {
public:
    /// With `reach` 0 every change of a pixel counts. With more, what motion of up to so many pixels explains does not:
    /// the change is how far the pixel's colour is from all colours that stood around it in the other frame, blurred as
    /// Surroundings says; the greater of both directions.
    explicit PoppingMeter(int reach = 0) : reach_(reach) {}

    /// The change since the frame before; nothing for the first one. Frames are u8 or f32 in [0, 1], of 3 or more
    /// channels, finite, and all of one size.
    std::optional<Popping> add(const assets::Image& frame);

private:
    int reach_;
    std::optional<assets::Image> last_;
    std::optional<Surroundings> last_surroundings_;
};

} // namespace hachure::picture
