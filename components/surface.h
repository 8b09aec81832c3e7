#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

#include <cstdint>

namespace hachure {

/// A drawn mesh: which one, and what holds for all of its materials.
struct Surface {
    std::uint32_t mesh = 0; ///< index into the world's MeshStore
    bool visible = true;
    glm::vec3 tint{1.0f};

    friend bool operator==(const Surface&, const Surface&) = default;
};

inline void reflect(TypeBuilder<Surface>& type) {
    type.name("surface").doc("a drawn mesh");
    type.field("visible", &Surface::visible).doc("is drawn");
    type.field("tint", &Surface::tint).color().doc("multiplies the base colours of the mesh's materials");
}

} // namespace hachure
