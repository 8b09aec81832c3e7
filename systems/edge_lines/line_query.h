#pragma once

#include <hachure/components/edge_lines.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/view.h>

#include <glm/matrix.hpp>

#include <span>

namespace hachure {

/// What is asked of a mesh: which lines, of an item in its shape of this frame, seen from where.
struct LineQuery {
    const SurfaceMesh* mesh = nullptr;
    const EdgeLines* wanted = nullptr;
    std::span<const glm::vec3> positions; ///< of the shape
    bool deformed = false;                ///< the shape is not the mesh's own
    std::uint64_t version = 0;            ///< of the shape, as DrawShape::version
    glm::vec4 eye{0.0f};                  ///< in the entity's space: a place (w = 1) or a direction (w = 0)
};

inline LineQuery line_query(const SurfaceMesh& mesh, const DrawItem& item, const EdgeLines& wanted, const View& view) {
    // Lines that a surface was given in this very frame: from the next on, its shape is on the CPU.
    const bool deformed = item.shape.version != 0 && !item.shape.on_gpu;
    return {.mesh = &mesh,
            .wanted = &wanted,
            .positions = deformed ? item.shape.positions : std::span(mesh.positions),
            .deformed = deformed,
            .version = deformed ? item.shape.version : 0,
            .eye = glm::inverse(item.world_from_entity) * view.eye};
}

} // namespace hachure
