#pragma once

#include <hachure/components/feature_image.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph_handle.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/scene/fine_surface.h>
#include <hachure/systems/implicit_brush/slope_job.h>

#include <optional>
#include <string>
#include <vector>

namespace hachure {

/// What features of the surface are found in where there is none: a view of pictures alone, that bring no depth and
/// normals of another renderer, is looked at for its luminance.
[[nodiscard]] bool has_relief(const World& world);

/// Whether all slopes of surfaces are where the depth buffer is not empty: no picture brings its own.
[[nodiscard]] bool is_drawn_alone(const World& world);

/// Declares the passes that make slopes, each once in a frame however many features want them. Lives for one frame's
/// declarations.
class SlopePasses {
public:
    /// `rect`: where slopes are made.
    SlopePasses(World& world, const FeatureImage& quality, const gpu::Rect& rect);

    /// Slopes after so many steps of diffusion; not for breaks.
    gpu::TextureHandle slopes(SlopeKind kind, int steps);
    /// Breaks of which one of `half_break` px counts half.
    gpu::TextureHandle breaks(float half_break);

private:
    struct Made {
        SlopeKind kind;
        int steps;
        float half_break;
        gpu::TextureHandle texture;
    };

    gpu::TextureHandle made(SlopeKind kind, int steps, float half_break) const;
    gpu::TextureHandle declare_relief(SlopeKind kind, float half_break);
    gpu::TextureHandle declare_mean(SlopeKind kind, const std::string& name, gpu::TextureHandle fine);
    gpu::TextureHandle declare_tones();
    gpu::TextureHandle declare_tone_slopes();
    gpu::TextureHandle declare_diffusion(SlopeKind kind, int steps);

    World& world_;
    FeatureImage quality_; ///< resolved
    gpu::Rect rect_;
    int samples_; ///< of a pixel, to a side
    std::optional<FineSurface> fine_surface_;
    std::vector<Made> made_;
};

} // namespace hachure
