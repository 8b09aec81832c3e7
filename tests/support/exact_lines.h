#pragma once

#include <hachure/components/edge_lines.h>
#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/geometry/creases.h>
#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/view.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "triangle_tree.h"

namespace hachure::test {

/// Where lines of a view are, as points a quarter of a pixel apart at most, in pixels from the picture's lower left
/// corner.
struct ExactLines {
    std::vector<glm::dvec2> seen;    ///< must be drawn
    std::vector<glm::dvec2> allowed; ///< may be drawn: these, and what rounding decides
    double length = 0.0;             ///< of what is seen, pixels
};

/// The silhouettes, creases and borders of the surfaces of a moment, clipped against every triangle in double precision
/// by asking a tree of triangles at each of the points. It takes the mesh's edge table and creases as given, which have
/// tests of their own, and decides anew which edges are silhouettes.
class ExactLineFinder {
public:
    ExactLineFinder(const DrawList& list, const MeshStore& store, double crease_angle)
        : tree_(world_triangles(list, store)) {
        for (const DrawItem& item : list.items) add_edges(store.mesh(item.mesh), item, crease_angle);
    }

    /// A point is seen when nothing lies before it by more than 1e-7 of its distance, which is rounding, and may be
    /// drawn when nothing does by more than 1e-5.
    [[nodiscard]] ExactLines find(const View& view) const {
        ExactLines lines;
        for (const Candidate& edge : edges_)
            if (is_drawn(edge, glm::dvec3(view.eye))) sample(edge, view, lines);
        return lines;
    }

private:
    struct Candidate {
        glm::dvec3 start, end;
        glm::dvec3 normal0{0.0}, normal1{0.0}; ///< of its faces, outwards; 0 where there is none
        bool border = false, crease = false, closed = false;
    };

    static std::vector<WorldTriangle> world_triangles(const DrawList& list, const MeshStore& store) {
        std::vector<WorldTriangle> triangles;
        for (const DrawItem& item : list.items) {
            const SurfaceMesh& mesh = store.mesh(item.mesh);
            const std::span<const glm::vec3> positions = shape_of(item, mesh);
            for (const Submesh& submesh : mesh.submeshes)
                for (std::uint32_t i = submesh.first_index; i < submesh.first_index + submesh.index_count; i += 3) {
                    WorldTriangle triangle{{}, !submesh.material.double_sided};
                    for (std::uint32_t k = 0; k < 3; ++k)
                        triangle.corners[k] = place(item, positions[mesh.indices[i + k]]);
                    if (item.mirrored) std::swap(triangle.corners[1], triangle.corners[2]);
                    triangles.push_back(triangle);
                }
        }
        return triangles;
    }

    /// The corners of the shape that is drawn.
    static std::span<const glm::vec3> shape_of(const DrawItem& item, const SurfaceMesh& mesh) {
        return item.shape.version != 0 ? item.shape.positions : std::span(mesh.positions);
    }

    static glm::dvec3 place(const DrawItem& item, const glm::vec3& p) {
        return glm::dvec3(glm::dmat4(item.world_from_entity) * glm::dvec4(glm::dvec3(p), 1.0));
    }

    static glm::dvec3 normal(const SurfaceMesh& mesh, const DrawItem& item, std::uint32_t face) {
        const auto corner = [&](std::uint32_t k) {
            return place(item, shape_of(item, mesh)[mesh.indices[3 * face + k]]);
        };
        const glm::dvec3 n = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        const double length = glm::length(n);
        return length > 0.0 ? (item.mirrored ? -n : n) / length : glm::dvec3(0.0);
    }

    void add_edges(const SurfaceMesh& mesh, const DrawItem& item, double crease_angle) {
        const geometry::EdgeTable table = geometry::build_edge_table(mesh.positions, mesh.indices);
        std::vector<glm::vec4> planes(mesh.indices.size() / 3);
        geometry::face_planes(mesh.positions, mesh.indices, planes);
        const auto creases =
            geometry::find_creases(mesh.positions, table.edges, planes, static_cast<float>(crease_angle));
        const std::span<const glm::vec3> positions = shape_of(item, mesh); // creases are those of the mesh
        bool closed = true;
        for (const geometry::Edge& edge : table.edges)
            closed = closed && (edge.flags & (geometry::edge_border | geometry::edge_orientation_mismatch)) == 0;
        for (std::size_t i = 0; i < table.edges.size(); ++i) {
            const geometry::Edge& edge = table.edges[i];
            Candidate candidate{place(item, positions[edge.v0]), place(item, positions[edge.v1])};
            candidate.border = edge.face1 == geometry::no_face;
            candidate.crease = creases[i] != 0;
            candidate.closed = closed;
            candidate.normal0 = normal(mesh, item, edge.face0);
            if (!candidate.border) candidate.normal1 = normal(mesh, item, edge.face1);
            if ((edge.flags & geometry::edge_orientation_mismatch) != 0) candidate.normal1 = -candidate.normal1;
            edges_.push_back(candidate);
        }
    }

    static bool is_drawn(const Candidate& edge, const glm::dvec3& eye) {
        if (edge.border) return true;
        const bool front0 = glm::dot(edge.normal0, eye - edge.start) > 0.0,
                   front1 = glm::dot(edge.normal1, eye - edge.start) > 0.0;
        if (front0 != front1) return true;
        return edge.crease && !(edge.closed && !front0 && !front1);
    }

    void sample(const Candidate& edge, const View& view, ExactLines& lines) const {
        const glm::dmat4 clip_from_world(view.clip_from_world);
        const glm::dvec2 viewport(view.width, view.height);
        const glm::dvec4 a = clip_from_world * glm::dvec4(edge.start, 1.0),
                         b = clip_from_world * glm::dvec4(edge.end, 1.0);
        if (a.w <= 0.0 || b.w <= 0.0) return; // the views of this test have everything before them
        const glm::dvec2 p = (glm::dvec2(a) / a.w * 0.5 + 0.5) * viewport,
                         q = (glm::dvec2(b) / b.w * 0.5 + 0.5) * viewport;
        const double length = glm::distance(p, q);
        // A quarter of a pixel apart, and closer on short edges: what is seen of one may be shorter still.
        const int count = std::max(8, static_cast<int>(std::ceil(length * 4.0)));
        const std::size_t first = lines.seen.size();
        const double step = length / count;
        std::uint32_t hider = 0;
        for (int i = 0; i < count; ++i) {
            const double t = (i + 0.5) / count;
            // Even on the screen: the clip w weighs the ends.
            const double s = t * a.w / (t * a.w + (1.0 - t) * b.w);
            const glm::dvec3 world = glm::mix(edge.start, edge.end, s);
            const double hit = tree_.first_hit(glm::dvec3(view.eye), world, 1.0 - 1e-7, 1.0 - 1e-5, hider);
            if (hit >= 1.0 - 1e-5) lines.allowed.push_back(glm::mix(p, q, t));
            if (hit >= 1.0 - 1e-7) lines.seen.push_back(glm::mix(p, q, t));
        }
        lines.length += static_cast<double>(lines.seen.size() - first) * step;
    }

    TriangleTree tree_;
    std::vector<Candidate> edges_;
};

/// How far what is drawn is from where lines are, in pixels; what is farther than `LineDistance::most` counts as that.
struct LineDistance {
    static constexpr double most = 4.0;
    double missing = 0.0;           ///< the farthest point of a line from any drawn pixel
    double extra = 0.0;             ///< the farthest drawn pixel from any line
    std::size_t missing_points = 0; ///< points of lines farther than a pixel from what is drawn
    std::size_t extra_pixels = 0;   ///< drawn pixels farther than a pixel from any line
    std::size_t points = 0, pixels = 0;
    glm::dvec2 worst_missing{0.0}, worst_extra{0.0};

    [[nodiscard]] double hausdorff() const { return std::max(missing, extra); }
};

/// The pixels of a picture and points in it, by pixel, for asking what is nearest.
class PointBins {
public:
    PointBins(int width, int height)
        : width_(width), height_(height), bins_(static_cast<std::size_t>(width * height)) {}

    void add(const glm::dvec2& p) {
        // Points beside the picture count for pixels at its rim.
        const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
        if (x < -4 || y < -4 || x >= width_ + 4 || y >= height_ + 4) return;
        bins_[index(std::clamp(x, 0, width_ - 1), std::clamp(y, 0, height_ - 1))].push_back(p);
    }

    [[nodiscard]] double nearest(const glm::dvec2& p) const {
        constexpr int reach = 5;
        const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
        double best = LineDistance::most * LineDistance::most;
        for (int j = std::max(0, y - reach); j <= std::min(height_ - 1, y + reach); ++j)
            for (int i = std::max(0, x - reach); i <= std::min(width_ - 1, x + reach); ++i)
                for (const glm::dvec2& q : bins_[index(i, j)]) best = std::min(best, glm::dot(q - p, q - p));
        return std::sqrt(best);
    }

private:
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * width_ + x); }

    int width_, height_;
    std::vector<std::vector<glm::dvec2>> bins_;
};

/// Compares the AOV line_layer of lines a pixel wide with where they are. A pixel is drawn when half of it is covered.
inline LineDistance compare_lines(const assets::Image& line_layer, const ExactLines& lines) {
    LineDistance result;
    const int width = line_layer.width, height = line_layer.height;
    PointBins drawn(width, height), allowed(width, height);
    std::vector<glm::dvec2> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (line_layer.f32()[4 * ((height - 1 - y) * width + x) + 3] >= 0.5f) pixels.emplace_back(x + 0.5, y + 0.5);
    for (const glm::dvec2& p : pixels) drawn.add(p);
    for (const glm::dvec2& p : lines.allowed) allowed.add(p);
    result.pixels = pixels.size();
    const glm::dvec2 size(width, height);
    for (const glm::dvec2& p : lines.seen) {
        if (glm::any(glm::lessThan(p, glm::dvec2(0.5))) || glm::any(glm::greaterThan(p, size - 0.5))) continue;
        ++result.points;
        const double distance = drawn.nearest(p);
        result.missing_points += distance > 1.0 ? 1 : 0;
        if (distance > result.missing) result.worst_missing = p;
        result.missing = std::max(result.missing, distance);
    }
    for (const glm::dvec2& p : pixels) {
        const double distance = allowed.nearest(p);
        result.extra_pixels += distance > 1.0 ? 1 : 0;
        if (distance > result.extra) result.worst_extra = p;
        result.extra = std::max(result.extra, distance);
    }
    return result;
}

} // namespace hachure::test
