#pragma once

#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/framebuffer.h>

#include <cstdint>

namespace hachure {

/// The pass covers the rectangle, and is reused only where it is the same.
inline void depend_on_rect(gpu::PassBuilder& pass, const gpu::Rect& rect) {
    pass.depends_on(rect.x, rect.y, rect.width, rect.height);
    pass.covers(static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height));
}

} // namespace hachure
