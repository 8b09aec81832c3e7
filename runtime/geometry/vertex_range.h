#pragma once

#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/runtime/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace hachure::geometry {

/// One past the last vertex of a range in a mesh of `vertex_count`.
[[nodiscard]] inline std::size_t end_of(const VertexRange& range, std::size_t vertex_count) {
    return range.count < vertex_count - std::min(range.first, vertex_count) ? range.first + range.count : vertex_count;
}

/// Runs copies of a job with a `range` and `bounds` on all threads, on a part of its range each.
template <class Job> void run_ranges_in_parallel(Job& job, std::size_t vertex_count) {
    constexpr std::size_t most_parts = 64, smallest_part = 4096;
    const std::size_t first = job.range.first, end = std::max(end_of(job.range, vertex_count), first);
    const std::size_t parts = std::clamp<std::size_t>((end - first) / smallest_part, 1, most_parts);
    const std::size_t size = (end - first + parts - 1) / parts;
    std::array<Bounds, most_parts> bounds; // memory of the caller's own: nothing is allocated
    parallel_for(parts, [&](std::size_t part) {
        Job own = job;
        own.range = {std::min(end, first + part * size), size};
        own.range.count = std::min(size, end - own.range.first);
        own.run();
        bounds[part] = own.bounds;
    });
    job.bounds = {};
    for (std::size_t part = 0; part < parts; ++part) job.bounds.include(bounds[part]);
}

} // namespace hachure::geometry
