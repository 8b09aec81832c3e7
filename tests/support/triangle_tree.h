#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace hachure::test {

/// A triangle of the world that can hide things.
struct WorldTriangle {
    std::array<glm::dvec3, 3> corners;
    bool one_sided = false; ///< not drawn, and hides nothing, where it turns away from the eye
};

/// A tree of boxes over triangles, to ask what lies between two points. In double precision, and plain: references are
/// made with it.
class TriangleTree {
public:
    explicit TriangleTree(std::vector<WorldTriangle> triangles) : triangles_(std::move(triangles)) {
        order_.resize(triangles_.size());
        std::iota(order_.begin(), order_.end(), 0u);
        if (!triangles_.empty()) build(0, static_cast<std::uint32_t>(triangles_.size()));
    }

    /// How far along the way from `eye` to `point` (0 to 1) the first triangle is that hides; at least `until` when
    /// there is none before that. Stops at any hit before `enough`. The triangle `hider` (0 to begin with) is asked
    /// first, and is left as the one that hides: it mostly hides the next point of a line, too.
    [[nodiscard]] double first_hit(const glm::dvec3& eye, const glm::dvec3& point, double until, double enough,
                                   std::uint32_t& hider) const {
        const glm::dvec3 way = point - eye, inverse = 1.0 / way;
        double nearest = until;
        if (hider < triangles_.size()) nearest = std::min(nearest, hit(triangles_[hider], eye, way));
        if (nearest < enough) return nearest;
        std::array<std::uint32_t, 64> pending{};
        std::size_t count = nodes_.empty() ? 0 : 1;
        while (count > 0) {
            const Node& node = nodes_[pending[--count]];
            const glm::dvec3 a = (node.low - eye) * inverse, b = (node.high - eye) * inverse;
            const glm::dvec3 enter = glm::min(a, b), leave = glm::max(a, b);
            if (std::max({enter.x, enter.y, enter.z, 0.0}) > std::min({leave.x, leave.y, leave.z, nearest})) continue;
            if (node.count > 0) {
                for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                    nearest = std::min(nearest, hit(triangles_[order_[i]], eye, way));
                    if (nearest >= enough) continue;
                    hider = order_[i];
                    return nearest;
                }
                continue;
            }
            pending[count++] = node.first;
            pending[count++] = node.second;
        }
        return nearest;
    }

private:
    struct Node {
        glm::dvec3 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};
        std::uint32_t first = 0, second = 0; ///< children, or the first of its triangles
        std::uint32_t count = 0;             ///< of triangles, in a leaf
    };

    static double hit(const WorldTriangle& triangle, const glm::dvec3& eye, const glm::dvec3& way) {
        constexpr double none = std::numeric_limits<double>::max();
        const auto& [a, b, c] = triangle.corners;
        const glm::dvec3 ab = b - a, ac = c - a, across = glm::cross(way, ac);
        const double volume = glm::dot(ab, across);
        if (volume == 0.0 || (triangle.one_sided && volume < 0.0)) return none;
        const glm::dvec3 from = eye - a;
        const double u = glm::dot(from, across) / volume;
        if (u < 0.0 || u > 1.0) return none;
        const glm::dvec3 up = glm::cross(from, ab);
        const double v = glm::dot(way, up) / volume;
        if (v < 0.0 || u + v > 1.0) return none;
        const double t = glm::dot(ac, up) / volume;
        return t > 0.0 ? t : none;
    }

    std::uint32_t build(std::uint32_t first, std::uint32_t end) {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        Node node;
        glm::dvec3 low(node.low), high(node.high);
        for (std::uint32_t i = first; i < end; ++i) {
            for (const glm::dvec3& corner : triangles_[order_[i]].corners) {
                node.low = glm::min(node.low, corner);
                node.high = glm::max(node.high, corner);
            }
            low = glm::min(low, center(order_[i]));
            high = glm::max(high, center(order_[i]));
        }
        // Flat boxes would be missed by rounding.
        const glm::dvec3 margin = 1e-12 * (glm::abs(node.low) + glm::abs(node.high));
        node.low -= margin;
        node.high += margin;
        const glm::dvec3 extent = high - low;
        const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
        if (end - first <= 4) {
            node.first = first;
            node.count = end - first;
        } else {
            const std::uint32_t half = first + (end - first) / 2;
            std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + end,
                             [&](std::uint32_t a, std::uint32_t b) { return center(a)[axis] < center(b)[axis]; });
            node.first = build(first, half);
            node.second = build(half, end);
        }
        nodes_[index] = node;
        return index;
    }

    glm::dvec3 center(std::uint32_t triangle) const {
        const auto& corners = triangles_[triangle].corners;
        return (corners[0] + corners[1] + corners[2]) / 3.0;
    }

    std::vector<WorldTriangle> triangles_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace hachure::test
