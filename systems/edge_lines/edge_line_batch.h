#pragma once

#include <hachure/components/edge_lines.h>
#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/edge_lines/edge_line_mesh.h>
#include <hachure/systems/edge_lines/project_lines.h>

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace hachure {

/// The lines of one entity as seen by the last view.
struct EdgeLineBatch {
    std::vector<LineSegment> segments; ///< sorted by kind
    std::array<SegmentRange, line_kinds> kinds;
    float widest = 0.0f; ///< half width of the widest place, pixels
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
    /// Finds the entity's lines anew if view, transform, mesh or component changed. Needs no context.
    EdgeLineBatch& update(const MeshStore& store, const DrawItem& item, const EdgeLines& lines, const View& view);

    [[nodiscard]] EdgeLineBatch& get(Entity entity) { return batches_.at(entity); }

    /// Drops the batches of entities that are not in `drawn`; needs a context, which their buffers belong to.
    void forget_all_but(std::span<const Entity> drawn);

private:
    std::unordered_map<std::uint32_t, EdgeLineMesh> meshes_;
    std::unordered_map<Entity, EdgeLineBatch> batches_;
    LineSet lines_;                          ///< scratch
    std::vector<SegmentRange> segment_runs_; ///< scratch
};

} // namespace hachure
