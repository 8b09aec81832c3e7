#include <hachure/systems/edge_lines/edge_line_mesh.h>
#include <hachure/systems/edge_lines/select_edges.h>

#include <glm/matrix.hpp>

#include <algorithm>
#include <span>

namespace hachure {

EdgeLineMesh::EdgeLineMesh(const SurfaceMesh& source)
    : table_(geometry::build_edge_table(source.positions, source.indices)), planes_(source.indices.size() / 3),
      creases_(table_.edges.size(), 0), front_(planes_.size()), selected_(table_.edges.size()) {
    geometry::face_planes(source.positions, source.indices, planes_);
    closed_ = std::ranges::none_of(table_.edges, [](const geometry::Edge& edge) {
        return (edge.flags & (geometry::edge_border | geometry::edge_orientation_mismatch)) != 0;
    });
}

void EdgeLineMesh::find_lines(const SurfaceMesh& source, const DrawItem& item, const EdgeLines& wanted,
                              const View& view, LineSet& lines) {
    // Creases are the mesh's own, whatever its shape: they would come and go as a character moves.
    if (wanted.crease && crease_angle_ != wanted.crease_angle) {
        creases_ = find_creases(source.positions, table_.edges, planes_, wanted.crease_angle);
        crease_angle_ = wanted.crease_angle;
    }
    // Lines that a surface was given in this very frame: from the next on, its shape is on the CPU.
    const bool deformed = item.shape.version != 0 && !item.shape.on_gpu;
    const std::span<const glm::vec3> positions = deformed ? item.shape.positions : std::span(source.positions);
    if (deformed) {
        moved_planes_.resize(planes_.size());
        geometry::face_planes(positions, source.indices, moved_planes_);
    }
    SelectEdgesJob job{.edges = table_.edges,
                       .planes = deformed ? moved_planes_ : planes_,
                       .creases = creases_,
                       .eye = glm::inverse(item.world_from_entity) * view.eye,
                       .silhouette = wanted.silhouette,
                       .crease = wanted.crease,
                       .border = wanted.border,
                       .closed = closed_,
                       .front = front_,
                       .selected = selected_};
    job.run();
    lines.clear();
    const auto kind_of = [&](const geometry::Edge& edge) {
        if (edge.face1 == geometry::no_face) return LineKind::border;
        const bool mismatch = (edge.flags & geometry::edge_orientation_mismatch) != 0;
        const bool turns = (front_[edge.face0] != 0) != ((front_[edge.face1] != 0) != mismatch);
        return turns && wanted.silhouette ? LineKind::silhouette : LineKind::crease;
    };
    for (const LineKind kind : {LineKind::crease, LineKind::border, LineKind::silhouette})
        for (std::size_t i = 0; i < job.count; ++i) {
            const geometry::Edge& edge = table_.edges[selected_[i]];
            if (kind_of(edge) == kind) lines.add(kind, positions[edge.v0], positions[edge.v1]);
        }
}

} // namespace hachure
