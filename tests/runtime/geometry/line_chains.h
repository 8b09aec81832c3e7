#pragma once

#include <hachure/runtime/geometry/chain_segments.h>
#include <hachure/runtime/geometry/surface_segment.h>

#include <glm/geometric.hpp>

#include <map>
#include <span>
#include <utility>
#include <vector>

/// What tests ask of lines on surfaces.
namespace hachure::geometry::reference {

inline double length(const SurfaceSegment& s) { return glm::distance(glm::dvec3(s.start), glm::dvec3(s.end)); }

inline double length(std::span<const SurfaceSegment> segments) {
    double sum = 0.0;
    for (const SurfaceSegment& s : segments) sum += length(s);
    return sum;
}

/// Whether ends with one id are at one place bit for bit.
inline bool ends_agree(std::span<const SurfaceSegment> segments) {
    std::map<std::uint64_t, glm::vec3> places;
    for (const SurfaceSegment& s : segments)
        for (const auto& [id, at] : {std::pair(s.start_id, s.start), std::pair(s.end_id, s.end)})
            if (id != free_end && places.emplace(id, at).first->second != at) return false;
    return true;
}

inline std::vector<Chain> chains(std::span<const SurfaceSegment> segments) {
    std::vector<SegmentEnds> ends;
    std::vector<float> lengths;
    for (const SurfaceSegment& s : segments) {
        ends.push_back({s.start_id, s.end_id});
        lengths.push_back(static_cast<float>(length(s)));
    }
    std::vector<ChainedSegment> order(segments.size());
    ChainSegmentsJob job{.ends = ends, .lengths = lengths, .order = order};
    job.validate();
    job.run();
    return job.chains;
}

inline std::size_t closed_chains(std::span<const SurfaceSegment> segments) {
    std::size_t count = 0;
    for (const Chain& chain : chains(segments)) count += chain.closed;
    return count;
}

} // namespace hachure::geometry::reference
