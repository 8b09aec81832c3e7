#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/suggestive_contours.h>
#include <hachure/runtime/parallel.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace hachure::geometry {
namespace {

using Radial = SuggestiveContoursJob::Radial;

Radial radial_of(const SuggestiveContoursJob& job, std::size_t vertex) {
    const glm::vec3 view = glm::vec3(job.eye) - job.eye.w * job.positions[vertex];
    const glm::vec3 normal = job.normals[vertex], first = job.directions[vertex];
    const float u = glm::dot(view, first), v = glm::dot(view, glm::cross(normal, first));
    const float k1 = job.curvatures[vertex].x, k2 = job.curvatures[vertex].y;
    const glm::vec4& c = job.derivatives[vertex];
    const float along = u * u + v * v, view_square = glm::dot(view, view);
    if (!(view_square > 0.0f)) return {0.0f, 0.0f, 0.0f};
    const float inverse = 1.0f / view_square, inverse_length = std::sqrt(inverse);
    const float cosine = glm::dot(view, normal) * inverse_length;
    const float inverse_along = along > 0.0f ? 1.0f / along : 0.0f;
    const float cubic = u * u * (u * c.x + 3.0f * v * c.y) + v * v * (3.0f * u * c.z + v * c.w);
    const float torsion = (k2 - k1) * u * v * inverse_along;
    return {(k1 * u * u + k2 * v * v) * inverse,
            cubic * inverse_along * inverse_length - 2.0f * cosine * torsion * torsion, cosine};
}

/// Where a line crosses an edge.
struct Crossing {
    glm::dvec3 position;
    double derivative, cosine;
    std::uint64_t id;
};

Crossing crossing(const SuggestiveContoursJob& job, std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const Radial &ra = job.radial[a], &rb = job.radial[b];
    const double ka = ra.curvature, kb = rb.curvature, t = ka / (ka - kb);
    return {glm::mix(glm::dvec3(job.positions[a]), glm::dvec3(job.positions[b]), t),
            glm::mix(static_cast<double>(ra.derivative), static_cast<double>(rb.derivative), t),
            glm::mix(static_cast<double>(ra.cosine), static_cast<double>(rb.cosine), t), end_on_edge(a, b)};
}

/// What the options say in the units of Crossing.
struct Limits {
    double derivative, derivative_fade, angle, angle_fade, cosine;

    explicit Limits(const SuggestiveOptions& options) {
        const double unit = 1.0 / (static_cast<double>(options.size) * static_cast<double>(options.size));
        derivative = static_cast<double>(options.derivative) * unit;
        derivative_fade = static_cast<double>(options.derivative_fade) * unit;
        angle = static_cast<double>(options.angle);
        angle_fade = static_cast<double>(options.angle_fade);
        cosine = std::cos(angle);
    }

    [[nodiscard]] float weight(const Crossing& at) const {
        const auto rise = [](double above, double range) {
            return range > 0.0 ? std::clamp(above / range, 0.0, 1.0) : above >= 0.0 ? 1.0 : 0.0;
        };
        const double from_front = std::acos(std::clamp(at.cosine, -1.0, 1.0)) - angle;
        return static_cast<float>(rise(at.derivative - derivative, derivative_fade) * rise(from_front, angle_fade));
    }

    /// The part of a segment, from 0 to 1, where lines are drawn at all: all three quantities are linear along it.
    [[nodiscard]] std::pair<double, double> drawn(const Crossing& a, const Crossing& b) const {
        double from = 0.0, to = 1.0;
        const auto keep_positive = [&](double at_a, double at_b) {
            if (at_a <= 0.0 && at_b <= 0.0) to = -1.0;
            if ((at_a > 0.0) == (at_b > 0.0)) return;
            const double t = at_a / (at_a - at_b);
            if (at_a > 0.0)
                to = std::min(to, t);
            else
                from = std::max(from, t);
        };
        keep_positive(a.derivative - derivative, b.derivative - derivative);
        keep_positive(a.cosine, b.cosine);
        keep_positive(cosine - a.cosine, cosine - b.cosine);
        return {from, to};
    }
};

Crossing between(const Crossing& a, const Crossing& b, double t) {
    return {glm::mix(a.position, b.position, t), glm::mix(a.derivative, b.derivative, t),
            glm::mix(a.cosine, b.cosine, t), free_end};
}

void add_triangle(SuggestiveContoursJob& job, const Limits& limits, std::uint32_t face) {
    std::uint32_t v[3];
    bool above[3];
    for (std::size_t k = 0; k < 3; ++k) {
        v[k] = job.weld[job.indices[3 * face + k]];
        above[k] = job.radial[v[k]].curvature > 0.0f;
    }
    if (above[0] == above[1] && above[1] == above[2]) return;
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) return;
    const std::size_t alone = above[1] == above[2] ? 0 : above[2] == above[0] ? 1 : 2;
    const Crossing a = crossing(job, v[alone], v[(alone + 1) % 3]), b = crossing(job, v[alone], v[(alone + 2) % 3]);
    const auto [from, to] = limits.drawn(a, b);
    if (!(from < to)) return;
    const Crossing start = from > 0.0 ? between(a, b, from) : a, end = to < 1.0 ? between(a, b, to) : b;
    job.segments.push_back({.start = glm::vec3(start.position),
                            .end = glm::vec3(end.position),
                            .start_weight = limits.weight(start),
                            .end_weight = limits.weight(end),
                            .face = face,
                            .start_id = start.id,
                            .end_id = end.id});
}

} // namespace

void SuggestiveContoursJob::validate() const {
    HACHURE_ASSERT(indices.size() % 3 == 0, "three indices per triangle");
    for (const std::size_t size :
         {normals.size(), weld.size(), curvatures.size(), directions.size(), derivatives.size()})
        HACHURE_ASSERT(size == positions.size(), "one element per vertex");
    const auto in_range = [&](std::uint32_t i) { return i < positions.size(); };
    HACHURE_ASSERT(std::ranges::all_of(indices, in_range) && std::ranges::all_of(weld, in_range),
                   "indices must be in range");
    HACHURE_ASSERT(std::ranges::all_of(candidates, [&](std::uint32_t f) { return f < indices.size() / 3; }),
                   "candidates are triangles");
    HACHURE_ASSERT(options.size > 0.0f, "a size");
}

void SuggestiveContoursJob::run() {
    radial.resize(positions.size());
    constexpr std::size_t chunk = 16384;
    parallel_for((positions.size() + chunk - 1) / chunk, [this](std::size_t task) {
        for (std::size_t v = task * chunk; v < std::min(positions.size(), (task + 1) * chunk); ++v)
            radial[v] = radial_of(*this, v);
    });
    segments.clear();
    const Limits limits(options);
    if (!candidates.empty())
        for (const std::uint32_t face : candidates) add_triangle(*this, limits, face);
    else
        for (std::uint32_t face = 0; face < indices.size() / 3; ++face) add_triangle(*this, limits, face);
}

std::vector<std::uint32_t> suggestive_candidates(std::span<const std::uint32_t> indices,
                                                 std::span<const std::uint32_t> weld,
                                                 std::span<const glm::vec2> curvatures) {
    std::vector<std::uint32_t> faces;
    for (std::uint32_t face = 0; face < indices.size() / 3; ++face) {
        int convex = 0, concave = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec2& c = curvatures[weld[indices[3 * face + k]]];
            convex += c.x > 0.0f && c.y > 0.0f ? 1 : 0;
            concave += c.x <= 0.0f && c.y <= 0.0f ? 1 : 0;
        }
        if (convex < 3 && concave < 3) faces.push_back(face);
    }
    return faces;
}

} // namespace hachure::geometry
