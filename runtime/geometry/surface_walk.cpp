#include <hachure/runtime/geometry/surface_walk.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hachure::geometry {
namespace {

constexpr double flatness = 1e-6;       // height over the longest edge
constexpr double on_line = 1e-9;        // of a triangle's part: nearer to a line is on it
constexpr double parallel = 1e-6;       // of the fastest weight: a slower one runs along a line (directions are floats)
constexpr std::uint32_t most_flat = 64; // triangles without an area that are passed over in a row
constexpr std::uint32_t most_steps = 65536, most_idle = 16;

/// Weights that are sound whatever rounding did.
glm::dvec3 settled(glm::dvec3 weight) {
    for (int k = 0; k < 3; ++k) weight[k] = std::clamp(weight[k], 0.0, 1.0);
    return weight / (weight[0] + weight[1] + weight[2]);
}

/// Of a triangle without an area that was entered over edge `entered`, the other edge that comes nearest to the place.
std::uint32_t way_out(const WalkTriangle& triangle, std::uint32_t entered, glm::dvec3& weight) {
    const glm::dvec3 point = triangle.at(weight);
    double nearest = std::numeric_limits<double>::infinity();
    std::uint32_t best = (entered + 1) % 3;
    glm::dvec3 there(0.0);
    for (const std::uint32_t edge : {(entered + 1) % 3, (entered + 2) % 3}) {
        const glm::dvec3 a = triangle.corner[edge], along = triangle.corner[(edge + 1) % 3] - a;
        const double square = glm::dot(along, along);
        const double t = square > 0.0 ? std::clamp(glm::dot(point - a, along) / square, 0.0, 1.0) : 0.0;
        const glm::dvec3 off = a + t * along - point;
        if (!(glm::dot(off, off) < nearest)) continue;
        nearest = glm::dot(off, off);
        best = edge;
        there = glm::dvec3(0.0);
        there[edge] = 1.0 - t;
        there[(edge + 1) % 3] = t;
    }
    weight = there;
    return best;
}

} // namespace

WalkTriangle::WalkTriangle(const SurfaceSheets& sheets, std::uint32_t triangle) {
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = sheets.positions[sheets.triangles[triangle][k]];
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 edge = corner[(k + 1) % 3] - corner[k];
        longest = std::max(longest, glm::dot(edge, edge));
    }
    const glm::dvec3 cross = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double length = glm::length(cross);
    flat = !(length > flatness * longest);
    if (!flat) normal = cross / length;
}

glm::dvec3 WalkTriangle::tangent(const glm::dvec3& v) const {
    const glm::dvec3 flattened = v - glm::dot(v, normal) * normal;
    const double length = glm::length(flattened);
    return length > 1e-12 && std::isfinite(length) ? flattened / length : glm::dvec3(0.0);
}

glm::dvec3 WalkTriangle::rates(const glm::dvec3& direction) const {
    if (flat) return glm::dvec3(0.0);
    const glm::dvec3 a = corner[1] - corner[0], b = corner[2] - corner[0];
    const double area = glm::dot(glm::cross(a, b), normal);
    const double u = glm::dot(glm::cross(direction, b), normal) / area;
    const double v = glm::dot(glm::cross(a, direction), normal) / area;
    return {-u - v, u, v};
}

glm::dvec3 WalkTriangle::inward(std::uint32_t k) const {
    const glm::dvec3 across = glm::cross(normal, corner[(k + 1) % 3] - corner[k]);
    return across / glm::length(across);
}

WalkStep walk_step(const WalkTriangle& triangle, const glm::dvec3& weight, const glm::dvec3& direction, double most,
                   std::uint32_t parts) {
    const glm::dvec3 rates = triangle.rates(direction);
    const double n = parts;
    const double slowest = parallel * std::max({std::abs(rates[0]), std::abs(rates[1]), std::abs(rates[2])});
    WalkStep step{weight, most, WalkStep::inside};
    int line = -1; // the corner whose weight meets a line first, and that line
    double at = 0.0;
    for (int k = 0; k < 3; ++k) {
        if (std::abs(rates[k]) <= slowest) continue;
        const double x = weight[k] * n;
        const double target =
            rates[k] < 0.0 ? std::max(std::ceil(x - on_line) - 1.0, 0.0) : std::min(std::floor(x + on_line) + 1.0, n);
        if (rates[k] > 0.0 && target == n) continue; // a corner: another weight is 0 there
        const double length = std::max(0.0, (target / n - weight[k]) / rates[k]);
        if (length > step.length) continue;
        step.length = length;
        line = k;
        at = target / n;
    }
    step.weight += step.length * rates;
    if (line >= 0) step.weight[line] = at;
    if (line >= 0 && at == 0.0) step.edge = static_cast<std::uint32_t>(line + 1) % 3;
    step.weight = settled(step.weight);
    return step;
}

bool cross_edge(const SurfaceSheets& sheets, WalkPlace& place, WalkTriangle& triangle, std::uint32_t& edge,
                glm::dvec3& direction) {
    WalkPlace next = place;
    std::uint32_t over = edge;
    const glm::dvec3 line = triangle.corner[(edge + 1) % 3] - triangle.corner[edge];
    for (std::uint32_t passed = 0; passed < most_flat; ++passed) {
        const std::uint32_t back = sheets.opposite[3 * next.triangle + over];
        if (back == SurfaceSheets::none) return false;
        glm::dvec3 weight(0.0);
        weight[back % 3] = next.weight[(over + 1) % 3];
        weight[(back + 1) % 3] = next.weight[over];
        next = {back / 3, settled(weight)};
        const WalkTriangle to(sheets, next.triangle);
        if (to.flat) {
            over = way_out(to, back % 3, next.weight);
            continue;
        }
        // The part along the edge stays, the part across it goes on into the new triangle.
        const glm::dvec3 entered = to.corner[(back + 1) % 3] - to.corner[back % 3];
        const double lengths = glm::length(line) * glm::length(entered);
        const double along = passed == 0 ? glm::dot(direction, line) / glm::length(line)
                                         : -glm::dot(direction, entered) / glm::length(entered);
        const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
        const glm::dvec3 turned = -along * entered / glm::length(entered) + across * to.inward(back % 3);
        if (!(lengths > 0.0)) return false;
        direction = glm::normalize(turned);
        place = next;
        triangle = to;
        edge = back % 3;
        return true;
    }
    return false;
}

bool cross_edge(const SurfaceSheets& sheets, WalkPlace& place, std::uint32_t& edge, glm::dvec3& direction) {
    WalkTriangle triangle(sheets, place.triangle);
    return cross_edge(sheets, place, triangle, edge, direction);
}

double walk_straight(const SurfaceSheets& sheets, WalkPlace& place, glm::dvec3& direction, double length,
                     const glm::dvec3& normal, double least_cosine) {
    double done = 0.0;
    std::uint32_t idle = 0;
    WalkTriangle triangle(sheets, place.triangle);
    for (std::uint32_t i = 0; i < most_steps && idle < most_idle; ++i) {
        if (triangle.flat || glm::dot(triangle.normal, normal) < least_cosine) return done;
        const WalkStep step = walk_step(triangle, place.weight, direction, length - done);
        place.weight = step.weight;
        done += step.length;
        idle = step.length > 0.0 ? 0 : idle + 1;
        if (step.edge == WalkStep::inside) return length; // exactly, whatever the sum of steps has lost
        std::uint32_t edge = step.edge;
        if (!cross_edge(sheets, place, triangle, edge, direction)) return done;
    }
    return done;
}

} // namespace hachure::geometry
