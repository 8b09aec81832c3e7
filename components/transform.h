#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace hachure {

/// Where an entity stands relative to its parent: `translation * rotation * scale`, as in glTF.
struct Transform {
    glm::vec3 translation{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};

    friend bool operator==(const Transform&, const Transform&) = default;
};

inline void reflect(TypeBuilder<Transform>& type) {
    type.name("transform").doc("place, turn and size relative to the parent entity");
    type.field("translation", &Transform::translation).doc("place").unit("m");
    type.field("rotation", &Transform::rotation).doc("turn, as a quaternion x, y, z, w");
    type.field("scale", &Transform::scale).doc("size along each axis");
}

} // namespace hachure
