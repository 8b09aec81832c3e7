#include <hachure/runtime/geometry/surface_sheets.h>
#include <hachure/runtime/geometry/topology.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace hachure::geometry {
namespace {

constexpr double shared_normal_cosine = 0.999; // 2.6 degrees
constexpr std::size_t most_uses = 64;          // of an edge that is looked at: pairs are their square

/// A pair of half-edges that could be the two sides of one edge.
struct Pair {
    double cosine; ///< between the normals of the faces
    std::uint32_t forward, backward;
};

/// What pairing needs to know of the input.
struct Input {
    std::span<const glm::vec3> normals;
    std::span<const std::uint32_t> indices;
    double crease_cosine;
    std::vector<glm::dvec3> face_normals; ///< unit, or 0 without an area; per triangle of the sheets
};

double cosine_between(const glm::dvec3& a, const glm::dvec3& b) {
    // A triangle without an area bends nothing.
    return glm::dot(a, a) > 0.0 && glm::dot(b, b) > 0.0 ? glm::dot(a, b) : 1.0;
}

/// Whether the normals of two corners at one place are to be seen as one.
bool share_normal(const Input& input, std::uint32_t corner_a, std::uint32_t corner_b) {
    const std::uint32_t a = input.indices[corner_a], b = input.indices[corner_b];
    return a == b || glm::dot(glm::dvec3(input.normals[a]), glm::dvec3(input.normals[b])) > shared_normal_cosine;
}

/// The corner of the input that half-edge h leaves.
std::uint32_t input_corner(const SurfaceSheets& sheets, std::uint32_t h) { return 3 * sheets.face[h / 3] + h % 3; }

bool is_hard(const Input& input, const SurfaceSheets& sheets, const Pair& pair) {
    if (pair.cosine >= input.crease_cosine) return false;
    if (input.normals.empty()) return true;
    const std::uint32_t a = pair.forward, b = pair.backward;
    const auto corner = [&](std::uint32_t h) { return input_corner(sheets, h); };
    return !share_normal(input, corner(a), corner(SurfaceSheets::next(b))) &&
           !share_normal(input, corner(SurfaceSheets::next(a)), corner(b));
}

/// Joins the sides of one edge, the flattest pairs first.
void pair_edge(const Input& input, std::span<const EdgeUse> uses, std::span<const std::uint32_t> triangle_of,
               SurfaceSheets& sheets) {
    if (uses.size() > most_uses) return;
    std::vector<Pair> pairs;
    const auto half_edge = [&](const EdgeUse& use) { return 3 * triangle_of[use.face()] + use.corner % 3; };
    for (const EdgeUse& a : uses) {
        if (a.backward != 0) continue;
        for (const EdgeUse& b : uses) {
            if (b.backward == 0) continue;
            const std::uint32_t forward = half_edge(a), backward = half_edge(b);
            pairs.push_back(
                {cosine_between(input.face_normals[forward / 3], input.face_normals[backward / 3]), forward, backward});
        }
    }
    std::ranges::stable_sort(pairs, [](const Pair& a, const Pair& b) { return a.cosine > b.cosine; });
    for (const Pair& pair : pairs) {
        if (sheets.opposite[pair.forward] != SurfaceSheets::none) continue;
        if (sheets.opposite[pair.backward] != SurfaceSheets::none) continue;
        if (is_hard(input, sheets, pair)) continue;
        sheets.opposite[pair.forward] = pair.backward;
        sheets.opposite[pair.backward] = pair.forward;
    }
}

/// A vertex for every set of corners that hang together through edges.
void make_vertices(std::span<const glm::vec3> positions, const WeldedTriangles& welded, SurfaceSheets& sheets) {
    const auto corners = static_cast<std::uint32_t>(3 * sheets.triangles.size());
    UnionFind fans(corners);
    for (std::uint32_t h = 0; h < corners; ++h) {
        const std::uint32_t other = sheets.opposite[h];
        if (other == SurfaceSheets::none) continue;
        fans.join(h, SurfaceSheets::next(other));
        fans.join(SurfaceSheets::next(h), other);
    }
    std::vector<std::uint32_t> vertex_of(corners, SurfaceSheets::none);
    for (std::uint32_t h = 0; h < corners; ++h) {
        const std::uint32_t root = fans.find(h);
        if (root == h) {
            vertex_of[h] = static_cast<std::uint32_t>(sheets.positions.size());
            sheets.positions.emplace_back(positions[welded.corners[sheets.face[h / 3]][h % 3]]);
            sheets.out.push_back(h);
        }
        const std::uint32_t vertex = vertex_of[root];
        sheets.triangles[h / 3][h % 3] = vertex;
        if (sheets.opposite[h] == SurfaceSheets::none) sheets.out[vertex] = h;
    }
}

void number_sheets(SurfaceSheets& sheets) {
    UnionFind connected(sheets.positions.size());
    for (const auto& t : sheets.triangles) {
        connected.join(t[0], t[1]);
        connected.join(t[0], t[2]);
    }
    sheets.sheet.resize(sheets.positions.size());
    for (std::uint32_t v = 0; v < sheets.sheet.size(); ++v) {
        const std::uint32_t root = connected.find(v);
        sheets.sheet[v] = root == v ? sheets.sheets++ : sheets.sheet[root];
    }
}

/// Sends repeated triangles to the first on the same places.
void find_copies(const WeldedTriangles& welded, std::span<const std::uint32_t> indices, SurfaceSheets& sheets) {
    const auto key = [](std::array<std::uint32_t, 3> c) {
        while (c[0] > c[1] || c[0] > c[2]) std::rotate(c.begin(), c.begin() + 1, c.end());
        return c;
    };
    if (welded.duplicate == 0) return;
    std::map<std::array<std::uint32_t, 3>, std::uint32_t> first;
    for (std::uint32_t t = 0; t < sheets.triangles.size(); ++t) first.emplace(key(welded.corners[sheets.face[t]]), t);
    for (std::size_t f = 0; f < sheets.triangle_of.size(); ++f) {
        if (welded.kept(f)) continue;
        const std::array places{welded.weld[indices[3 * f]], welded.weld[indices[3 * f + 1]],
                                welded.weld[indices[3 * f + 2]]};
        if (const auto found = first.find(key(places)); found != first.end()) sheets.triangle_of[f] = found->second;
    }
}

} // namespace

SurfaceSheets cut_into_sheets(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                              std::span<const std::uint32_t> indices, double crease_angle) {
    const WeldedTriangles welded = weld_triangles(positions, indices, Backs::keep);
    SurfaceSheets sheets;
    Input input{.normals = normals, .indices = indices, .crease_cosine = std::cos(crease_angle), .face_normals = {}};
    sheets.triangle_of.assign(indices.size() / 3, SurfaceSheets::none);
    for (std::uint32_t f = 0; f < sheets.triangle_of.size(); ++f) {
        if (!welded.kept(f)) continue;
        sheets.triangle_of[f] = static_cast<std::uint32_t>(sheets.triangles.size());
        sheets.triangles.emplace_back();
        sheets.face.push_back(f);
        const auto& c = welded.corners[f];
        const glm::dvec3 p0(positions[c[0]]), p1(positions[c[1]]), p2(positions[c[2]]);
        const glm::dvec3 cross = glm::cross(p1 - p0, p2 - p0);
        const double length = glm::length(cross);
        const bool flat = is_sliver(positions[c[0]], positions[c[1]], positions[c[2]]) || !(length > 0.0);
        input.face_normals.push_back(flat ? glm::dvec3(0.0) : cross / length);
    }
    sheets.opposite.assign(3 * sheets.triangles.size(), SurfaceSheets::none);
    EdgeUses(welded).each_edge(
        [&](std::uint32_t, std::span<const EdgeUse> uses) { pair_edge(input, uses, sheets.triangle_of, sheets); });
    make_vertices(positions, welded, sheets);
    number_sheets(sheets);
    find_copies(welded, indices, sheets);
    return sheets;
}

} // namespace hachure::geometry
