#include <hachure/systems/shade_strokes/half_rib.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hachure {
namespace {

using geometry::WalkPlace;
using geometry::WalkStep;
using geometry::WalkTriangle;

constexpr double facing = 0.0;        // half ribs end where the surface turns by 90 degrees
constexpr double least_bend = 2e-5;   // over the model's size: less is straight
constexpr double bend_margin = 0.002; // of a half rib: there is no bend nearer to its ends
constexpr double no_turn = 0.99995;   // cosine of the angle at an edge that none needs to bend at

/// A place on the way across a chain.
struct Crossed {
    WalkPlace place;
    glm::dvec3 at;
    double length;
    double turn; ///< cosine of the angle by which the surface turns there
};

/// A straight line, to see how far places are off it.
class Line {
public:
    Line(const glm::dvec3& from, const glm::dvec3& to) : from_(from), way_(to - from) {
        const double square = glm::dot(way_, way_);
        by_square_ = square > 0.0 ? 1.0 / square : 0.0;
    }
    [[nodiscard]] double square_off(const glm::dvec3& point) const {
        const glm::dvec3 off = point - from_, aside = off - glm::dot(off, way_) * by_square_ * way_;
        return glm::dot(aside, aside);
    }

private:
    glm::dvec3 from_, way_;
    double by_square_;
};

/// Walks from edge to edge and keeps where it crosses them.
class HalfRibWalk {
public:
    HalfRibWalk(const ShadeMesh& mesh, const WalkPlace& from, const glm::dvec3& across, const HalfRibWish& wish)
        : mesh_(mesh), wish_(wish),
          triangle_(mesh.sheets, from.triangle), begin_{from, triangle_.at(from.weight), 0.0, 1.0}, across_(across),
          normal_(triangle_.normal), place_(from), direction_(across) {}

    HalfRib walk() {
        while (length_ < wish_.length && count_ < crossed_.size() && step()) {
        }
        if (length_ < wish_.length && count_ == crossed_.size()) // many small triangles: no single edge matters
            length_ += walk_straight(place_, direction_, wish_.length - length_);
        Crossed outer{place_, WalkTriangle(mesh_.sheets, place_.triangle).at(place_.weight), length_, 1.0};
        bool ends = length_ < wish_.length;
        if (deviation(count_, outer) > wish_.deviation) {
            count_ = most_edges();
            outer = crossed_[count_];
            ends = false;
        }
        HalfRib half{{}, point(outer.place), 0.5, outer.length, ends};
        if (!(outer.length > 0.0)) { // it ends where it begins
            half.bend = half.outer;
        } else if (const std::size_t bend = bend_at(count_, outer); bend < count_) {
            half.bend = point(crossed_[bend].place);
            half.bend_part = std::clamp(crossed_[bend].length / outer.length, bend_margin, 1.0 - bend_margin);
        } else {
            WalkPlace halfway = begin_.place;
            glm::dvec3 direction = across_;
            walk_straight(halfway, direction, 0.5 * outer.length);
            half.bend = point(halfway);
        }
        return half;
    }

private:
    [[nodiscard]] SurfacePoint point(const WalkPlace& place) const { return mesh_.point(place.triangle, place.weight); }

    double walk_straight(WalkPlace& place, glm::dvec3& direction, double length) const {
        return geometry::walk_straight(mesh_.sheets, place, direction, length, normal_, facing);
    }

    /// To the next edge and over it; false where the rib ends.
    bool step() {
        if (triangle_.flat || glm::dot(triangle_.normal, normal_) < facing) return false;
        const WalkStep step = geometry::walk_step(triangle_, place_.weight, direction_, wish_.length - length_);
        place_.weight = step.weight;
        if (step.edge == WalkStep::inside) {
            length_ = wish_.length;
            return false;
        }
        length_ += step.length;
        std::uint32_t edge = step.edge;
        const glm::dvec3 before = triangle_.normal;
        if (!geometry::cross_edge(mesh_.sheets, place_, triangle_, edge, direction_)) return false;
        crossed_[count_++] = {place_, triangle_.at(place_.weight), length_, glm::dot(before, triangle_.normal)};
        return true;
    }

    /// Of the first `count` edges that which the half rib bends at if it ends at `outer`: the one farthest off a
    /// straight line; or where none is, the sharpest, since ribs beside this one may bend at it; or `count`.
    [[nodiscard]] std::size_t bend_at(std::size_t count, const Crossed& outer) const {
        const Line line(begin_.at, outer.at);
        double most = least_bend * mesh_.size * least_bend * mesh_.size, least = no_turn;
        std::size_t farthest = count, sharpest = count;
        for (std::size_t i = 0; i < count; ++i) {
            const double part = crossed_[i].length / outer.length;
            const double off = line.square_off(crossed_[i].at);
            if (off > most && part > bend_margin && part < 1.0 - bend_margin) {
                most = off;
                farthest = i;
            }
            if (crossed_[i].turn < least) {
                least = crossed_[i].turn;
                sharpest = i;
            }
        }
        return farthest < count ? farthest : sharpest;
    }

    /// How far the first `count` edges lie off the two pieces if the half rib ends at `outer`.
    [[nodiscard]] double deviation(std::size_t count, const Crossed& outer) const {
        const std::size_t bend = bend_at(count, outer);
        const Crossed& middle = bend < count ? crossed_[bend] : outer;
        const Line first(begin_.at, middle.at), second(middle.at, outer.at);
        double most = 0.0;
        for (std::size_t i = 0; i < count; ++i)
            most = std::max(most, (i <= bend ? first : second).square_off(crossed_[i].at));
        return std::sqrt(most);
    }

    /// Up to which edge two pieces can follow the surface: at least to the second.
    [[nodiscard]] std::size_t most_edges() const {
        std::size_t fits = 1, too_many = count_;
        while (too_many - fits > 1) {
            const std::size_t middle = (fits + too_many) / 2;
            (deviation(middle, crossed_[middle]) > wish_.deviation ? too_many : fits) = middle;
        }
        return fits;
    }

    const ShadeMesh& mesh_;
    const HalfRibWish wish_;
    WalkTriangle triangle_; ///< of `place_`
    const Crossed begin_;
    const glm::dvec3 across_, normal_;
    WalkPlace place_;
    glm::dvec3 direction_;
    double length_ = 0.0;
    std::array<Crossed, 128> crossed_;
    std::size_t count_ = 0;
};

} // namespace

HalfRib walk_half_rib(const ShadeMesh& mesh, const WalkPlace& from, const glm::dvec3& across, const HalfRibWish& wish) {
    return HalfRibWalk(mesh, from, across, wish).walk();
}

} // namespace hachure
