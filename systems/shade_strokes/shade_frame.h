#pragma once

#include <hachure/components/shade_strokes.h>
#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/rect.h>
#include <hachure/systems/shade_strokes/shade_chains.h>
#include <hachure/systems/shade_strokes/shade_mesh.h>

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure {

/// A surface whose strokes are drawn in this frame.
struct ShadeSurface {
    Entity entity;
    std::size_t item = 0; ///< into the DrawList's items
    ShadeStrokes style;
    const ShadeMesh* mesh = nullptr;
    ShadeChains* chains = nullptr; ///< whoever uploads them forgets their changes
    glm::mat4 world_from_mesh{1.0f};
};

/// The shade strokes of this frame. A resource.
struct ShadeFrame {
    std::vector<ShadeSurface> surfaces;
    float time = 0.0f;     ///< seconds: when flickering strokes jump
    gpu::Rect rect;        ///< pixels that strokes can touch
    std::uint64_t key = 0; ///< of all that strokes depend on but the view
};

} // namespace hachure
