#include <hachure/runtime/geometry/triangulate.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace hachure::geometry {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon along its dominant axis, counter-clockwise.
std::vector<glm::dvec2> project(std::span<const glm::vec3> corners) {
    glm::dvec3 normal(0.0); // Newell's: robust for corners that are not in one plane
    const glm::dvec3 origin(corners[0]);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double sign = normal[axis] < 0.0 ? -1.0 : 1.0;
    std::vector<glm::dvec2> flat;
    flat.reserve(corners.size());
    for (const glm::vec3& c : corners) flat.emplace_back(sign * c[u], c[v]);
    return flat;
}

/// Whether the fan around corner 0 has only triangles with the winding of the polygon.
bool is_fan(std::span<const glm::dvec2> flat) {
    for (std::size_t i = 1; i + 1 < flat.size(); ++i)
        if (!(cross(flat[0], flat[i], flat[i + 1]) > 0.0)) return false;
    return true;
}

void append_fan(std::uint32_t corners, std::vector<std::uint32_t>& triangles) {
    for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.insert(triangles.end(), {0, i, i + 1});
}

/// Ear clipping on a ring of the corners that are left.
class EarClipper {
public:
    EarClipper(std::span<const glm::dvec2> flat, std::vector<std::uint32_t>& triangles)
        : flat_(flat), triangles_(triangles), left_(static_cast<std::uint32_t>(flat.size())), next_(left_),
          previous_(left_) {
        for (std::uint32_t i = 0; i < left_; ++i) {
            next_[i] = i + 1 == left_ ? 0 : i + 1;
            previous_[i] = i == 0 ? left_ - 1 : i - 1;
            if (!(turn(i) > 0.0)) reflex_.push_back(i);
        }
    }

    /// False when the budget ran out and the rest was cut as a fan.
    bool run() {
        std::uint32_t at = 0, since_cut = 0;
        while (left_ > 3 && budget_ > 0) {
            --budget_;
            // Nothing to cut in a whole round: corners repeat, lie on a line, or the polygon crosses itself.
            const bool stuck = since_cut > left_;
            const bool must = since_cut > 2 * left_;
            if (must || (stuck ? turn(at) >= 0.0 : turn(at) > 0.0 && is_empty(at))) {
                cut(at);
                since_cut = 0;
                at = next_[at]; // going on behind the cut spreads it, and makes fewer slivers than staying
            } else {
                ++since_cut;
            }
            at = next_[at];
        }
        const bool complete = left_ <= 3;
        for (; left_ >= 3; --left_) {
            emit(at);
            next_[previous_[at]] = next_[at];
            previous_[next_[at]] = previous_[at];
            at = next_[at];
        }
        return complete;
    }

private:
    /// Positive where the ring turns left, as it does at the corners of a convex polygon.
    [[nodiscard]] double turn(std::uint32_t i) const { return cross(flat_[previous_[i]], flat_[i], flat_[next_[i]]); }

    /// Whether no reflex corner lies in the triangle at `i`. Corners in the same place as one of its own do not count:
    /// bridges to holes run through a corner twice.
    bool is_empty(std::uint32_t i) {
        const glm::dvec2 a = flat_[previous_[i]], b = flat_[i], c = flat_[next_[i]];
        for (const std::uint32_t r : reflex_) {
            if (budget_ > 0) --budget_;
            const glm::dvec2 p = flat_[r];
            if (p == a || p == b || p == c) continue;
            if (cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0) return false;
        }
        return true;
    }

    void cut(std::uint32_t i) {
        emit(i);
        const std::uint32_t before = previous_[i], after = next_[i];
        next_[before] = after;
        previous_[after] = before;
        --left_;
        // Cutting turns reflex corners beside it convex, never the other way.
        std::erase_if(reflex_,
                      [&](std::uint32_t r) { return r == i || ((r == before || r == after) && turn(r) > 0.0); });
    }

    void emit(std::uint32_t i) { triangles_.insert(triangles_.end(), {previous_[i], i, next_[i]}); }

    std::span<const glm::dvec2> flat_;
    std::vector<std::uint32_t>& triangles_;
    std::uint32_t left_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<std::uint32_t> reflex_;
    std::size_t budget_ = 4'000'000; ///< comparisons: some 10 ms, more than a real outline needs
};

} // namespace

bool triangulate_polygon(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles) {
    if (corners.size() < 3) return true;
    const auto count = static_cast<std::uint32_t>(corners.size());
    if (count == 3) {
        triangles.insert(triangles.end(), {0, 1, 2});
        return true;
    }
    const std::vector<glm::dvec2> flat = project(corners);
    if (is_fan(flat)) {
        append_fan(count, triangles);
        return true;
    }
    if (count > max_concave_corners) {
        append_fan(count, triangles);
        return false;
    }
    return EarClipper(flat, triangles).run();
}

} // namespace hachure::geometry
