#pragma once

#include <hachure/editor/render_outputs.h>
#include <hachure/runtime/app/progress.h>
#include <hachure/runtime/scene/view.h>

#include <cstdint>
#include <vector>

namespace hachure {

/// The frames of a numbered sequence that are still to be drawn, ascending. A frame is there when all of its files are:
/// pictures and buffers that can be read to their end and have the canvas's size and the channels that they should.
/// What they show is not looked at.
[[nodiscard]] std::vector<std::int64_t> missing_frames(App& app, const RenderOutputs& outputs, const FramePlan& plan,
                                                       Canvas canvas, Progress& progress);

} // namespace hachure
