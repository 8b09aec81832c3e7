#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/framebuffer.h>

#include <span>

namespace hachure {

/// What a brush stamps, and where.
struct BrushInk {
    gpu::TextureHandle ink; ///< colour times weight; weight
    gpu::Rect rect;         ///< outside it the texture holds anything
};

/// Publishes `brush_weight`, the greatest weight of all brushes, where it is wanted.
void declare_weight_map(World& world, std::span<const BrushInk> inks);

} // namespace hachure
