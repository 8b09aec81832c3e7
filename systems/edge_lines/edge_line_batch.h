#pragma once

#include <hachure/components/edge_lines.h>
#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/geometry/line_kinds.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/view.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace hachure {

/// The edges of one mesh and what choosing among them needs; made when the first entity asks for lines.
struct EdgeLineMesh {
    geometry::EdgeTable table;
    std::vector<glm::vec4> planes;       ///< of the mesh's own shape
    std::vector<glm::vec4> moved_planes; ///< scratch: of the shape at hand
    std::vector<geometry::ChosenEdge> features;
    float crease_angle = -1.0f;               ///< which they were found with; -1 for not yet
    std::vector<std::uint8_t> front;          ///< scratch of SelectEdgesJob
    std::vector<geometry::ChosenEdge> chosen; ///< likewise
    bool closed = false;
};

/// A line to draw, in entity space.
struct EdgeSegment {
    glm::vec3 start, end;
};

/// The lines of one entity as seen by the last view.
struct EdgeLineBatch {
    std::vector<EdgeSegment> segments;
    glm::mat4 world_from_entity{1.0f};
    gpu::VertexArray vertex_array;

    /// Brings the segments to the GPU if they changed since; needs a context.
    void upload();

private:
    friend class EdgeLineBatches;
    std::uint64_t key_ = 0; ///< of what the segments were chosen from
    bool uploaded_ = false;
    gpu::Buffer buffer_; ///< grows, never shrinks
};

/// The batches of all entities with EdgeLines, kept from frame to frame.
class EdgeLineBatches {
public:
    /// Chooses the entity's edges anew if view, transform, mesh or component changed. Needs no context.
    void update(const MeshStore& store, const DrawItem& item, const EdgeLines& lines, const View& view);

    [[nodiscard]] EdgeLineBatch& get(Entity entity) { return batches_.at(entity); }

    /// Drops the batches of entities that are not in `drawn`; needs a context, which their buffers belong to.
    void forget_all_but(std::span<const Entity> drawn);

private:
    EdgeLineMesh& mesh(const MeshStore& store, std::uint32_t index);

    std::unordered_map<std::uint32_t, EdgeLineMesh> meshes_;
    std::unordered_map<Entity, EdgeLineBatch> batches_;
};

} // namespace hachure
