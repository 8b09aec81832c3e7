#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/systems/edge_lines/edge_line_batch.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>

namespace hachure {
namespace {

std::uint64_t batch_key(const DrawItem& item, const EdgeLines& lines, const View& view) {
    return gpu::key_of(view.key(), item.mesh, item.shape.version, item.world_from_entity, lines.silhouette,
                       lines.smooth_silhouette, lines.crease, lines.border, lines.material, lines.intersection,
                       lines.suggestive, lines.crease_angle, lines.width, lines.width_unit);
}

LineWidth width_on_screen(const EdgeLines& lines, const View& view) {
    const double half = 0.5 * double(lines.width);
    switch (lines.width_unit) {
    case LineWidthUnit::pixels:
        break;
    case LineWidthUnit::picture:
        return {half * view.height / 1000.0, false};
    case LineWidthUnit::world:
        // The clip w of a point is its depth in a perspective view and 1 in an orthographic one.
        return {half / double(view.pixel_size), true};
    }
    return {half, false};
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

EdgeLineBatch& EdgeLineBatches::update(const MeshStore& store, const DrawItem& item, const EdgeLines& lines,
                                       const View& view) {
    EdgeLineBatch& batch = batches_[item.entity];
    const std::uint64_t key = batch_key(item, lines, view);
    if (batch.key_ == key) return batch;
    const SurfaceMesh& source = store.mesh(item.mesh);
    EdgeLineMesh& mesh = meshes_.try_emplace(item.mesh, source).first->second;
    mesh.find_lines(source, item, lines, view, lines_);
    ProjectLinesJob job{.lines = &lines_,
                        .clip_from_entity = glm::dmat4(view.clip_from_world) * glm::dmat4(item.world_from_entity),
                        .viewport = {view.width, view.height},
                        .width = width_on_screen(lines, view),
                        .segments = &batch.segments,
                        .lines_out = &segment_runs_};
    job.run();
    batch.kinds = job.kinds;
    batch.widest = 0.0f;
    for (const LineSegment& segment : batch.segments)
        batch.widest = std::max({batch.widest, segment.half_width.x, segment.half_width.y});
    batch.key_ = key;
    batch.uploaded_ = false;
    return batch;
}

void EdgeLineBatches::forget_all_but(std::span<const Entity> drawn) {
    if (batches_.size() == drawn.size()) return;
    const std::unordered_set<Entity> kept(drawn.begin(), drawn.end());
    std::erase_if(batches_, [&](const auto& entry) { return !kept.contains(entry.first); });
}

} // namespace hachure
