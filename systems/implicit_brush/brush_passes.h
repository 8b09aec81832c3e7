#pragma once

#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/gpu/frame_graph.h>
#include <hachure/systems/implicit_brush/brush_noise.h>
#include <hachure/systems/implicit_brush/feature_passes.h>
#include <hachure/systems/implicit_brush/stamp_convolver.h>
#include <hachure/systems/implicit_brush/stamp_job.h>
#include <hachure/systems/implicit_brush/tip_textures.h>

#include <cstddef>
#include <span>
#include <vector>

namespace hachure {

/// Declares the passes of brushes: those that find features and make noise, `brush_stamps_N`, which decides what the
/// N-th brush stamps where, and `brush_N`, which paints it onto `line_layer`; and the maps that someone asks for.
class BrushPasses {
public:
    void declare(World& world);

private:
    /// What a brush stamps (StampJob).
    struct Stamps {
        gpu::TextureHandle place, ink;
    };

    Stamps declare_stamps(World& world, std::size_t draw, const FeatureTextures& feature, gpu::TextureHandle noise);
    void declare_ink(World& world, std::size_t draw, const Stamps& stamps, gpu::TextureHandle noise);

    FeaturePasses features_;
    BrushNoisePasses noises_;
    StampMaker stamps_;
    StampConvolver convolver_;
    TipTextures tips_;
};

} // namespace hachure
