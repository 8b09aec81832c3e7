#include <hachure/runtime/geometry/stroke_phase.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace hachure::geometry {
namespace {

constexpr double degrees = std::numbers::pi / 180.0;

/// A curve on an entity, in its axes; the picture shows x and y of what a view makes of it.
using Curve = std::function<glm::dvec3(double)>;

struct Pose {
    double yaw = 0.0, roll = 0.0; ///< degrees, about y and then about z
    double zoom = 1.0;
    glm::dvec2 at{300.0, 200.0};

    [[nodiscard]] glm::dvec2 project(glm::dvec3 p) const {
        const double cy = std::cos(yaw * degrees), sy = std::sin(yaw * degrees);
        const glm::dvec2 turned(cy * p.x + sy * p.z, p.y);
        const double cz = std::cos(roll * degrees), sz = std::sin(roll * degrees);
        return at + zoom * glm::dvec2(cz * turned.x - sz * turned.y, sz * turned.x + cz * turned.y);
    }
};

/// What is seen of a curve between two of its places, and how opaque.
struct Part {
    double begin = 0.0, end = 1.0;
    bool closed = false, backwards = false;
    std::function<double(double)> opacity = [](double) { return 1.0; };
};

class Drawn {
public:
    Drawn(const Curve& curve, const Pose& pose, const Part& part = {}) : part_(part) {
        for (int i = 0; i <= pieces; ++i) {
            const double t = time(i);
            set_.points.push_back({glm::vec2(pose.project(curve(t))), 4.0f, static_cast<float>(part.opacity(t))});
            places_.push_back(glm::vec3(pose.zoom * curve(t)));
            arcs_.push_back(i > 0 ? arcs_.back() + double(glm::distance(set_.points[set_.points.size() - 2].place,
                                                                        set_.points.back().place))
                                  : 0.0);
        }
        if (part.closed) set_.points.back() = set_.points.front();
        Polyline line{.first = 0, .count = pieces + 1, .owner = 1, .length = static_cast<float>(arcs_.back())};
        line.closed = part.closed;
        set_.lines.push_back(line);
        const glm::vec2 origin(pose.at);
        StrokePhaseJob job{.lines = &set_, .places = places_, .origins = std::span(&origin, 1)};
        job.validate();
        job.run();
        phase_ = job.phases[0];
    }

    /// The texture's coordinate for an axis at a place of the curve, as it shows: mirrored at 0, and for loops where
    /// both ways meet.
    [[nodiscard]] double along(double t, int axis) const {
        const double at = std::clamp((t - time(0)) / (time(pieces) - time(0)), 0.0, 1.0) * pieces;
        const auto i = static_cast<std::size_t>(std::min(at, pieces - 1.0));
        const double arc = arcs_[i] + (at - static_cast<double>(i)) * (arcs_[i + 1] - arcs_[i]);
        const double u = arc + double(phase_.ahead[axis]) - double(phase_.fraction[axis]) * arcs_.back();
        if (!part_.closed) return std::abs(u);
        const double d = u - arcs_.back() * std::floor(u / arcs_.back());
        return std::min(d, arcs_.back() - d);
    }
    [[nodiscard]] const StrokePhase& phase() const { return phase_; }
    [[nodiscard]] const Part& part() const { return part_; }

private:
    static constexpr int pieces = 400;
    [[nodiscard]] double time(int i) const {
        return part_.begin + (part_.end - part_.begin) * (part_.backwards ? pieces - i : i) / pieces;
    }

    Part part_;
    PolylineSet set_;
    std::vector<glm::vec3> places_;
    std::vector<double> arcs_;
    StrokePhase phase_;
};

/// How far the texture slides along the curve from one frame to the next, pixels: at its middle, for the axis that
/// counts most, and how much weight goes from axis to axis.
double slip(const Drawn& a, const Drawn& b) {
    const double middle = 0.5 * (std::max(a.part().begin, b.part().begin) + std::min(a.part().end, b.part().end));
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        sum += double(std::min(a.phase().weights[axis], b.phase().weights[axis])) *
               std::abs(a.along(middle, axis) - b.along(middle, axis));
    return sum;
}
double reweighed(const Drawn& a, const Drawn& b) {
    const glm::vec3 change = glm::abs(a.phase().weights - b.phase().weights);
    return 0.5 * double(change.x + change.y + change.z);
}

/// A line of 100 units that turns by so many degrees over its length, on the front of a ball of radius 150, off its
/// middle.
Curve arc_of(double turn) {
    return [=](double t) {
        const double angle = (t - 0.5) * turn * degrees, radius = turn > 0.0 ? 100.0 / (turn * degrees) : 1.0;
        const glm::dvec2 p = turn > 0.0 ? radius * glm::dvec2(std::sin(angle), std::cos(angle) - 1.0)
                                        : glm::dvec2(100.0 * (t - 0.5), 0.0);
        const glm::dvec2 q = glm::dvec2(40.0, 55.0) + p;
        return glm::dvec3(q, std::sqrt(150.0 * 150.0 - std::min(glm::dot(q, q), 22000.0)));
    };
}

TEST(StrokePhase, TexturesMoveTurnAndGrowWithTheirEntity) {
    for (const double turn : {0.0, 40.0, 120.0, 250.0}) {
        const Drawn before(arc_of(turn), {});
        EXPECT_LE(slip(before, {arc_of(turn), {.at = {313.4, 192.1}}}), 1e-3) << turn;
        EXPECT_LE(slip(before, {arc_of(turn), {.roll = 17.0}}), 1e-3) << turn;
        // Seen from elsewhere, a line is shorter; its middle is where it was.
        EXPECT_LE(slip(before, {arc_of(turn), {.yaw = 1.0}}), 0.15) << turn;
        const Drawn larger(arc_of(turn), {.zoom = 2.0});
        for (const double t : {0.1, 0.5, 0.9}) {
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(larger.along(t, axis), 2.0 * before.along(t, axis), 2e-3) << turn;
        }
    }
}

/// Ends that fade may come and go as they like; those that break off may move the texture by less than half of what
/// they do, and hardly at all where the line runs along an axis.
TEST(StrokePhase, EndsThatFlickerDoNotShakeTheTexture) {
    const auto fading = [](double t) { return std::clamp(std::min(t, 1.0 - t) / 0.1, 0.0, 1.0); };
    for (const double turn : {0.0, 20.0, 60.0, 120.0}) {
        for (const auto& [begin, end] : {std::pair(0.02, 1.0), {0.0, 0.98}, {0.02, 0.98}}) {
            const Drawn soft(arc_of(turn), {}, {.opacity = fading});
            EXPECT_LE(slip(soft, {arc_of(turn), {}, {.begin = begin, .end = end, .opacity = fading}}), 0.11) << turn;
            const Drawn hard(arc_of(turn), {});
            EXPECT_LE(slip(hard, {arc_of(turn), {}, {.begin = begin, .end = end}}), turn < 30.0 ? 0.15 : 0.5) << turn;
        }
    }
}

/// Run the other way, nothing changes but the side that is left.
TEST(StrokePhase, DirectionDoesNotMatter) {
    for (const double turn : {0.0, 60.0, 250.0}) {
        const Drawn forward(arc_of(turn), {}), backward(arc_of(turn), {}, {.backwards = true});
        EXPECT_LE(slip(forward, backward), 1e-3) << turn;
        EXPECT_LE(reweighed(forward, backward), 1e-6) << turn;
        EXPECT_NEAR(forward.phase().turn + backward.phase().turn, 1.0f, 1e-4f) << turn;
    }
}

/// Halving the step halves the change: nothing jumps while an entity turns, or a line bends, turns on it or grows.
TEST(StrokePhase, NothingPops) {
    struct Motion {
        const char* name;
        double slip, reweighed; ///< at most, per whole step
        std::function<Drawn(double)> at;
    };
    const std::vector<Motion> motions{
        {"entity turns by a degree", 0.2, 0.01, [](double k) { return Drawn(arc_of(60.0), {.yaw = k - 30.0}); }},
        {"line bends by two degrees", 1.0, 0.03, [](double k) { return Drawn(arc_of(2.0 * k + 1.0), {}); }},
        {"line grows by three pixels", 1.5, 0.02,
         [](double k) { return Drawn(arc_of(80.0), {}, {.end = 0.4 + 0.03 * k}); }},
        {"line turns on its entity by two degrees", 3.0, 0.1,
         [](double k) {
             const double c = std::cos(2.0 * k * degrees), s = std::sin(2.0 * k * degrees);
             return Drawn(
                 [=](double t) { return glm::dvec3(60.0 + 100.0 * c * (t - 0.5), 40.0 + 100.0 * s * (t - 0.5), 90.0); },
                 {});
         }},
    };
    for (const Motion& motion : motions) {
        const auto largest = [&](double step) {
            std::pair<double, double> most(0.0, 0.0);
            for (double k = 0.0; k < 20.0; k += step) {
                const Drawn a = motion.at(k), b = motion.at(k + step);
                most = {std::max(most.first, slip(a, b)), std::max(most.second, reweighed(a, b))};
            }
            return most;
        };
        const auto [whole, whole_weight] = largest(1.0);
        const auto [half, half_weight] = largest(0.5);
        RecordProperty(motion.name, std::to_string(whole) + " px, weights " + std::to_string(whole_weight));
        EXPECT_LE(whole, motion.slip) << motion.name;
        EXPECT_LE(half, 0.6 * whole + 1e-4) << motion.name;
        EXPECT_LE(whole_weight, motion.reweighed) << motion.name;
        EXPECT_LE(half_weight, 0.6 * whole_weight + 1e-5) << motion.name;
    }
}

/// Parts of a straight line along an axis agree with the whole, so that it may split and merge.
TEST(StrokePhase, LinesAlongAnAxisSplitAndMergeWithoutAChange) {
    const Curve curve = [](double t) { return glm::dvec3(200.0 * t - 70.0, 30.0, 40.0); };
    const Drawn whole(curve, {}), left(curve, {}, {.end = 0.45}), right(curve, {}, {.begin = 0.55});
    for (const Drawn* part : {&left, &right}) {
        EXPECT_LE(slip(whole, *part), 1e-3);
        EXPECT_LE(reweighed(whole, *part), 1e-6);
    }
}

TEST(StrokePhase, LoopsHaveNoSeamAndDoNotCareWhereTheyBegin) {
    const Curve loop = [](double t) {
        const double a = 2.0 * std::numbers::pi * t, r = 60.0 + 12.0 * std::cos(3.0 * a + 0.4);
        return glm::dvec3(1.4 * r * std::cos(a), r * std::sin(a), 0.3 * r * std::cos(a));
    };
    const Drawn whole(loop, {}, {.closed = true});
    for (const double from : {0.13, 0.5, 0.77}) {
        const Drawn other([&](double t) { return loop(t + from); }, {}, {.closed = true});
        EXPECT_LE(reweighed(whole, other), 1e-4);
        for (const double t : {0.05, 0.3, 0.6, 0.85})
            EXPECT_NEAR(whole.along(t, 0), other.along(t - from - std::floor(t - from), 0), 0.05) << from << " " << t;
    }
    const Drawn backward(loop, {}, {.closed = true, .backwards = true});
    EXPECT_LE(slip(whole, backward), 0.05);
    EXPECT_NEAR(whole.phase().turn + backward.phase().turn, 1.0f, 1e-4f);
    EXPECT_LE(slip(whole, {loop, {.roll = 20.0, .at = {12.0, 40.0}}, {.closed = true}}), 0.02);
    double last = whole.along(0.0, 0);
    for (int i = 1; i <= 400; ++i) {
        const double next = whole.along(i / 400.0, 0);
        EXPECT_LE(std::abs(next - last), 3.0) << i;
        last = next;
    }
}

} // namespace
} // namespace hachure::geometry
