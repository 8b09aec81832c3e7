#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// The ends of a segment: equal ids are one place. `free_end` (surface_segment.h) is like no other end.
struct SegmentEnds {
    std::uint64_t start, end;
};

/// A segment within its chain.
struct ChainedSegment {
    std::uint32_t segment;  ///< which of the input
    std::uint32_t reversed; ///< 1 when the chain runs from its end to its start
    float arc;              ///< length of the chain before it
};

/// Segments one after the other, each beginning where the last one ended.
struct Chain {
    std::uint32_t first, count; ///< within `order`
    float length;               ///< of all its segments
    std::uint32_t closed; ///< 1 when it ends where it begins; then no junction lies on it, but for where it begins
};

/// Links segments into chains, in linear time and with no allocation in the steady state. A chain goes on where exactly
/// two ends meet; at a junction of three or more all chains end. Chains come in the order of their first segment in the
/// input, and run in that segment's direction; a loop begins with it. Every segment is in one chain.
struct ChainSegmentsJob {
    std::span<const SegmentEnds> ends;
    std::span<const float> lengths; ///< of each segment, in any unit

    std::span<ChainedSegment> order; ///< out, one per segment: chain after chain
    std::vector<Chain> chains{};     ///< out, kept from run to run

    /// Asserts that sizes agree.
    void validate() const;
    void run();

    /// Scratch, kept from run to run: the ends at a place, in a hash table.
    struct Place {
        std::uint64_t id;
        std::uint32_t count;   ///< 0 for an empty slot
        std::uint32_t ends[2]; ///< the first two: 2 * segment, + 1 for its end
    };
    std::vector<Place> places{};
    std::vector<std::uint32_t> partners{}; ///< per end: the one that it goes on with
    std::vector<std::uint8_t> done{};
};

} // namespace hachure::geometry
