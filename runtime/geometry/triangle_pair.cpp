#include <hachure/runtime/geometry/orientation.h>
#include <hachure/runtime/geometry/triangle_pair.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>

namespace hachure::geometry {
namespace {

struct End {
    glm::vec3 position;
    std::uint64_t id;
};

/// Up to four ends that a pair can have where points lie on planes and edges meet.
struct Ends {
    std::array<End, 4> end;
    std::size_t count = 0;

    void add(const End& value) { end[count++] = value; }
};

/// A bit for each corner of `a` in front of the plane of `b`. In the plane is behind it; a corner that they share is.
unsigned corners_in_front(const PlacedTriangle& a, const PlacedTriangle& b) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (std::ranges::find(b.place, a.place[k]) != b.place.end()) continue;
        if (orientation(b.position[0], b.position[1], b.position[2], a.position[k]) > 0) bits |= 1u << k;
    }
    return bits;
}

/// How a line from corner k of `a` to the next passes an edge of `b`: 1 or -1. Lines that meet pass as if they were
/// given by their lower places first, so that all triangles at an edge see the same.
int passing(const PlacedTriangle& a, std::size_t k, const PlacedTriangle& b, std::size_t m) {
    std::size_t a0 = k, a1 = (k + 1) % 3, b0 = m, b1 = (m + 1) % 3;
    int turn = 1;
    if (a.place[a0] > a.place[a1]) {
        std::swap(a0, a1);
        turn = -turn;
    }
    if (b.place[b0] > b.place[b1]) {
        std::swap(b0, b1);
        turn = -turn;
    }
    const int side = orientation(a.position[a0], a.position[a1], b.position[b0], b.position[b1]);
    return side < 0 ? -turn : turn;
}

/// Where the edge from corner k of `a`, whose ends are on two sides of the plane of `b`, cuts it; always computed from
/// the edge's lower place.
End cut(const PlacedTriangle& a, std::size_t k, const PlacedTriangle& b) {
    std::size_t from = k, to = (k + 1) % 3;
    if (a.place[from] > a.place[to]) std::swap(from, to);
    const glm::dvec3 p(a.position[from]), q(a.position[to]), origin(b.position[0]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(b.position[1]) - origin, glm::dvec3(b.position[2]) - origin);
    const double dp = glm::dot(normal, p - origin), dq = glm::dot(normal, q - origin);
    const double t = dp == dq ? 0.5 : std::clamp(dp / (dp - dq), 0.0, 1.0);
    return {glm::vec3(glm::mix(p, q, t)), std::uint64_t{1} << 63 | a.edge[k] << 32 | b.face};
}

/// Adds where edges of `a` without the corner `shared` (3 for none) go through `b`.
void add_cuts(const PlacedTriangle& a, unsigned front, std::size_t shared, const PlacedTriangle& b, Ends& ends) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (k == shared || next == shared) continue;
        if (((front >> k) & 1u) == ((front >> next) & 1u)) continue;
        const int side = passing(a, k, b, 0);
        if (side == passing(a, k, b, 1) && side == passing(a, k, b, 2)) ends.add(cut(a, k, b));
    }
}

std::size_t corner_at(const PlacedTriangle& triangle, std::uint32_t place) {
    return static_cast<std::size_t>(std::ranges::find(triangle.place, place) - triangle.place.begin());
}

SurfaceSegment segment_between(const End& start, const End& end, const PlacedTriangle& a, const PlacedTriangle& b) {
    return {.start = start.position,
            .end = end.position,
            .face = a.face,
            .other_face = b.face,
            .start_id = start.id,
            .end_id = end.id};
}

double square(const End& a, const End& b) {
    const glm::dvec3 d = glm::dvec3(a.position) - glm::dvec3(b.position);
    return glm::dot(d, d);
}

/// Triangles with a common corner: from there to where the edge opposite of one of them goes through the other.
std::optional<SurfaceSegment> from_corner(const PlacedTriangle& a, unsigned a_front, const PlacedTriangle& b,
                                          unsigned b_front, std::uint32_t place) {
    Ends ends;
    const std::size_t corner = corner_at(a, place);
    add_cuts(a, a_front, corner, b, ends);
    add_cuts(b, b_front, corner_at(b, place), a, ends);
    if (ends.count == 0) return std::nullopt;
    const End start{a.position[corner], end_at_vertex(place)};
    const End* nearest = &ends.end[0];
    if (ends.count == 2 && square(start, ends.end[1]) < square(start, ends.end[0])) nearest = &ends.end[1];
    return segment_between(start, *nearest, a, b);
}

} // namespace

std::optional<SurfaceSegment> intersection(const PlacedTriangle& a, const PlacedTriangle& b) {
    std::uint32_t shared = 0;
    unsigned shared_count = 0;
    for (const std::uint32_t place : a.place)
        if (std::ranges::find(b.place, place) != b.place.end()) {
            shared = place;
            ++shared_count;
        }
    if (shared_count > 1) return std::nullopt;
    const unsigned a_front = corners_in_front(a, b);
    if (a_front == 0 || (a_front == 7 && shared_count == 0)) return std::nullopt;
    const unsigned b_front = corners_in_front(b, a);
    if (b_front == 0 || (b_front == 7 && shared_count == 0)) return std::nullopt;
    if (shared_count == 1) return from_corner(a, a_front, b, b_front, shared);

    Ends ends;
    add_cuts(a, a_front, 3, b, ends);
    add_cuts(b, b_front, 3, a, ends);
    if (ends.count < 2) return std::nullopt;
    // More than two are several at one place.
    std::size_t first = 0, last = 1;
    for (std::size_t i = 0; i < ends.count; ++i)
        for (std::size_t k = i + 1; k < ends.count; ++k)
            if (square(ends.end[i], ends.end[k]) > square(ends.end[first], ends.end[last])) {
                first = i;
                last = k;
            }
    return segment_between(ends.end[first], ends.end[last], a, b);
}

} // namespace hachure::geometry
