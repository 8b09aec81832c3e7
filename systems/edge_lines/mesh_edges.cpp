#include <hachure/systems/edge_lines/mesh_edges.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace hachure {
namespace {

std::uint32_t wanted_kinds(const EdgeLines& lines) {
    return (lines.silhouette ? geometry::line_silhouette : 0u) | (lines.crease ? geometry::line_crease : 0u) |
           (lines.border ? geometry::line_border : 0u) | (lines.material ? geometry::line_material : 0u);
}

/// Materials of one name are one, wherever its triangles are.
std::vector<std::uint32_t> face_materials(const SurfaceMesh& mesh) {
    std::vector<std::uint32_t> materials(mesh.indices.size() / 3, 0);
    for (std::size_t i = 0; i < mesh.submeshes.size(); ++i) {
        std::size_t same = 0;
        while (same < i && mesh.submeshes[same].material.name != mesh.submeshes[i].material.name) ++same;
        const Submesh& submesh = mesh.submeshes[i];
        for (std::uint32_t face = submesh.first_index / 3; face < (submesh.first_index + submesh.index_count) / 3;
             ++face)
            materials[face] = static_cast<std::uint32_t>(same);
    }
    return materials;
}

} // namespace

MeshEdges::MeshEdges(const SurfaceMesh& source)
    : table_(geometry::build_edge_table(source.positions, source.indices)), planes_(source.indices.size() / 3),
      closed_(geometry::is_closed(table_.edges)) {
    geometry::face_planes(source.positions, source.indices, planes_);
}

void MeshEdges::find_features(const LineQuery& query) {
    const EdgeLines& wanted = *query.wanted;
    if (feature_angle_ == wanted.crease_angle && feature_materials_ >= wanted.material) return;
    std::vector<std::uint8_t> materials;
    if (wanted.material) materials = geometry::find_material_edges(table_.edges, face_materials(*query.mesh));
    // Creases are the mesh's own, whatever its shape: they would come and go as a character moves.
    const std::vector<std::uint8_t> creases =
        geometry::find_creases(query.mesh->positions, table_.edges, planes_, wanted.crease_angle);
    features_ = geometry::feature_edges(table_.edges, creases, materials);
    feature_angle_ = wanted.crease_angle;
    feature_materials_ = wanted.material;
}

std::span<const geometry::ChosenEdge> MeshEdges::choose(const LineQuery& query) {
    const std::uint32_t kinds = wanted_kinds(*query.wanted);
    if (kinds == 0) return {};
    find_features(query);
    if (!query.deformed) {
        if (tree_.size() == 0) tree_ = geometry::edge_tree(table_.edges, planes_);
        by_tree_.edges = table_.edges;
        by_tree_.planes = planes_;
        by_tree_.features = features_;
        by_tree_.tree = &tree_;
        by_tree_.eye = query.eye;
        by_tree_.wanted = kinds;
        by_tree_.closed = closed_;
        by_tree_.run();
        return by_tree_.chosen;
    }
    moved_planes_.resize(planes_.size());
    front_.resize(planes_.size());
    chosen_.resize(table_.edges.size());
    geometry::face_planes(query.positions, query.mesh->indices, moved_planes_);
    geometry::SelectEdgesJob job{.edges = table_.edges,
                                 .planes = moved_planes_,
                                 .features = features_,
                                 .eye = query.eye,
                                 .wanted = kinds,
                                 .closed = closed_,
                                 .front = front_,
                                 .chosen = chosen_};
    job.run();
    return std::span(chosen_).first(job.count);
}

bool MeshEdges::in_valley(const LineQuery& query, const geometry::Edge& edge) const {
    if (!closed_ || edge.face1 == geometry::no_face || edge.flags != 0) return false;
    const auto corner = [&](std::uint32_t face, std::uint32_t k) {
        return query.positions[query.mesh->indices[3 * face + k]];
    };
    const glm::vec3 a = corner(edge.face0, 0);
    const glm::vec3 normal = glm::cross(corner(edge.face0, 1) - a, corner(edge.face0, 2) - a);
    // Of the other face, the corner that is not on the edge is the farthest from the first one's plane.
    float above = 0.0f;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const float distance = glm::dot(normal, corner(edge.face1, k) - a);
        if (std::abs(distance) > std::abs(above)) above = distance;
    }
    return above > 0.0f;
}

std::span<const std::uint8_t> MeshEdges::smooth_faces(const LineQuery& query) {
    const float angle = query.wanted->crease_angle;
    if (smooth_angle_ == angle) return smooth_faces_;
    const SurfaceMesh& mesh = *query.mesh;
    const std::vector<std::uint32_t> weld = geometry::weld_positions(mesh.positions);
    std::vector<std::uint8_t> sharp(mesh.positions.size(), 0);
    for (const geometry::Edge& edge : table_.edges) {
        bool is_sharp = edge.face1 == geometry::no_face;
        if (!is_sharp) {
            const float cosine = glm::dot(glm::vec3(planes_[edge.face0]), glm::vec3(planes_[edge.face1]));
            const bool mismatch = (edge.flags & geometry::edge_orientation_mismatch) != 0;
            is_sharp = (mismatch ? -cosine : cosine) < std::cos(angle);
        }
        if (is_sharp) sharp[weld[edge.v0]] = sharp[weld[edge.v1]] = 1;
    }
    smooth_faces_.assign(planes_.size(), 1);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        if (sharp[weld[mesh.indices[i]]]) smooth_faces_[i / 3] = 0;
    smooth_angle_ = angle;
    return smooth_faces_;
}

} // namespace hachure
