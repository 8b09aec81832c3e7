#pragma once

#include <hachure/components/shade_strokes.h>
#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/rect.h>
#include <hachure/systems/shade_strokes/shade_chains.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// A surface in view whose shade is drawn. What it points to stands until the next frame.
struct ShadeSurface {
    Entity entity;
    std::size_t item = 0; ///< into DrawList::items
    ShadeStrokes style;
    const ShadeMesh* mesh = nullptr;
    ShadeChains* chains = nullptr;    ///< as the light of this frame needs them; who uploads forgets their changes
    std::span<const float> narrowing; ///< per vertex: how much of their amplitude strokes keep; or none: all of it
    std::uint64_t narrowing_version = 0;
    glm::mat4 world_from_mesh{1.0f};
};

/// What this frame draws of shade strokes. A resource.
struct ShadeFrame {
    std::vector<ShadeSurface> surfaces; ///< in the order of the DrawList
    float time = 0.0f;                  ///< seconds, for strokes that flicker
    gpu::Rect rect;                     ///< where strokes can be
    std::uint64_t key = 0;              ///< changes with all that strokes depend on, but not with the view
};

} // namespace hachure
