#include <hachure/runtime/animation/key_search.h>
#include <hachure/runtime/animation/smooth_path.h>
#include <hachure/runtime/assert.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>

namespace hachure::animation {
namespace {

/// A cubic Hermite spline at `u` of the way, its tangents for the whole way.
template <class Value> Value hermite(const Value& from, const Value& out, const Value& to, const Value& in, double u) {
    const double v = 1.0 - u;
    return from * ((1.0 + 2.0 * u) * v * v) + out * (u * v * v) + to * (u * u * (3.0 - 2.0 * u)) - in * (u * u * v);
}

/// Where the curve goes at a point inside, by its parameter: that of the parabola through it and its neighbours.
glm::dvec3 tangent_inside(const SmoothPath& path, std::size_t k) {
    const double before = path.knots[k] - path.knots[k - 1], after = path.knots[k + 1] - path.knots[k];
    const glm::dvec3 behind = path.points[k] - path.points[k - 1], ahead = path.points[k + 1] - path.points[k];
    // Where the path stands still on one side, the other alone says where it goes.
    if (before == 0.0 || after == 0.0) return after > 0.0 ? ahead / after : before > 0.0 ? behind / before : ahead;
    return (behind / before * after + ahead / after * before) / (before + after);
}

/// At an end: the curve has no curvature's change there, as the parabola through both points with the other's tangent.
glm::dvec3 tangent_at_end(const SmoothPath& path, std::size_t end, std::size_t inside) {
    const double length = path.knots[inside] - path.knots[end];
    if (length == 0.0) return glm::dvec3(0.0);
    const glm::dvec3 straight = (path.points[inside] - path.points[end]) / length;
    return path.points.size() == 2 ? straight : 2.0 * straight - path.tangents[inside];
}

void make_tangents(SmoothPath& path) {
    const std::size_t n = path.points.size();
    path.tangents.assign(n, glm::dvec3(0.0));
    if (n == 1) return;
    for (std::size_t k = 1; k + 1 < n; ++k) path.tangents[k] = tangent_inside(path, k);
    path.tangents.front() = tangent_at_end(path, 0, 1);
    path.tangents.back() = tangent_at_end(path, n - 1, n - 2);
}

/// Fritsch and Carlson's: the harmonic mean of both sides' speeds, so that the parameter never turns back.
void make_rates(SmoothPath& path) {
    const std::size_t n = path.points.size();
    path.rates.assign(n, 0.0);
    if (n == 1) return;
    const auto speed = [&](std::size_t k) {
        return (path.knots[k + 1] - path.knots[k]) / (path.times[k + 1] - path.times[k]);
    };
    path.rates.front() = speed(0);
    path.rates.back() = speed(n - 2);
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const double a = speed(k - 1), b = speed(k);
        path.rates[k] = a > 0.0 && b > 0.0 ? 2.0 * a * b / (a + b) : 0.0;
    }
}

} // namespace

SmoothPath make_path(std::span<const PathPoint> points) {
    HACHURE_ASSERT(!points.empty(), "a path has a point");
    SmoothPath path;
    for (std::size_t k = 0; k < points.size(); ++k) {
        HACHURE_ASSERT(k == 0 || points[k - 1].time < points[k].time, "times of a path ascend");
        path.times.push_back(points[k].time);
        path.points.push_back(points[k].place);
        path.knots.push_back(
            k == 0 ? 0.0 : path.knots.back() + std::sqrt(glm::length(points[k].place - points[k - 1].place)));
    }
    make_tangents(path);
    make_rates(path);
    return path;
}

glm::dvec3 place_on(const SmoothPath& path, double time, std::uint32_t& cursor) {
    const std::uint32_t k = cursor = KeySearch(std::span<const double>(path.times), time).from(cursor);
    if (time <= path.times[k] || k + 1 == path.times.size()) return path.points[k];
    const double seconds = path.times[k + 1] - path.times[k], length = path.knots[k + 1] - path.knots[k];
    if (length == 0.0) return path.points[k];
    const double u =
        hermite(0.0, path.rates[k] * seconds, length, path.rates[k + 1] * seconds, (time - path.times[k]) / seconds) /
        length;
    return hermite(path.points[k], path.tangents[k] * length, path.points[k + 1], path.tangents[k + 1] * length, u);
}

} // namespace hachure::animation
