#include <hachure/systems/shade_strokes/shade_ribs.h>
#include <hachure/systems/shade_strokes/stroke_amplitude.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hachure {
namespace {

using geometry::WalkPlace;
using geometry::WalkTriangle;

constexpr double facing = 0.0;       // ribs end where the surface turns by 90 degrees
constexpr double least_bend = 2e-5;  // over the model's size: less is straight
constexpr double bend_margin = 0.02; // of a half: there is no bend nearer to its ends

/// One half of a rib.
struct HalfRib {
    SurfacePoint bend, outer;
    double bend_part; ///< of the way to the outer one, in (0, 1)
    double length;
};

/// A place on the way across a chain.
struct Crossed {
    WalkPlace place;
    double length;
};

/// Walks straight across a chain from edge to edge and keeps where it crosses them.
class RibWalk {
public:
    RibWalk(const ShadeMesh& mesh, const WalkPlace& from, const glm::dvec3& across, const glm::dvec3& normal)
        : mesh_(mesh), from_(from), across_(across), normal_(normal), place_(from), direction_(across) {}

    HalfRib walk(double length) {
        while (length_ < length && count_ < crossed_.size() && step(length)) {
        }
        if (length_ < length && count_ == crossed_.size()) // many small triangles: no single edge matters
            length_ += walk_straight(place_, direction_, length - length_);
        const std::size_t bend = farthest_off();
        HalfRib half{{}, mesh_.point(place_.triangle, place_.weight), 0.5, length_};
        if (bend < count_) {
            half.bend = mesh_.point(crossed_[bend].place.triangle, crossed_[bend].place.weight);
            half.bend_part = crossed_[bend].length / length_;
        } else {
            WalkPlace halfway = from_;
            glm::dvec3 direction = across_;
            walk_straight(halfway, direction, 0.5 * length_);
            half.bend = mesh_.point(halfway.triangle, halfway.weight);
        }
        return half;
    }

private:
    double walk_straight(WalkPlace& place, glm::dvec3& direction, double length) const {
        return geometry::walk_straight(mesh_.sheets, place, direction, length, normal_, facing);
    }

    /// To the next edge and over it; false where the rib ends.
    bool step(double most) {
        const WalkTriangle triangle(mesh_.sheets, place_.triangle);
        if (triangle.flat || glm::dot(triangle.normal, normal_) < facing) return false;
        const geometry::WalkStep step = geometry::walk_step(triangle, place_.weight, direction_, most - length_);
        place_.weight = step.weight;
        if (step.edge == geometry::WalkStep::inside) {
            length_ = most;
            return false;
        }
        length_ += step.length;
        std::uint32_t edge = step.edge;
        if (!geometry::cross_edge(mesh_.sheets, place_, edge, direction_)) return false;
        crossed_[count_++] = {place_, length_};
        return true;
    }

    /// The edge that lies farthest off the straight line from begin to end, or `count_` where none does.
    [[nodiscard]] std::size_t farthest_off() const {
        const glm::dvec3 begin = mesh_.at(mesh_.point(from_.triangle, from_.weight));
        const glm::dvec3 way = mesh_.at(mesh_.point(place_.triangle, place_.weight)) - begin;
        const double square = glm::dot(way, way);
        double most = least_bend * least_bend * mesh_.size * mesh_.size;
        std::size_t result = count_;
        for (std::size_t i = 0; i < count_; ++i) {
            const double part = crossed_[i].length / length_;
            if (!(part > bend_margin && part < 1.0 - bend_margin)) continue;
            const WalkPlace& place = crossed_[i].place;
            const glm::dvec3 off = mesh_.at(mesh_.point(place.triangle, place.weight)) - begin;
            const double along = square > 0.0 ? glm::dot(off, way) / square : 0.0;
            const glm::dvec3 aside = off - along * way;
            if (glm::dot(aside, aside) <= most) continue;
            most = glm::dot(aside, aside);
            result = i;
        }
        return result;
    }

    const ShadeMesh& mesh_;
    const WalkPlace from_;
    const glm::dvec3 across_, normal_;
    WalkPlace place_;
    glm::dvec3 direction_;
    double length_ = 0.0;
    std::array<Crossed, 32> crossed_{};
    std::size_t count_ = 0;
};

} // namespace

float shade_amplitude(const ShadeMesh& mesh, const ShadeSettings& settings, const WalkPlace& place) {
    const auto& corner = mesh.sheets.triangles[place.triangle];
    double curvature = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
        curvature += place.weight[static_cast<int>(k)] * double{mesh.directions.curvature[corner[k]]};
    return static_cast<float>(stroke_amplitude(settings, curvature, mesh.size));
}

ShadeNode make_shade_node(const ShadeMesh& mesh, const ShadeSettings& settings, const WalkPlace& place,
                          const glm::dvec3& heading, double along) {
    const WalkTriangle triangle(mesh.sheets, place.triangle);
    const double wanted = shade_amplitude(mesh, settings, place);
    const glm::dvec3 left = triangle.tangent(glm::cross(triangle.normal, heading));
    ShadeNode node{};
    node.rib[2] = mesh.point(place.triangle, place.weight);
    const HalfRib right_half = RibWalk(mesh, place, -left, triangle.normal).walk(wanted);
    const HalfRib left_half = RibWalk(mesh, place, left, triangle.normal).walk(wanted);
    node.rib[0] = right_half.outer;
    node.rib[1] = right_half.bend;
    node.rib[3] = left_half.bend;
    node.rib[4] = left_half.outer;
    node.bend[0] = static_cast<float>(-right_half.bend_part);
    node.bend[1] = static_cast<float>(left_half.bend_part);
    node.amplitude = static_cast<float>(0.5 * (left_half.length + right_half.length));
    node.along = static_cast<float>(along);
    return node;
}

} // namespace hachure
