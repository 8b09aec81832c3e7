#pragma once

#include <hachure/systems/edge_lines/line_builder.h>
#include <hachure/systems/edge_lines/line_query.h>
#include <hachure/systems/edge_lines/mesh_edges.h>
#include <hachure/systems/edge_lines/smooth_surface.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hachure {

/// All that finding lines of one mesh needs, each part made when a line is first asked for that needs it.
class EdgeLineMesh {
public:
    using Segments = std::span<const geometry::SurfaceSegment>;

    /// The lines of a shape of this mesh that the view is given, whether it sees them or not, sorted by kind.
    /// `crossings` are those with other surfaces, in the entity's space, a list each: they are drawn as intersections,
    /// too.
    void find_lines(const LineQuery& query, std::span<const Segments> crossings, LineSet& lines);

private:
    void find_edges(const LineQuery& query);
    void find_smooth_silhouettes(const LineQuery& query);
    void find_intersections(const LineQuery& query);
    [[nodiscard]] SmoothSurface& smooth(const LineQuery& query);

    /// What is drawn of one kind.
    struct Found {
        std::vector<geometry::SurfaceSegment> segments;
        std::vector<float> lift; ///< per segment, or empty
    };
    [[nodiscard]] Found& found(DrawnKind kind) { return found_[static_cast<std::size_t>(kind)]; }

    std::optional<MeshEdges> edges_;
    std::optional<SmoothSurface> smooth_;
    std::vector<geometry::SurfaceSegment> own_intersections_; ///< of the mesh's own shape
    bool knows_intersections_ = false;
    std::array<Found, drawn_kinds> found_;
    LineBuilder builder_;
};

} // namespace hachure
