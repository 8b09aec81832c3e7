#include <hachure/runtime/geometry/curvature.h>
#include <hachure/runtime/geometry/direction_field.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/shade_strokes/shade_directions.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hachure {
namespace {

using Complex = std::complex<float>;
using geometry::SheetMetric;
using geometry::SurfaceSheets;

constexpr int least_sweeps = 16, most_sweeps = 64, curvature_sweeps = 3;
constexpr double detail = 0.03; // over the model's size: directions of smaller features give way to those around
constexpr double least_follow = 0.01, most_follow = 1.5;
constexpr float fallback = 1e-4f;       // how much the default counts
constexpr double flat = 0.5;            // curvature that counts as none, times the model's size
constexpr float least_agreement = 0.7f; // cosine between a given normal and that of the triangles
constexpr std::size_t vertex_block = 8192;

template <class Body> void each_vertex(std::size_t count, const Body& body) {
    parallel_for((count + vertex_block - 1) / vertex_block, [&](std::size_t b) {
        for (std::size_t v = b * vertex_block; v < std::min(count, (b + 1) * vertex_block); ++v)
            body(static_cast<std::uint32_t>(v));
    });
}

/// Principal curvatures and the direction of the first, per vertex of the sheets.
struct Curvatures {
    std::vector<glm::vec2> values;
    std::vector<glm::vec3> directions;
    std::vector<float> confidences; ///< in [0, 1]: of the directions, by the noise of the mesh
};

/// The given normals, which know the surface better than triangles do, where they are sound.
std::vector<glm::vec3> normals_of(const SurfaceSheets& sheets, const SheetMetric& metric,
                                  std::span<const glm::vec3> given, std::span<const std::uint32_t> indices) {
    std::vector<glm::vec3> normals(metric.normal.begin(), metric.normal.end());
    for (std::size_t v = 0; !given.empty() && v < normals.size(); ++v) {
        const std::uint32_t h = sheets.out[v];
        const glm::vec3& normal = given[indices[3 * sheets.face[h / 3] + h % 3]];
        if (glm::dot(normal, normals[v]) > least_agreement) normals[v] = normal;
    }
    return normals;
}

Curvatures computed(const SurfaceSheets& sheets, std::span<const glm::vec3> normals) {
    const std::size_t count = sheets.positions.size();
    const std::vector<glm::vec3> positions(sheets.positions.begin(), sheets.positions.end());
    std::vector<std::uint32_t> indices, weld(count);
    for (const auto& t : sheets.triangles) indices.insert(indices.end(), t.begin(), t.end());
    std::iota(weld.begin(), weld.end(), 0u);
    Curvatures result{std::vector<glm::vec2>(count), std::vector<glm::vec3>(count), std::vector<float>(count)};
    geometry::CurvatureJob job{.positions = positions,
                               .normals = normals,
                               .indices = indices,
                               .weld = weld,
                               .curvatures = result.values,
                               .directions = result.directions,
                               .confidences = result.confidences,
                               .method = geometry::CurvatureMethod::automatic};
    job.run();
    return result;
}

Curvatures taken(const SurfaceSheets& sheets, std::span<const std::uint32_t> indices,
                 std::span<const glm::vec2> curvatures, std::span<const glm::vec3> directions) {
    Curvatures result;
    for (const std::uint32_t h : sheets.out) {
        const std::uint32_t vertex = indices[3 * sheets.face[h / 3] + h % 3];
        result.values.push_back(curvatures[vertex]);
        result.directions.push_back(directions[vertex]);
        result.confidences.push_back(1.0f);
    }
    return result;
}

Complex unit_or(Complex z, Complex otherwise) {
    const float size = std::abs(z);
    return size > 1e-30f && std::isfinite(size) ? z / size : otherwise;
}

/// What each vertex wants by itself: a line of strokes times how sure it is of that, and what it wants by default.
struct Wishes {
    std::vector<Complex> wanted, otherwise;
};

Wishes wishes(const SheetMetric& metric, const Curvatures& curvatures) {
    const std::size_t count = curvatures.values.size();
    Wishes result{std::vector<Complex>(count), std::vector<Complex>(count)};
    each_vertex(count, [&](std::uint32_t v) {
        const double k1 = curvatures.values[v].x, k2 = curvatures.values[v].y;
        const double sure =
            double{curvatures.confidences[v]} *
            geometry::direction_confidence(0.5 * (k1 + k2), 0.5 * std::abs(k1 - k2), flat / metric.size);
        const SheetMetric::Complex d = metric.to_frame(v, glm::dvec3(curvatures.directions[v]));
        // Strokes run across the first direction: half a turn of the line's doubled angle.
        if (std::isfinite(sure) && metric.tip[v] == 0)
            result.wanted[v] = static_cast<float>(sure * sure) * unit_or(-Complex(d * d), Complex(0.0f));
        const glm::dvec3 axis = metric.axis[v];
        result.otherwise[v] =
            unit_or(-Complex(geometry::default_line(axis, glm::cross(metric.normal[v], axis))), Complex(1.0f));
    });
    return result;
}

/// How much a sure direction counts against those around it: the balance is at features of the length `detail`, in
/// edges of the mesh, so that the field does not depend on how fine that is.
float follow_of(const SheetMetric& metric) {
    double sum = 0.0;
    for (const double length : metric.length) sum += length;
    const double edge = sum / static_cast<double>(std::max<std::size_t>(1, metric.length.size()));
    const double ratio = edge / (detail * metric.size);
    return static_cast<float>(std::clamp(ratio * ratio, least_follow, most_follow));
}

/// Lines that differ little from their neighbours' and from what is wanted: sweeps of Jacobi's method.
std::vector<Complex> smooth_lines(const SurfaceSheets& sheets, const SheetMetric& metric, const Wishes& wish) {
    const std::size_t count = sheets.positions.size();
    std::vector<Complex> turn(sheets.opposite.size()), lines(count), next(count);
    const float follow = follow_of(metric);
    const int sweeps = std::clamp(static_cast<int>(1.0f / follow), least_sweeps, most_sweeps);
    each_vertex(turn.size(), [&](std::uint32_t h) { turn[h] = Complex(std::polar(1.0, -2.0 * metric.transport(h))); });
    each_vertex(count, [&](std::uint32_t v) {
        lines[v] = unit_or(wish.wanted[v] + 0.1f * wish.otherwise[v], wish.otherwise[v]);
    });
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        each_vertex(count, [&](std::uint32_t v) {
            Complex sum(0.0f);
            float weights = 0.0f;
            sheets.each_out(v, [&](std::uint32_t h) {
                const auto weight = static_cast<float>(metric.weight[h]);
                sum += weight * turn[h] * lines[sheets.head(h)];
                weights += weight;
            });
            const Complex around = weights > 0.0f ? sum / weights : lines[v];
            next[v] = (around + follow * wish.wanted[v] + fallback * wish.otherwise[v]) /
                      (1.0f + follow * std::abs(wish.wanted[v]) + fallback);
        });
        lines.swap(next);
    }
    for (std::size_t v = 0; v < count; ++v) lines[v] = unit_or(lines[v], wish.otherwise[v]);
    return lines;
}

std::vector<float> smooth_curvature(const SurfaceSheets& sheets, const Curvatures& curvatures) {
    const std::size_t count = curvatures.values.size();
    std::vector<float> values(count), next(count);
    for (std::size_t v = 0; v < count; ++v) {
        const float k = std::abs(curvatures.values[v].x);
        values[v] = std::isfinite(k) ? k : 0.0f;
    }
    for (int sweep = 0; sweep < curvature_sweeps; ++sweep) {
        each_vertex(count, [&](std::uint32_t v) {
            float sum = values[v], weights = 1.0f;
            sheets.each_out(v, [&](std::uint32_t h) {
                sum += values[sheets.head(h)];
                weights += 1.0f;
            });
            next[v] = sum / weights;
        });
        values.swap(next);
    }
    return values;
}

} // namespace

ShadeDirections shade_directions(const SurfaceSheets& sheets, const SheetMetric& metric,
                                 std::span<const std::uint32_t> indices, std::span<const glm::vec3> normals,
                                 std::span<const glm::vec2> curvatures, std::span<const glm::vec3> directions) {
    const Curvatures own = curvatures.empty() ? computed(sheets, normals_of(sheets, metric, normals, indices))
                                              : taken(sheets, indices, curvatures, directions);
    const std::vector<Complex> lines = smooth_lines(sheets, metric, wishes(metric, own));
    ShadeDirections result{.along = {}, .curvature = smooth_curvature(sheets, own)};
    result.along.resize(lines.size());
    for (std::uint32_t v = 0; v < lines.size(); ++v) {
        const float angle = 0.5f * std::arg(lines[v]);
        result.along[v] = glm::vec3(metric.to_space(v, std::polar(1.0, static_cast<double>(angle))));
    }
    return result;
}

} // namespace hachure
