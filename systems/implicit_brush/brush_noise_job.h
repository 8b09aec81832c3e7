#pragma once

#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/systems/implicit_brush/brush_noise_key.h>

#include <array>
#include <cstdint>

namespace hachure {

struct RenderContext;

/// Fills a texture with a field of noise: four channels, independent of each other, each about evenly distributed over
/// [-1, 1] at every pixel, also where octaves blend. Between two changes of a channel's sign along a line lies, in the
/// mean, one grain. Nothing in it depends on earlier frames or on the order of drawing: random numbers are hashes of
/// place, octave and seed. Textures are ids of the frame graph's back end, all of one size; 0 for none.
struct BrushNoiseJob {
    BrushNoiseKey key;
    std::uint32_t places = 0;             ///< SurfacePlaces; needed by solid grain, and by grains in metres
    std::uint32_t objects = 0;            ///< the same
    std::array<std::uint32_t, 2> pasts{}; ///< NoisePhases; needed by advected grain
    float picture_height = 1; ///< pixels: without flatness, grains have their size where an object is as high as that
    std::uint32_t to = 0;     ///< of four float channels
    gpu::Rect rect;           ///< the part of `to` that is made

    void run(RenderContext& render) const;
};

} // namespace hachure
