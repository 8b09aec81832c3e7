#pragma once

#include <hachure/components/feature_image.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph_handle.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/systems/implicit_brush/feature_key.h>

#include <span>
#include <vector>

namespace hachure {

/// A feature that somebody wants, and how much of it.
struct FeatureRequest {
    FeatureKey key;
    float least_height = 0.0f; ///< lines of lower features are not wanted; what is not wanted is not looked for
    float reach = 1e4f;        ///< px: how far from a line pixels want to know of it; never more than the window

    friend bool operator==(const FeatureRequest&, const FeatureRequest&) = default;
};

/// What is known of a feature at every pixel. Both textures are of the view's size, rgba16f or rgba32f as FeatureImage
/// says; outside of the rectangle they were made for they hold anything.
struct FeatureTextures {
    /// Feature data (section 3.2.1): red is h, green and blue are cos and sin of twice theta's angle (0 where a pixel
    /// has no direction), so that what lies between pixels can be interpolated; alpha is gamma, the singularity, in [0,
    /// 1].
    gpu::TextureHandle data;
    /// Profiles (section 3.2.3): red and green lead from the pixel's centre to its line, px; blue is the height there;
    /// alpha the curvature: how far h falls over half a window beside the line by its second derivative there, >= 0.
    /// Where a pixel has no line: 1e4, 1e4, 0, 0. Never NaN or infinite.
    gpu::TextureHandle profile;
};

/// Asks the frame for the textures that these features are found in; call it in stage `material`.
void request_feature_sources(const DrawList& list, const PictureList& pictures,
                             std::span<const FeatureRequest> requests, FrameRequests& frame);

/// Declares the passes that find features: slopes, their diffusion, feature data, profiles. Features of the same source
/// and diffusion share slopes. Call declare() once a frame, in stage `render`, after surfaces and pictures.
class FeaturePasses {
public:
    /// The textures of each request, in their order; requests with equal keys share them. `rect` is where brushes need
    /// them, px of the view. An empty `requests` declares nothing.
    /// `quality` is a resolved one.
    std::vector<FeatureTextures> declare(World& world, const FeatureImage& quality,
                                         std::span<const FeatureRequest> requests, const gpu::Rect& rect);
};

} // namespace hachure
