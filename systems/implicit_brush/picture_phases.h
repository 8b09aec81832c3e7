#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/systems/implicit_brush/noise_phases.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace hachure {

/// Noise that what moves in pictures carries along, as NoisePhases does it for surfaces; motion is that of optical
/// flow. Its time is that of the video: noise is made in frames whose number is a multiple of half the lifetime, so
/// that a frame's noise follows from the video alone. Where a video is entered in the middle, the frames since then, at
/// most a lifetime, are gone through first.
class PicturePhases {
public:
    /// Which lifetimes are going to be drawn: frames of a video, even and above 0.
    void want(std::vector<int> lifetimes) { lifetimes_ = std::move(lifetimes); }

    /// From within a pass: all pictures of the world's PictureList, onto what `textures` hold, in `rect`. Throws Error
    /// for a frame that can't be decoded.
    void draw(World& world, RenderContext& render, int lifetime, const PhaseTextures& textures, const gpu::Rect& rect);

private:
    /// Where each pixel was in the frame in which noise was made.
    using Maps = std::array<std::uint32_t, 2>;

    /// A picture that is followed. Textures are of the size of what is seen of it.
    struct Track {
        std::string file;
        gpu::Rect place, rect;
        int frame = -1;                    ///< that the maps are those of; -1 for none
        std::array<std::uint32_t, 2> tone; ///< of this frame and of the one before
        std::uint32_t flow = 0, spare = 0;
        std::map<int, Maps> maps; ///< by lifetime
        std::vector<std::uint32_t> scratch;
    };

    Track& track_of(const World& world, RenderContext& render, const PictureItem& item);
    static void make(RenderContext& render, Track& track, const std::vector<int>& lifetimes);
    static void forget(RenderContext& render, const Track& track);
    static void follow(World& world, RenderContext& render, const PictureItem& item, Track& track);

    static void draw_map(RenderContext& render, const PictureItem& item, const Maps& maps, int lifetime,
                         const PhaseTextures& textures, const gpu::Rect& rect);

    std::vector<int> lifetimes_;
    std::map<Entity, Track> tracks_;
};

/// The frame in which noise of a phase, 0 or 1, was made that lives in `frame`.
[[nodiscard]] int phase_start(int frame, int lifetime, int phase);

} // namespace hachure
