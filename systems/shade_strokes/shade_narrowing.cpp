#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/weld.h>
#include <hachure/runtime/parallel.h>
#include <hachure/systems/shade_strokes/shade_narrowing.h>
#include <hachure/systems/shade_strokes/stroke_amplitude.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure {
namespace {

constexpr int narrowing_sweeps = 3; // as shade_directions has it
constexpr std::size_t narrowing_block = 4096;

template <class Body> void each_place(std::size_t count, const Body& body) {
    parallel_for((count + narrowing_block - 1) / narrowing_block, [&](std::size_t b) {
        for (std::size_t v = b * narrowing_block; v < std::min(count, (b + 1) * narrowing_block); ++v)
            body(static_cast<std::uint32_t>(v));
    });
}

} // namespace

void ShadeNarrowingJob::validate() const {
    HACHURE_ASSERT(curvatures.size() == positions.size(), "a curvature per vertex");
    HACHURE_ASSERT(indices.size() % 3 == 0 && size > 0.0, "three indices per triangle, and a size");
}

void ShadeNarrowingJob::run() {
    if (rest_of != positions.data() || rest_by != method || rest.size() != positions.size()) look_at_rest();
    smooth(curvatures, now);
    shares.resize(positions.size());
    each_place(positions.size(), [&](std::uint32_t v) {
        const std::uint32_t place = weld[v];
        const double laid = stroke_amplitude(settings, rest[place], size);
        shares[v] = static_cast<float>(std::min(1.0, stroke_amplitude(settings, now[place], size) / laid));
    });
}

void ShadeNarrowingJob::look_at_rest() {
    rest_of = positions.data();
    rest_by = method;
    weld = geometry::weld_positions(positions);
    neighbours.build(indices, weld);
    std::vector<glm::vec3> normals(positions.size()), directions(positions.size());
    std::vector<glm::vec2> raw(positions.size());
    geometry::SmoothNormalsJob smooth_normals{
        .positions = positions, .indices = indices, .weld = weld, .normals = normals};
    smooth_normals.run();
    geometry::CurvatureJob job{.positions = positions,
                               .normals = normals,
                               .indices = indices,
                               .weld = weld,
                               .curvatures = raw,
                               .directions = directions,
                               .method = method,
                               .neighbours = &neighbours};
    job.run();
    smooth(raw, rest);
}

/// Means of each vertex and those around it, a few times over.
void ShadeNarrowingJob::smooth(std::span<const glm::vec2> raw, std::vector<float>& values) {
    values.resize(raw.size());
    next.resize(raw.size());
    each_place(raw.size(), [&](std::uint32_t v) { values[v] = std::isfinite(raw[v].x) ? std::abs(raw[v].x) : 0.0f; });
    for (int sweep = 0; sweep < narrowing_sweeps; ++sweep) {
        each_place(raw.size(), [&](std::uint32_t v) {
            if (weld[v] != v) return;
            float sum = values[v];
            for (const std::uint32_t other : neighbours.of(v)) sum += values[other];
            next[v] = sum / static_cast<float>(1 + neighbours.of(v).size());
        });
        values.swap(next);
    }
}

} // namespace hachure
