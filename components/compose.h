#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

namespace hachure {

/// How the layers of a view become its picture; on the camera's entity, or defaults.
struct Compose {
    glm::vec3 background{1.0f};
    bool surfaces = true;

    friend bool operator==(const Compose&, const Compose&) = default;
};

inline void reflect(TypeBuilder<Compose>& type) {
    type.name("compose").doc("how the layers of a view become its picture");
    type.field("background", &Compose::background).color().doc("colour where nothing is drawn");
    type.field("surfaces", &Compose::surfaces)
        .doc("surfaces and pictures show under lines; else lines alone stand on the background, hidden and coloured as "
             "if they did");
}

} // namespace hachure
