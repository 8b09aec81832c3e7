#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/systems/implicit_brush/feature_passes.h>

namespace hachure {

/// Adds `feature_height`, `feature_direction`, `feature_singularity`, `profile_distance`, `profile_height` and
/// `profile_curvature` to the AOVs that are known.
void know_feature_aovs(FrameRequests& requests);

/// Whether one of them is wanted: then whoever declares features asks for all of them, in the whole view.
[[nodiscard]] bool wants_feature_aovs(const FrameRequests& requests);

/// Declares the passes that make those that are wanted, of one feature. `rect` is where its textures hold something;
/// elsewhere there is no feature and no line.
void declare_feature_aovs(World& world, const FeatureTextures& textures, const gpu::Rect& rect);

} // namespace hachure
