#pragma once

#include <hachure/components/abstracted_lines.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <glm/vec3.hpp>

#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace hachure {

/// What of its full width a line has at each vertex of a mesh.
struct VertexWidths {
    std::vector<glm::vec3> factors; ///< x in [0, 1], the rest 0: what VertexTextures take
    std::uint64_t version = 0;      ///< another one for each list
};

/// Widths that follow a mesh: the length of its edges (section 3.4, figure 7) or its vertex colours, each made once.
class MeshWidths {
public:
    /// Null where the mesh has no say: `width_by` is something else, or there are no colours to go by, of which one
    /// warning tells.
    const VertexWidths* find(const MeshStore& store, std::uint32_t mesh, const AbstractedLines& lines);

private:
    struct Key {
        std::uint32_t mesh = 0;
        LineAbstraction by = LineAbstraction::edge_length;
        PaintChannel channel = PaintChannel::alpha;
        friend auto operator<=>(const Key&, const Key&) = default;
    };
    std::map<Key, VertexWidths> widths_;
    std::set<std::uint32_t> warned_; ///< meshes
    std::uint64_t version_ = 0;
};

/// The channel of each colour, cut to [0, 1]. Empty where the mesh has no colours.
[[nodiscard]] std::vector<float> painted_widths(const SurfaceMesh& mesh, PaintChannel channel);

/// Lengths of edges relative to the long ones of the mesh (runtime/geometry/edge_lengths.h). Empty where the mesh has
/// no vertices.
[[nodiscard]] std::vector<float> edge_length_widths(const SurfaceMesh& mesh);

} // namespace hachure
