#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/picture/surroundings.h>

#include <deque>
#include <optional>
#include <vector>

namespace hachure::picture {

/// How much a sequence of frames flickers, [0, 1]: 0 for what stands still, for what fades, and for what moves
/// steadily. Percentiles and mean are over the pixels that are on a line in some frame or ever changed by more than
/// 1/255.
struct Flicker {
    double mean = 0.0;
    double p99 = 0.0;
    double largest = 0.0;
};

/// Measures frame by frame. Nobody publishes a measure for line drawings, so this is ours: what flickers is there for
/// one frame only, or is missing for one frame only. For a pixel p of three frames a, b, c in a row, with S the
/// surroundings of p in a frame (all colours within `reach` pixels, blurred and widened as Surroundings says) and d(v,
/// S) how far a colour v is from all of them:
///
///     flash = min(d(b(p), S_a), d(b(p), S_c))    b shows what was not near before and is not near after
///     gap   = min(d(a(p), S_b), d(c(p), S_b))    a and c show what is nowhere near in b
///
/// and the flicker of p is the mean of max(flash, gap) over the frames, the largest of the channels. Motion of up to
/// `reach` pixels a frame is explained by the surroundings, a fade by one of its sides. A black line of 1 px on white
/// that blinks every other frame measures .37 on its pixels, one of 3 px or more .87.
class FlickerMeter {
public:
    explicit FlickerMeter(int reach = 2) : reach_(reach) {}

    /// Takes the next frame: u8 or f32 in [0, 1], 3 or more channels, finite, of the others' size. From the third frame
    /// on, the p99 of the frame before this one, over the pixels that are on a line or changed so far.
    std::optional<double> add(const assets::Image& frame);

    /// Of all frames so far.
    [[nodiscard]] Flicker result() const;

private:
    void mark_active(const assets::Image& frame);

    int reach_;
    std::optional<assets::Image> last_;
    std::deque<Surroundings> frames_; ///< the last three
    std::vector<double> sums_;        ///< per pixel
    std::vector<bool> active_;
    int triples_ = 0;
};

} // namespace hachure::picture
