#include <hachure/runtime/geometry/surface_patch.h>
#include <hachure/runtime/geometry/triangle_frame.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hachure::geometry {
namespace {

constexpr double facing_away = 0.3, facing_along = 0.8; // cosines between which a vertex begins to count
constexpr double least_for_quartic = 20.0, least_for_quadric = 7.0, least_for_paraboloid = 4.0; // weights of vertices
constexpr double least_kept = 0.8; // of the weight that all vertices of a patch would have
static_assert(VertexRings::most_vertices + 130 + PatchPoints::lanes <= PatchPoints::most);

/// Rings that reach beyond the radius.
void gather(std::span<const glm::vec3> positions, const VertexNeighbours& neighbours, std::uint32_t vertex,
            const PatchExtent& extent, VertexRings& rings) {
    rings.start(vertex);
    if (!(extent.radius > 0.0)) return rings.grow(neighbours, extent.rings);
    const auto inside = [&](std::uint32_t other) {
        return glm::distance(positions[vertex], positions[other]) < extent.radius;
    };
    while (rings.grow(neighbours))
        if (std::ranges::none_of(rings.last_ring(), inside)) break;
}

double compatibility(const glm::dvec3& a, const glm::dvec3& b) {
    return std::clamp((glm::dot(a, b) - facing_away) / (facing_along - facing_away), 0.0, 1.0);
}

/// Where a patch is measured from.
struct PatchFrame {
    glm::dvec3 origin, normal;
    Frame tangents;
};

/// The mean normal of the vertex and those around it, which noise turns less than its own; and the frame of its own
/// turned into that plane, so that tensors come out in the frame of the vertex.
PatchFrame frame_around(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                        const VertexRings& rings) {
    const std::uint32_t vertex = rings.vertices()[0];
    const glm::dvec3 own(normals[vertex]);
    glm::dvec3 sum = own;
    for (const std::uint32_t other : rings.first_ring()) sum += glm::dvec3(normals[other]);
    const double length = glm::length(sum);
    const glm::dvec3 normal = length > 0.1 ? sum / length : own;
    return {glm::dvec3(positions[vertex]), normal, turned(frame_of(own), own, normal)};
}

/// Puts the vertices into the frame; returns their unit of length, 0 where there is only one place.
double place(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, const PatchFrame& frame,
             double radius, std::span<const std::uint32_t> vertices, PatchPoints& points) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::dvec3 to = glm::dvec3(positions[vertices[i]]) - frame.origin;
        const double x = glm::dot(to, frame.tangents.u), y = glm::dot(to, frame.tangents.v);
        double weight = compatibility(frame.normal, normals[vertices[i]]);
        if (radius > 0.0) weight *= std::pow(std::max(0.0, 1.0 - glm::dot(to, to) / (radius * radius)), 2);
        points.x[i] = x;
        points.y[i] = y;
        points.z[i] = glm::dot(to, frame.normal);
        points.weight[i] = weight;
        if (weight > 0.0) farthest = std::max(farthest, x * x + y * y);
    }
    points.count = (vertices.size() + PatchPoints::lanes - 1) / PatchPoints::lanes * PatchPoints::lanes;
    for (std::size_t i = vertices.size(); i < points.count; ++i)
        points.x[i] = points.y[i] = points.z[i] = points.weight[i] = 0.0;
    const double unit = std::sqrt(farthest);
    if (!(unit > 0.0)) return 0.0;
    for (std::size_t i = 0; i < points.count; ++i) {
        const double scale = points.weight[i] > 0.0 ? 1.0 / unit : 0.0;
        points.x[i] *= scale;
        points.y[i] *= scale;
        points.z[i] *= scale;
    }
    return unit;
}

/// Whether the surface turns by so much that a paraboloid is none of its kind: on coarse meshes.
bool turns_away(const PatchPoints& points) {
    const auto vertices = std::span(points.weight).first(points.count);
    const double weight = std::accumulate(vertices.begin(), vertices.end(), 0.0);
    return weight < least_kept * static_cast<double>(points.count - (PatchPoints::lanes - 1));
}

/// z = (xx x^2 + 2 xy x y + yy y^2) / 2, through the vertex and along its normal: three unknowns by Cramer's rule.
bool fit_paraboloid(const PatchMoments<2>& sums, PatchFit& fit) {
    const auto xy = [&](std::size_t i, std::size_t j) { return sums.xy[term(4, i, j)]; };
    const glm::dvec3 a(xy(4, 0), xy(3, 1), xy(2, 2)), b(xy(3, 1), xy(2, 2), xy(1, 3)), c(xy(2, 2), xy(1, 3), xy(0, 4));
    const glm::dvec3 right(sums.xyz[term(2, 2, 0)], sums.xyz[term(2, 1, 1)], sums.xyz[term(2, 0, 2)]);
    const glm::dvec3 bc = glm::cross(b, c), ca = glm::cross(c, a), ab = glm::cross(a, b);
    const double determinant = glm::dot(a, bc);
    if (!(determinant > 1e-6 * a.x * b.y * c.z)) return false;
    const glm::dvec3 solution = (bc * right.x + ca * right.y + ab * right.z) / determinant;
    fit = {.x = 0.0,
           .y = 0.0,
           .xx = 2.0 * solution.x,
           .xy = solution.y,
           .yy = 2.0 * solution.z,
           .noise = 0.0,
           .gain = (4.0 * bc.x + 2.0 * ca.y + 4.0 * ab.z) / determinant};
    return true;
}

/// z = k (x^2 + y^2) / 2.
bool fit_sphere(const PatchMoments<2>& sums, PatchFit& fit) {
    const double square = sums.xy[term(4, 4, 0)] + 2.0 * sums.xy[term(4, 2, 2)] + sums.xy[term(4, 0, 4)];
    if (!(square > 0.0)) return false;
    const double k = 2.0 * (sums.xyz[term(2, 2, 0)] + sums.xyz[term(2, 0, 2)]) / square;
    fit = {.x = 0.0, .y = 0.0, .xx = k, .xy = 0.0, .yy = k, .noise = 0.0, .gain = 8.0 / square};
    return true;
}

bool fit_simpler(PatchScratch& scratch, PatchFit& fit) {
    const PatchMoments<2> sums = patch_moments<2>(scratch.points, scratch.powers);
    return (sums.weight >= least_for_quadric && fit_patch<2>(sums, fit)) ||
           (sums.weight >= least_for_paraboloid && fit_paraboloid(sums, fit)) || fit_sphere(sums, fit);
}

/// The fundamental forms of z(x, y) at the origin, in the frame of the plane z = 0 turned into the tangent plane.
SurfaceFit shape(const PatchFit& fit, double unit) {
    const double stretch = std::sqrt(1.0 + fit.x * fit.x + fit.y * fit.y);
    const glm::dvec3 up(0.0, 0.0, 1.0), normal(-fit.x / stretch, -fit.y / stretch, 1.0 / stretch);
    const Frame frame = turned({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, up, normal);
    const auto second = [&](const glm::dvec3& a, const glm::dvec3& b) {
        const double form = fit.xx * a.x * b.x + fit.xy * (a.x * b.y + a.y * b.x) + fit.yy * a.y * b.y;
        return -form / (stretch * unit);
    };
    SurfaceFit result{.e = second(frame.u, frame.u), .f = second(frame.u, frame.v), .g = second(frame.v, frame.v)};
    result.noise = fit.noise * unit * unit;
    result.gain = fit.gain / (unit * unit * unit * unit);
    return std::isfinite(result.e + result.f + result.g + result.noise + result.gain) ? result : SurfaceFit{};
}

} // namespace

SurfaceFit fit_surface(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                       const VertexNeighbours& neighbours, std::uint32_t vertex, const PatchExtent& extent,
                       PatchScratch& scratch) {
    gather(positions, neighbours, vertex, extent, scratch.rings);
    const PatchFrame frame = frame_around(positions, normals, scratch.rings);
    const double unit = place(positions, normals, frame, extent.radius, scratch.rings.vertices(), scratch.points);
    if (!(unit > 0.0)) return {};
    PatchFit fit{};
    if (extent.degree == 4) {
        const PatchMoments<4> sums = patch_moments<4>(scratch.points, scratch.powers);
        if (sums.weight >= least_for_quartic && fit_patch<4>(sums, fit)) {
            SurfaceFit result = shape(fit, unit);
            result.quartic = result.gain > 0.0;
            return result;
        }
        // Fewer vertices than 2 rings of a fine mesh have: nearer ones say more.
        return fit_surface(positions, normals, neighbours, vertex, {.degree = 2, .rings = 2}, scratch);
    }
    if (!(extent.radius > 0.0) && extent.rings > 1 && turns_away(scratch.points))
        return fit_surface(positions, normals, neighbours, vertex, {.degree = 2, .rings = extent.rings - 1}, scratch);
    if (!fit_simpler(scratch, fit)) return {};
    return shape(fit, unit);
}

} // namespace hachure::geometry
