#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/systems/edge_lines/edge_line_batch.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>

namespace hachure {
namespace {

std::uint64_t batch_key(const DrawItem& item, const EdgeLines& lines, const View& view, std::uint64_t crossings,
                        bool clipped) {
    return gpu::key_of(view.key(), item.mesh, item.shape.version, item.world_from_entity, crossings, lines.silhouette,
                       lines.smooth_silhouette, lines.crease, lines.border, lines.material, lines.intersection,
                       lines.suggestive, lines.suggestive_threshold, lines.crease_angle, lines.width, lines.width_unit,
                       lines.taper > 0.0f, lines.hidden == HiddenLines::dashed, clipped);
}

void describe_segments(gpu::VertexArray& vertex_array) {
    const auto attribute = [&](unsigned location, int components, std::size_t offset) {
        vertex_array.set_attribute(
            {.location = location, .components = components, .offset = static_cast<unsigned>(offset)});
    };
    attribute(0, 4, offsetof(LineSegment, start));
    attribute(1, 2, offsetof(LineSegment, depth));
    attribute(2, 2, offsetof(LineSegment, half_width));
    attribute(3, 2, offsetof(LineSegment, weight));
    attribute(4, 2, offsetof(LineSegment, arc));
    attribute(5, 2, offsetof(LineSegment, ends));
}

} // namespace

void EdgeLineBatch::upload() {
    if (uploaded_ || segments.empty()) return;
    const std::size_t bytes = segments.size() * sizeof(LineSegment);
    if (buffer_.bytes() < bytes) {
        // Room to grow by half: the count changes with every view.
        buffer_ = gpu::Buffer(bytes + bytes / 2, gpu::BufferUsage::dynamic, "edge lines");
        vertex_array = gpu::VertexArray("edge lines");
        describe_segments(vertex_array);
        vertex_array.set_vertex_buffer(0, buffer_, sizeof(LineSegment), 0, 1);
    }
    buffer_.update(std::span<const LineSegment>(segments));
    uploaded_ = true;
}

void EdgeLineBatches::update(std::span<LinedItem> items, const MeshStore& store, const DrawList& list,
                             const View& view) {
    crossing_items_.clear();
    for (const LinedItem& lined : items) crossing_items_.push_back({lined.item, lined.lines->intersection});
    crossings_.update(crossing_items_, store);
    for (LinedItem& lined : items) {
        find_lines(lined, store, list, view);
        lined.batch = &batches_[lined.item->entity];
    }
    clip_lines(items, store, list, view);
}

void EdgeLineBatches::find_lines(const LinedItem& lined, const MeshStore& store, const DrawList& list,
                                 const View& view) {
    const DrawItem& item = *lined.item;
    const EdgeLines& lines = *lined.lines;
    EdgeLineBatch& batch = batches_[item.entity];
    std::uint64_t key = batch_key(item, lines, view, crossings_.key(item.entity), lined.clipped);
    if (lined.clipped) key = gpu::key_of(key, list.key);
    if (batch.key_ == key) return;
    meshes_[item.mesh].find_lines(line_query(store.mesh(item.mesh), item, lines, view), crossings_.of(item.entity),
                                  lines_);
    ProjectLinesJob job{.lines = &lines_,
                        .clip_from_entity = glm::dmat4(view.clip_from_world) * glm::dmat4(item.world_from_entity),
                        .clip_per_metre = {view.clip_from_view[2][2], view.clip_from_view[2][3]},
                        .viewport = {view.width, view.height},
                        .width = width_on_screen(lines, view),
                        .segments = lined.clipped ? &batch.unclipped_ : &batch.segments,
                        .ends = lined.clipped ? &batch.ends_ : nullptr,
                        .lines_out = lined.clipped ? &batch.lines_ : &segment_runs_};
    job.run();
    batch.kinds = batch.hidden = batch.unclipped_kinds_ = job.kinds;
    batch.widest = 0.0f;
    for (const LineSegment& segment : *job.segments)
        batch.widest = std::max({batch.widest, segment.half_width.x, segment.half_width.y});
    batch.key_ = key;
    batch.stale_ = lined.clipped;
    batch.uploaded_ = false;
}

void EdgeLineBatches::clip_lines(std::span<const LinedItem> items, const MeshStore& store, const DrawList& list,
                                 const View& view) {
    const auto each_stale = [&](auto&& visit) {
        for (const LinedItem& lined : items)
            if (EdgeLineBatch& batch = batches_[lined.item->entity]; batch.stale_) visit(batch);
    };
    bool any = false;
    each_stale([&](const EdgeLineBatch&) { any = true; });
    if (!any) return;
    occluders_.begin(view);
    each_stale([&](const EdgeLineBatch& batch) {
        for (const PreciseEnds& ends : batch.ends_) occluders_.want(ends.start, ends.end);
    });
    occluders_.fill(list, store, view);
    each_stale([&](EdgeLineBatch& batch) {
        clip_.segments = batch.unclipped_;
        clip_.ends = batch.ends_;
        clip_.lines = batch.lines_;
        clip_.kinds = batch.unclipped_kinds_;
        clip_.occluders = &occluders_;
        clip_.viewport = {view.width, view.height};
        clip_.pieces = &batch.segments;
        clip_.run();
        batch.kinds = clip_.seen;
        batch.hidden = clip_.hidden;
        batch.stale_ = false;
    });
}

void EdgeLineBatches::forget_all_but(std::span<const Entity> drawn) {
    if (batches_.size() == drawn.size()) return;
    const std::unordered_set<Entity> kept(drawn.begin(), drawn.end());
    std::erase_if(batches_, [&](const auto& entry) { return !kept.contains(entry.first); });
}

} // namespace hachure
