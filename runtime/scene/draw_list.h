#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/framebuffer.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace hachure {

/// The shape of a deformed surface in this frame; views of what its entity owns, which hold until the next frame's
/// list.
struct DrawShape {
    std::span<const glm::vec3> positions; ///< in entity space, by vertex of the mesh
    std::span<const glm::vec3> normals;   ///< unit
    std::span<const glm::vec4> tangents;  ///< empty where the mesh has none
    std::uint64_t version = 0;            ///< another one for each shape; 0: the mesh's own
    bool on_gpu = false;                  ///< a pass writes it (GpuMeshes::shape_buffer); the spans are empty
};

/// A surface that this frame's view sees.
struct DrawItem {
    Entity entity;
    std::uint32_t mesh = 0; ///< into the MeshStore
    DrawShape shape;        ///< of `version` 0 where the mesh does not deform
    glm::mat4 world_from_entity{1.0f};
    glm::mat3 world_from_normal{1.0f}; ///< inverse transpose of the above
    glm::vec3 tint{1.0f};
    std::uint32_t object_id = 0; ///< AOV `object_id`: 1 for the visible entity made first, and so on
    gpu::Rect rect;              ///< pixels that it can touch, cut to the view
    float nearest = 1.0f;        ///< metres from the eye's plane to what of it can be nearest, above 0
    bool mirrored = false;       ///< the transform turns front faces round
};

/// A visible entity with a Picture (components/picture.h), which is drawn behind all items.
struct DrawPicture {
    Entity entity;
    std::uint32_t object_id = 0; ///< numbered along with the surfaces
};

/// What this frame's view sees, in the order of object ids. A resource: systems/surface fills it in stage `material`
/// ("surface.collect").
struct DrawList {
    std::vector<DrawItem> items;
    std::vector<DrawPicture> pictures;
    std::uint64_t key = 0; ///< changes whenever an item or the view does: what a pass that draws them depends on
};

/// Which capability shades each item of the DrawList. A resource of its own, so that who only looks at the items need
/// not wait for claims: "surface.collect" resets it, the capabilities that shade claim their items after it in the same
/// stage, and draw them in stage `render`.
struct DrawClaims {
    std::vector<std::string_view> shading; ///< by item: the name of the capability; "unlit" where none claims it

    [[nodiscard]] bool any(std::string_view capability) const {
        return std::ranges::find(shading, capability) != shading.end();
    }
};

} // namespace hachure
