#pragma once

#include <hachure/components/feature_image.h>
#include <hachure/components/implicit_brush.h>
#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/systems/implicit_brush/brush_noise_key.h>
#include <hachure/systems/implicit_brush/brush_style.h>
#include <hachure/systems/implicit_brush/feature_passes.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace hachure {

/// One brush at work in a view: those of several entities, where they are alike.
struct BrushDraw {
    ImplicitBrush brush;
    BrushStyle style;
    std::size_t feature = 0;          ///< into BrushFrame::features
    std::optional<std::size_t> noise; ///< into BrushFrame::noises
    bool everywhere = false;          ///< it paints on all that is seen: no pixel needs to ask whose it is
    float radius = 0.0f;              ///< of its largest stamp, px
    gpu::Rect stamps;                 ///< where pixels can count
    gpu::Rect rect;                   ///< where it can leave ink
};

/// What this frame paints with brushes. A resource.
struct BrushFrame {
    FeatureImage quality;                 ///< resolved
    std::vector<FeatureRequest> features; ///< each key once
    std::vector<BrushNoiseKey> noises;    ///< each once
    std::vector<BrushDraw> draws;         ///< in the order in which they are painted
    std::vector<std::uint32_t> owners;    ///< by object id, `owner_words` each: bit i for `draws[i]`
    std::size_t owner_words = 1;          ///< of an object id
    gpu::Rect sought;                     ///< where some brush wants to know of features
    gpu::Rect rect;                       ///< around all ink

    [[nodiscard]] bool owns(std::size_t draw, std::uint32_t object_id) const {
        const std::size_t at = object_id * owner_words + draw / 32;
        return at < owners.size() && (owners[at] >> (draw % 32) & 1u) != 0;
    }
};

} // namespace hachure
