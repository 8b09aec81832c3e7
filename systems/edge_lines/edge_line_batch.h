#pragma once

#include <hachure/components/edge_lines.h>
#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/edge_lines/clip_lines.h>
#include <hachure/systems/edge_lines/crossings.h>
#include <hachure/systems/edge_lines/edge_line_mesh.h>
#include <hachure/systems/edge_lines/occluders.h>
#include <hachure/systems/edge_lines/project_lines.h>

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace hachure {

/// The lines of one entity as seen by the last view.
struct EdgeLineBatch {
    std::vector<LineSegment> segments; ///< sorted by kind; where they are clipped, hidden ones after the others
    std::array<SegmentRange, drawn_kinds> kinds;  ///< those that are seen; without clipping, all of them
    std::array<SegmentRange, drawn_kinds> hidden; ///< those that are not; without clipping, the same
    float widest = 0.0f;                          ///< half width of the widest place, pixels
    gpu::VertexArray vertex_array;

    /// Brings the segments to the GPU if they changed since; needs a context.
    void upload();

private:
    friend class EdgeLineBatches;
    std::uint64_t key_ = 0; ///< of what the segments were chosen from
    bool stale_ = true;     ///< `unclipped_` are of this frame, what is drawn is not yet
    bool uploaded_ = false;
    gpu::Buffer buffer_;                 ///< grows, never shrinks
    std::vector<LineSegment> unclipped_; ///< where lines are clipped: what from
    std::vector<PreciseEnds> ends_;      ///< likewise
    std::vector<SegmentRange> lines_;    ///< likewise: which of them are a line
    std::array<SegmentRange, drawn_kinds> unclipped_kinds_;
};

/// An entity with lines in this frame.
struct LinedItem {
    const DrawItem* item = nullptr;
    const EdgeLines* lines = nullptr;
    bool clipped = false; ///< its lines are clipped exactly: asked for, and all shapes are on the CPU
    const EdgeLineBatch* batch = nullptr;
};

/// The batches of all entities with EdgeLines, kept from frame to frame.
class EdgeLineBatches {
public:
    /// Finds the lines of each item anew if view, transform, mesh or component changed, clips those that are to be
    /// clipped if anything did that is drawn, and fills in the items' batches. Needs no context.
    void update(std::span<LinedItem> items, const MeshStore& store, const DrawList& list, const View& view);

    [[nodiscard]] EdgeLineBatch& get(Entity entity) { return batches_.at(entity); }

    /// Drops the batches of entities that are not in `drawn`; needs a context, which their buffers belong to.
    void forget_all_but(std::span<const Entity> drawn);

private:
    void find_lines(const LinedItem& lined, const MeshStore& store, const DrawList& list, const View& view);
    void clip_lines(std::span<const LinedItem> items, const MeshStore& store, const DrawList& list, const View& view);

    std::unordered_map<std::uint32_t, EdgeLineMesh> meshes_;
    std::unordered_map<Entity, EdgeLineBatch> batches_;
    Crossings crossings_;
    Occluders occluders_;
    LineSet lines_;                            ///< scratch
    ClipLinesJob clip_;                        ///< likewise
    std::vector<CrossingItem> crossing_items_; ///< likewise
    std::vector<SegmentRange> segment_runs_;   ///< likewise
};

} // namespace hachure
