#include <hachure/runtime/geometry/intersect_meshes.h>
#include <hachure/systems/edge_lines/edge_line_mesh.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace hachure {
namespace {

using geometry::SurfaceSegment;

DrawnKind kind_of(std::uint32_t kinds) {
    if ((kinds & geometry::line_border) != 0) return DrawnKind::border;
    if ((kinds & geometry::line_silhouette) != 0) return DrawnKind::silhouette;
    return (kinds & geometry::line_crease) != 0 ? DrawnKind::crease : DrawnKind::material;
}

float longest_side(const LineQuery& query, std::uint32_t face) {
    const auto corner = [&](std::uint32_t k) { return query.positions[query.mesh->indices[3 * face + k]]; };
    return std::max({glm::distance(corner(0), corner(1)), glm::distance(corner(1), corner(2)),
                     glm::distance(corner(2), corner(0))});
}

} // namespace

SmoothSurface& EdgeLineMesh::smooth(const LineQuery& query) {
    if (!smooth_) smooth_.emplace(*query.mesh);
    return *smooth_;
}

void EdgeLineMesh::find_edges(const LineQuery& query) {
    if (!edges_) edges_.emplace(*query.mesh);
    // Where the surface is smooth, its silhouette runs inside triangles.
    std::span<const std::uint8_t> smooth;
    if (query.wanted->silhouette && query.wanted->smooth_silhouette) smooth = edges_->smooth_faces(query);
    for (const geometry::ChosenEdge& chosen : edges_->choose(query)) {
        const geometry::Edge& edge = edges_->edge(chosen.edge);
        const DrawnKind kind = kind_of(chosen.kinds);
        if (kind == DrawnKind::silhouette && !smooth.empty() && smooth[edge.face0] && smooth[edge.face1]) continue;
        Found& lines = found(kind);
        if (kind == DrawnKind::silhouette) lines.lift.push_back(edges_->in_valley(query, edge) ? never_seen : 0.0f);
        lines.segments.push_back({.start = query.positions[edge.v0],
                                  .end = query.positions[edge.v1],
                                  .face = edge.face0,
                                  .other_face = edge.face1,
                                  .start_id = geometry::end_at_vertex(edge.v0),
                                  .end_id = geometry::end_at_vertex(edge.v1)});
    }
}

/// The smooth surface turns away a little beside the triangles that stand for it: by up to the size of one these hide
/// its silhouette, and so much nearer it is taken to be.
void EdgeLineMesh::find_smooth_silhouettes(const LineQuery& query) {
    const std::span<const std::uint8_t> smooth_faces = edges_->smooth_faces(query);
    Found& silhouettes = found(DrawnKind::silhouette);
    for (const SurfaceSegment& segment : smooth(query).silhouettes(query)) {
        if (!smooth_faces[segment.face]) continue;
        silhouettes.segments.push_back(segment);
        silhouettes.lift.push_back(longest_side(query, segment.face));
    }
}

void EdgeLineMesh::find_intersections(const LineQuery& query) {
    std::vector<SurfaceSegment>& segments = found(DrawnKind::intersection).segments;
    if (query.deformed) {
        segments = geometry::self_intersections(query.positions, query.mesh->indices);
        return;
    }
    if (!knows_intersections_) own_intersections_ = geometry::self_intersections(query.positions, query.mesh->indices);
    knows_intersections_ = true;
    segments = own_intersections_;
}

void EdgeLineMesh::find_lines(const LineQuery& query, std::span<const Segments> crossings, LineSet& lines) {
    const EdgeLines& wanted = *query.wanted;
    for (Found& kind : found_) {
        kind.segments.clear();
        kind.lift.clear();
    }
    find_edges(query);
    if (wanted.silhouette && wanted.smooth_silhouette) find_smooth_silhouettes(query);
    if (wanted.intersection) find_intersections(query);
    if (wanted.suggestive) {
        const std::span<const SurfaceSegment> contours = smooth(query).suggestive_contours(query);
        found(DrawnKind::suggestive).segments.assign(contours.begin(), contours.end());
    }
    lines.clear();
    const bool chained = wanted.taper > 0.0f || wanted.hidden == HiddenLines::dashed;
    for (std::size_t i = 0; i < drawn_kinds; ++i) {
        const auto kind = static_cast<DrawnKind>(i);
        builder_.add(lines, kind, found_[i].segments, found_[i].lift, chained);
        // Ends of different surfaces have nothing to do with each other: each list is linked by itself.
        if (kind == DrawnKind::intersection && wanted.intersection)
            for (const Segments& crossing : crossings) builder_.add(lines, kind, crossing, {}, chained);
    }
}

} // namespace hachure
