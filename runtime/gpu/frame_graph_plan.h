#pragma once

#include <hachure/runtime/gpu/frame_graph_declaration.h>
#include <hachure/runtime/gpu/frame_graph_kept.h>

namespace hachure::gpu::detail {

/// Decides for every pass whether it is culled, reused or run, and for every texture what it holds at the frame's end,
/// whether that stays, and until when it is used. Throws FrameGraphError when a required version is written over.
void plan_frame(FrameDeclaration& frame, const KeptResults& kept);

} // namespace hachure::gpu::detail
