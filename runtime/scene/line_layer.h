#pragma once

#include <hachure/runtime/gpu/framebuffer.h>

namespace hachure {

/// Where this frame's texture `line_layer` holds lines. A resource; whoever draws lines sets it, systems/compose lays
/// only this part over the picture.
struct LineLayer {
    gpu::Rect rect;
};

} // namespace hachure
