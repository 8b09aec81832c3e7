#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/chain_segments.h>
#include <hachure/runtime/geometry/surface_segment.h>

#include <bit>
#include <cstddef>

namespace hachure::geometry {
namespace {

constexpr std::uint32_t no_segment = 0xffffffffu;

/// Spreads ids over the table (the finaliser of splitmix64).
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::uint64_t id_of(const ChainSegmentsJob& job, std::uint32_t end) {
    const SegmentEnds& ends = job.ends[end / 2];
    return end % 2 == 0 ? ends.start : ends.end;
}

ChainSegmentsJob::Place& place_of(ChainSegmentsJob& job, std::uint64_t id) {
    const std::size_t mask = job.places.size() - 1;
    std::size_t slot = static_cast<std::size_t>(mixed(id)) & mask;
    while (job.places[slot].count != 0 && job.places[slot].id != id) slot = (slot + 1) & mask;
    return job.places[slot];
}

void find_partners(ChainSegmentsJob& job) {
    const auto end_count = static_cast<std::uint32_t>(2 * job.ends.size());
    job.places.assign(std::bit_ceil(2 * std::size_t{end_count} + 2), {});
    job.partners.assign(end_count, no_segment);
    for (std::uint32_t end = 0; end < end_count; ++end) {
        const std::uint64_t id = id_of(job, end);
        if (id == free_end) continue;
        ChainSegmentsJob::Place& place = place_of(job, id);
        place.id = id;
        if (place.count < 2) place.ends[place.count] = end;
        ++place.count;
    }
    for (const ChainSegmentsJob::Place& place : job.places) {
        if (place.count != 2) continue;
        job.partners[place.ends[0]] = place.ends[1];
        job.partners[place.ends[1]] = place.ends[0];
    }
}

/// The end at which the chain of a segment begins, so that the segment is run through from its start to its end; of a
/// loop its own start. Ends of one segment differ in their last bit.
std::uint32_t beginning(const ChainSegmentsJob& job, std::uint32_t segment) {
    const std::uint32_t own = 2 * segment;
    for (std::uint32_t end = own;;) {
        const std::uint32_t before = job.partners[end];
        if (before == no_segment) return end;
        end = before ^ 1u;
        if (end == own) return own;
    }
}

} // namespace

void ChainSegmentsJob::validate() const {
    HACHURE_ASSERT(lengths.size() == ends.size() && order.size() == ends.size(), "one element per segment");
    HACHURE_ASSERT(ends.size() < no_segment / 2, "ends are counted in 32 bits");
}

void ChainSegmentsJob::run() {
    find_partners(*this);
    done.assign(ends.size(), 0);
    chains.clear();
    std::uint32_t next = 0;
    for (std::uint32_t segment = 0; segment < ends.size(); ++segment) {
        if (done[segment] != 0) continue;
        const std::uint32_t begin = beginning(*this, segment);
        Chain chain{.first = next, .count = 0, .length = 0.0f, .closed = 0};
        double arc = 0.0;
        std::uint32_t end = begin;
        do {
            done[end / 2] = 1;
            order[next++] = {end / 2, end % 2, static_cast<float>(arc)};
            arc += static_cast<double>(lengths[end / 2]);
            end = partners[end ^ 1u];
        } while (end != no_segment && end != begin);
        chain.count = next - chain.first;
        chain.length = static_cast<float>(arc);
        // Through a junction, too, a chain can come back to where it began.
        const ChainedSegment& last = order[next - 1];
        const std::uint64_t start_id = id_of(*this, begin);
        chain.closed =
            start_id != free_end && start_id == id_of(*this, 2 * last.segment + (last.reversed ^ 1u)) ? 1 : 0;
        chains.push_back(chain);
    }
}

} // namespace hachure::geometry
