#pragma once

#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/systems/implicit_brush/feature_window.h>

#include <cstdint>

namespace hachure {

struct RenderContext;

/// Finds the line beside each pixel (sections 3.2.2 and 3.2.3).
struct FeatureProfileJob {
    int taps = 4; ///< k: samples on either side, >= 2
    int fits = 2; ///< >= 1
    /// Gamma_max, px: the singularity, summed over a way, that ends it. The paper's 1 misses generic umbilics.
    float most_singular = 0.5f;
    FeatureWindow window;
    float least_height = 0.0f;    ///< lower lines are not wanted
    float reach = 1e4f;           ///< px: nor are those farther from a pixel
    std::uint32_t data = 0;       ///< FeatureTextures::data
    std::uint32_t candidates = 0; ///< depth32f of the same size, to work in
    std::uint32_t to = 0;         ///< FeatureTextures::profile
    gpu::Rect valid;              ///< the part of `data` that holds features
    gpu::Rect rect;               ///< the part of `to` that is made; within `valid`

    void run(RenderContext& render) const;
};

} // namespace hachure
