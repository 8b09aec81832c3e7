#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

namespace hachure {

/// Lines along silhouettes, creases and borders of the entity's mesh, drawn where they are visible.
struct EdgeLines {
    bool silhouette = true;
    bool crease = true;
    bool border = true;
    float crease_angle = 1.1f;
    float width = 2.0f;
    glm::vec3 color{0.0f};

    friend bool operator==(const EdgeLines&, const EdgeLines&) = default;
};

inline void reflect(TypeBuilder<EdgeLines>& type) {
    type.name("edge_lines").doc("lines along silhouettes, creases and borders");
    type.field("silhouette", &EdgeLines::silhouette).doc("draw edges between a front face and a back face");
    type.field("crease", &EdgeLines::crease).doc("draw edges whose faces meet at more than crease_angle");
    type.field("border", &EdgeLines::border).doc("draw edges with one face");
    type.field("crease_angle", &EdgeLines::crease_angle)
        .doc("angle between the face normals from which an edge is a crease")
        .unit("rad")
        .range(0, 3.1416);
    type.field("width", &EdgeLines::width).doc("width of the line").unit("px").range(0, 100);
    type.field("color", &EdgeLines::color).color().doc("colour of the line");
}

} // namespace hachure
