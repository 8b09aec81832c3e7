#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/framebuffer.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <string_view>
#include <vector>

namespace hachure {

/// A surface that this frame's view sees.
struct DrawItem {
    Entity entity;
    std::uint32_t mesh = 0; ///< into the MeshStore
    glm::mat4 world_from_entity{1.0f};
    glm::mat3 world_from_normal{1.0f}; ///< inverse transpose of the above
    glm::vec3 tint{1.0f};
    std::uint32_t object_id = 0; ///< AOV `object_id`: 1 for the entity made first, and so on
    gpu::Rect rect;              ///< pixels that it can touch, cut to the view
    bool mirrored = false;       ///< the transform turns front faces round
    /// The capability that shades it: its render pass draws the items that carry its name.
    std::string_view shading = "unlit";
};

/// What this frame's view sees, in the order of object ids. A resource: systems/surface fills it in stage `material`,
/// the capabilities that shade claim their items after it in the same stage, and draw them in stage `render`.
struct DrawList {
    std::vector<DrawItem> items;
    std::uint64_t key = 0; ///< changes whenever an item or the view does: what a pass that draws them depends on

    [[nodiscard]] bool shaded_by(std::string_view shading) const {
        for (const DrawItem& item : items)
            if (item.shading == shading) return true;
        return false;
    }
};

} // namespace hachure
