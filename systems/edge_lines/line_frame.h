#pragma once

#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/systems/edge_lines/edge_line_batch.h>
#include <hachure/systems/edge_lines/image_lines.h>
#include <hachure/systems/edge_lines/line_groups.h>

#include <vector>

namespace hachure {

/// What this frame draws of lines. A resource.
struct EdgeLineFrame {
    EdgeLineBatches batches;
    std::vector<Entity> drawn; ///< with lines of the mesh, in the order of the DrawList
    gpu::Rect rect;            ///< where lines can be
    LineGroups picture;        ///< what the picture shows
    ImageLines image;          ///< lines from the picture, below the others
    LineGroups hidden;         ///< the AOV `hidden_lines`, where it is wanted
    bool probes = false;       ///< some line's visibility is asked of a depth buffer
};

} // namespace hachure
