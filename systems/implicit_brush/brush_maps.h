#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/systems/implicit_brush/feature_passes.h>

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace hachure {

/// The maps of a feature, all of the first brush's.
inline constexpr std::array<std::string_view, 6> feature_maps{"feature_height",   "feature_direction",
                                                              "feature_singularity", "profile_distance",
                                                              "profile_height",   "profile_curvature"};

/// Tells the AOVs of brushes to those who can ask for them.
void add_brush_maps(std::vector<AovInfo>& known);

[[nodiscard]] bool wants_feature_maps(const FrameRequests& requests);

/// Publishes those of the feature's maps that are wanted.
void declare_feature_maps(World& world, const FeatureTextures& feature);

/// What a brush stamps, and where.
struct BrushInk {
    gpu::TextureHandle ink; ///< colour times weight; weight
    gpu::Rect rect;         ///< outside it the texture holds anything
};

/// Publishes `brush_weight`, the greatest weight of all brushes, where it is wanted.
void declare_weight_map(World& world, std::span<const BrushInk> inks);

} // namespace hachure
