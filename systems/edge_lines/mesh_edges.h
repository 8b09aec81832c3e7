#pragma once

#include <hachure/runtime/geometry/creases.h>
#include <hachure/runtime/geometry/select_edges.h>
#include <hachure/runtime/geometry/select_edges_by_tree.h>
#include <hachure/runtime/geometry/weld.h>
#include <hachure/systems/edge_lines/line_query.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// The edges of one mesh and what choosing among them needs.
class MeshEdges {
public:
    explicit MeshEdges(const SurfaceMesh& source);

    /// The edges that are drawn, ascending; valid until the next call.
    [[nodiscard]] std::span<const geometry::ChosenEdge> choose(const LineQuery& query);

    [[nodiscard]] const geometry::Edge& edge(std::uint32_t index) const { return table_.edges[index]; }

    /// Whether a silhouette is sure to be hidden: on a closed surface, one where the faces meet in a valley has its
    /// back face before its front face, and before that another front face. On a smooth surface these are the parts of
    /// its contour past the cusps, which lie so little behind what hides them that no depth buffer tells them apart.
    [[nodiscard]] bool in_valley(const LineQuery& query, const geometry::Edge& edge) const;

    /// Faces none of whose corners lies on an edge sharper than the crease angle, or on a border: a byte per face.
    [[nodiscard]] std::span<const std::uint8_t> smooth_faces(const LineQuery& query);

private:
    void find_features(const LineQuery& query);

    geometry::EdgeTable table_;
    std::vector<glm::vec4> planes_;       ///< of the mesh's own shape
    std::vector<glm::vec4> moved_planes_; ///< scratch: of the shape at hand
    std::vector<geometry::ChosenEdge> features_;
    float feature_angle_ = -1.0f;    ///< crease angle that features were found with; -1 for not yet
    bool feature_materials_ = false; ///< whether boundaries of materials are among them
    geometry::PlaneTree tree_;
    geometry::SelectEdgesByTreeJob by_tree_;
    std::vector<std::uint8_t> front_;          ///< scratch of SelectEdgesJob
    std::vector<geometry::ChosenEdge> chosen_; ///< likewise
    std::vector<std::uint8_t> smooth_faces_;
    float smooth_angle_ = -1.0f; ///< crease angle that they were found with
    bool closed_ = false;
};

} // namespace hachure
