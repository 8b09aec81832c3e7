#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/creases.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numeric>

namespace hachure::geometry {
namespace {

bool is_sharp(const Edge& edge, std::span<const glm::vec4> planes, float cosine_limit) {
    if (edge.face1 == no_face) return false;
    const float cosine = glm::dot(glm::vec3(planes[edge.face0]), glm::vec3(planes[edge.face1]));
    const bool mismatch = (edge.flags & edge_orientation_mismatch) != 0;
    return (mismatch ? -cosine : cosine) < cosine_limit;
}

/// Disjoint sets of vertices, joined by the creases between them.
class CreaseChains {
public:
    explicit CreaseChains(std::size_t vertices) : parent_(vertices) { std::iota(parent_.begin(), parent_.end(), 0u); }

    std::uint32_t root(std::uint32_t v) {
        while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
        return v;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

private:
    std::vector<std::uint32_t> parent_;
};

struct ChainSize {
    std::size_t edges = 0;
    float length = 0.0f;
};

} // namespace

std::vector<std::uint8_t> find_creases(std::span<const glm::vec3> positions, std::span<const Edge> edges,
                                       std::span<const glm::vec4> planes, float crease_angle, float noise) {
    const float cosine_limit = std::cos(crease_angle);
    std::vector<std::uint8_t> creases(edges.size(), 0);
    CreaseChains chains(positions.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (!is_sharp(edges[i], planes, cosine_limit)) continue;
        creases[i] = 1;
        chains.join(edges[i].v0, edges[i].v1);
    }
    std::vector<ChainSize> sizes(positions.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (!creases[i]) continue;
        ChainSize& size = sizes[chains.root(edges[i].v0)];
        ++size.edges;
        size.length += glm::distance(positions[edges[i].v0], positions[edges[i].v1]);
    }
    const float mesh_size = glm::length(bounds_of(positions).extent());
    const auto is_kept = [&](const ChainSize& chain) {
        if (chain.length >= noise * long_crease * mesh_size) return true;
        return static_cast<float>(chain.edges) >= noise * static_cast<float>(min_crease_edges) &&
               chain.length >= noise * short_crease * mesh_size;
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (creases[i] && !is_kept(sizes[chains.root(edges[i].v0)])) creases[i] = 0;
    }
    return creases;
}

std::vector<std::uint8_t> find_material_edges(std::span<const Edge> edges,
                                              std::span<const std::uint32_t> face_materials) {
    std::vector<std::uint8_t> marks(edges.size(), 0);
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (edges[i].face1 != no_face) marks[i] = face_materials[edges[i].face0] != face_materials[edges[i].face1];
    return marks;
}

std::vector<ChosenEdge> feature_edges(std::span<const Edge> edges, std::span<const std::uint8_t> creases,
                                      std::span<const std::uint8_t> materials) {
    HACHURE_ASSERT(creases.empty() || creases.size() == edges.size(), "one mark per edge");
    HACHURE_ASSERT(materials.empty() || materials.size() == edges.size(), "one mark per edge");
    std::vector<ChosenEdge> features;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::uint32_t kinds = (!creases.empty() && creases[i] != 0 ? line_crease : 0u) |
                                    (!materials.empty() && materials[i] != 0 ? line_material : 0u) |
                                    (edges[i].face1 == no_face ? line_border : 0u);
        if (kinds != 0) features.push_back({static_cast<std::uint32_t>(i), kinds});
    }
    return features;
}

} // namespace hachure::geometry
