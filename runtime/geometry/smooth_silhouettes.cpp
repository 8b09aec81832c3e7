#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/smooth_silhouettes.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace hachure::geometry {
namespace {

/// Where g is zero on the edge between two vertices of different sides, always computed from the lower one.
glm::vec3 crossing(const SmoothSilhouettesJob& job, std::uint32_t a, std::uint32_t b, float ga, float gb) {
    if (a > b) {
        std::swap(a, b);
        std::swap(ga, gb);
    }
    const double t = static_cast<double>(ga) / (static_cast<double>(ga) - static_cast<double>(gb));
    return {glm::mix(glm::dvec3(job.positions[a]), glm::dvec3(job.positions[b]), t)};
}

void add_triangle(SmoothSilhouettesJob& job, std::uint32_t face) {
    std::uint32_t v[3];
    float g[3];
    for (std::size_t k = 0; k < 3; ++k) {
        v[k] = job.weld[job.indices[3 * face + k]];
        g[k] = glm::dot(job.planes[v[k]], job.eye);
    }
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) return;
    const unsigned fronts = (g[0] > 0.0f ? 1u : 0u) + (g[1] > 0.0f ? 1u : 0u) + (g[2] > 0.0f ? 1u : 0u);
    if (fronts == 0 || fronts == 3) return;
    // The corner that is alone on its side; the line cuts its two edges.
    std::size_t alone = 0;
    while ((g[alone] > 0.0f) != (fronts == 1)) ++alone;
    const std::size_t next = (alone + 1) % 3, last = (alone + 2) % 3;
    SurfaceSegment segment{.start = crossing(job, v[alone], v[last], g[alone], g[last]),
                           .end = crossing(job, v[alone], v[next], g[alone], g[next]),
                           .face = face,
                           .start_id = end_on_edge(std::min(v[alone], v[last]), std::max(v[alone], v[last])),
                           .end_id = end_on_edge(std::min(v[alone], v[next]), std::max(v[alone], v[next]))};
    // From edge (last, alone) to edge (alone, next), counter-clockwise triangles have the corner to their right.
    if (fronts == 1) {
        std::swap(segment.start, segment.end);
        std::swap(segment.start_id, segment.end_id);
    }
    job.segments.push_back(segment);
}

/// The triangles found lie anywhere in memory, and so do their corners: each step towards these is asked for some
/// triangles before it is needed.
void prefetch_ahead(const SmoothSilhouettesJob& job, std::size_t i) {
    const auto corner = [&](std::size_t ahead, std::size_t k) -> const std::uint32_t& {
        return job.indices[3 * static_cast<std::size_t>(job.faces[i + ahead]) + k];
    };
    constexpr std::size_t step = 8;
    if (i + 3 * step < job.faces.size()) __builtin_prefetch(&corner(3 * step, 0));
    if (i + 2 * step < job.faces.size())
        for (std::size_t k = 0; k < 3; ++k) __builtin_prefetch(&job.weld[corner(2 * step, k)]);
    if (i + step < job.faces.size())
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = job.weld[corner(step, k)];
            __builtin_prefetch(&job.planes[vertex]);
            __builtin_prefetch(&job.positions[vertex]);
        }
}

} // namespace

void vertex_planes(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                   std::span<glm::vec4> planes) {
    HACHURE_ASSERT(normals.size() == positions.size() && planes.size() == positions.size(), "one element per vertex");
    for (std::size_t v = 0; v < positions.size(); ++v)
        planes[v] = {normals[v], static_cast<float>(-glm::dot(glm::dvec3(normals[v]), glm::dvec3(positions[v])))};
}

void SmoothSilhouettesJob::validate() const {
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    HACHURE_ASSERT(weld.size() == positions.size() && planes.size() == positions.size(), "one element per vertex");
    const auto in_range = [&](std::uint32_t i) { return i < positions.size(); };
    HACHURE_ASSERT(std::ranges::all_of(indices, in_range) && std::ranges::all_of(weld, in_range),
                   "indices must be in range");
    HACHURE_ASSERT(tree == nullptr || (tree->per_item() == 3 && 3 * tree->size() == indices.size()),
                   "the tree of these triangles");
}

void SmoothSilhouettesJob::run() {
    segments.clear();
    if (tree != nullptr) {
        faces.clear();
        tree->query(eye, scratch, [this](std::uint32_t face, bool) { faces.push_back(face); });
        for (std::size_t i = 0; i < faces.size(); ++i) {
            prefetch_ahead(*this, i);
            add_triangle(*this, faces[i]);
        }
    } else {
        for (std::uint32_t face = 0; face < indices.size() / 3; ++face) add_triangle(*this, face);
    }
}

PlaneTree smooth_silhouette_tree(std::span<const glm::vec4> planes, std::span<const std::uint32_t> indices,
                                 std::span<const std::uint32_t> weld) {
    std::vector<std::uint32_t> items(indices.size());
    for (std::size_t c = 0; c < indices.size(); ++c) items[c] = weld[indices[c]];
    for (std::size_t f = 0; f < items.size(); f += 3)
        if (items[f] == items[f + 1] || items[f + 1] == items[f + 2] || items[f + 2] == items[f])
            items[f + 2] = PlaneTree::left_out;
    return {planes, items, 3};
}

} // namespace hachure::geometry
