#pragma once

#include <hachure/editor/frame_plan.h>

#include <cstdint>
#include <functional>
#include <span>

namespace hachure {

/// A moment on the way through the frames of a run.
struct FrameStep {
    std::int64_t number = 0; ///< of the frame; that of the next one for moments between frames
    double seconds = 0.0;    ///< what it shows; ascends
    bool drawn = false;      ///< else it is only lived through: Renderer::skip_frame
};

/// What drawn frames need to come before them.
enum class FrameHistory : std::uint8_t {
    none,   ///< each moment is what it is, whatever came before
    motion, ///< the frame before: velocities are differences
    whole,  ///< every frame from 0 on: state builds up (see `needs_stepping`)
};

/// Calls `take` for each moment that the run has to pass, in order of time. `wanted` are the frames of the plan to
/// draw, ascending; which ones they are does not change what any of them shows.
void walk_frames(const FramePlan& plan, std::span<const std::int64_t> wanted, FrameHistory history,
                 const std::function<void(const FrameStep&)>& take);

} // namespace hachure
