#pragma once

#include <hachure/components/edge_lines.h>
#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/edge_lines/line_set.h>

#include <cstdint>
#include <vector>

namespace hachure {

/// The edges of one mesh and what choosing among them needs; made when the first entity asks for lines.
class EdgeLineMesh {
public:
    explicit EdgeLineMesh(const SurfaceMesh& source);

    /// The lines of an item of this mesh that the view is given, whether it sees them or not, sorted by kind.
    void find_lines(const SurfaceMesh& source, const DrawItem& item, const EdgeLines& wanted, const View& view,
                    LineSet& lines);

private:
    geometry::EdgeTable table_;
    std::vector<glm::vec4> planes_;       ///< of the mesh's own shape
    std::vector<glm::vec4> moved_planes_; ///< scratch: of the shape at hand
    std::vector<std::uint8_t> creases_;   ///< of find_creases
    float crease_angle_ = -1.0f;          ///< which they were found with; -1 for not yet
    std::vector<std::uint8_t> front_;     ///< scratch of SelectEdgesJob
    std::vector<std::uint32_t> selected_; ///< likewise
    bool closed_ = false;
};

} // namespace hachure
