#include <hachure/runtime/geometry/creases.h>
#include <hachure/runtime/geometry/select_edges.h>
#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/systems/edge_lines/edge_line_batch.h>

#include <glm/matrix.hpp>

#include <cstddef>
#include <unordered_set>

namespace hachure {
namespace {

EdgeLineMesh make_edge_mesh(const SurfaceMesh& source) {
    EdgeLineMesh mesh;
    mesh.table = geometry::build_edge_table(source.positions, source.indices);
    mesh.planes.resize(source.indices.size() / 3);
    geometry::face_planes(source.positions, source.indices, mesh.planes);
    mesh.front.resize(mesh.planes.size());
    mesh.chosen.resize(mesh.table.edges.size());
    mesh.closed = geometry::is_closed(mesh.table.edges);
    return mesh;
}

std::uint32_t wanted_kinds(const EdgeLines& lines) {
    return (lines.silhouette ? geometry::line_silhouette : 0u) | (lines.crease ? geometry::line_crease : 0u) |
           (lines.border ? geometry::line_border : 0u);
}

std::uint64_t batch_key(const DrawItem& item, const EdgeLines& lines, const View& view) {
    return gpu::key_of(view.key(), item.mesh, item.shape.version, item.world_from_entity, lines.silhouette,
                       lines.crease, lines.border, lines.crease_angle);
}

} // namespace

void EdgeLineBatch::upload() {
    if (uploaded_ || segments.empty()) return;
    const std::size_t bytes = segments.size() * sizeof(EdgeSegment);
    if (buffer_.bytes() < bytes) {
        // Room to grow by half: the count changes with every view.
        buffer_ = gpu::Buffer(bytes + bytes / 2, gpu::BufferUsage::dynamic, "edge lines");
        vertex_array = gpu::VertexArray("edge lines");
        vertex_array.set_attribute({.location = 0, .components = 3, .offset = 0});
        vertex_array.set_attribute({.location = 1, .components = 3, .offset = offsetof(EdgeSegment, end)});
        vertex_array.set_vertex_buffer(0, buffer_, sizeof(EdgeSegment), 0, 1);
    }
    buffer_.update(std::span<const EdgeSegment>(segments));
    uploaded_ = true;
}

void EdgeLineBatches::update(const MeshStore& store, const DrawItem& item, const EdgeLines& lines, const View& view) {
    EdgeLineBatch& batch = batches_[item.entity];
    const std::uint64_t key = batch_key(item, lines, view);
    if (batch.key_ == key) return;
    EdgeLineMesh& edges = mesh(store, item.mesh);
    const SurfaceMesh& source = store.mesh(item.mesh);
    // Creases are the mesh's own, whatever its shape: they would come and go as a character moves.
    if (edges.crease_angle != lines.crease_angle) {
        const std::vector<std::uint8_t> creases =
            geometry::find_creases(source.positions, edges.table.edges, edges.planes, lines.crease_angle);
        edges.features = geometry::feature_edges(edges.table.edges, creases, {});
        edges.crease_angle = lines.crease_angle;
    }
    // Lines that a surface was given in this very frame: from the next on, its shape is on the CPU.
    const bool deformed = item.shape.version != 0 && !item.shape.on_gpu;
    const std::span<const glm::vec3> positions = deformed ? item.shape.positions : std::span(source.positions);
    if (deformed) {
        edges.moved_planes.resize(edges.planes.size());
        geometry::face_planes(positions, source.indices, edges.moved_planes);
    }
    geometry::SelectEdgesJob job{.edges = edges.table.edges,
                                 .planes = deformed ? edges.moved_planes : edges.planes,
                                 .features = edges.features,
                                 .eye = glm::inverse(item.world_from_entity) * view.eye,
                                 .wanted = wanted_kinds(lines),
                                 .closed = edges.closed,
                                 .front = edges.front,
                                 .chosen = edges.chosen};
    job.run();
    batch.segments.clear();
    for (std::size_t i = 0; i < job.count; ++i) {
        const geometry::Edge& edge = edges.table.edges[edges.chosen[i].edge];
        batch.segments.push_back({positions[edge.v0], positions[edge.v1]});
    }
    batch.world_from_entity = item.world_from_entity;
    batch.key_ = key;
    batch.uploaded_ = false;
}

void EdgeLineBatches::forget_all_but(std::span<const Entity> drawn) {
    if (batches_.size() == drawn.size()) return;
    const std::unordered_set<Entity> kept(drawn.begin(), drawn.end());
    std::erase_if(batches_, [&](const auto& entry) { return !kept.contains(entry.first); });
}

EdgeLineMesh& EdgeLineBatches::mesh(const MeshStore& store, std::uint32_t index) {
    const auto found = meshes_.find(index);
    if (found != meshes_.end()) return found->second;
    return meshes_.emplace(index, make_edge_mesh(store.mesh(index))).first->second;
}

} // namespace hachure
