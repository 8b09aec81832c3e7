#include <hachure/runtime/assert.h>
#include <hachure/runtime/ecs/snapshot/snapshot_live.h>

namespace hachure::detail {
namespace {

constexpr std::uint32_t used_up = std::numeric_limits<std::uint32_t>::max();

} // namespace

LiveEntities::LiveEntities(const World& world) : ids(world.entity_ids()) {
    find_live();
    HACHURE_ASSERT(entities.size() == world.size(), "commands are applied before a snapshot is taken");
}

LiveEntities::LiveEntities(ByteReader& in) {
    ids.generations = in.numbers<std::uint32_t>(in.number<std::uint32_t>());
    for (const std::uint32_t generation : ids.generations)
        if (generation == 0) in.fail("has a generation 0");
    ids.free = in.numbers<std::uint32_t>(in.number<std::uint32_t>());
    in.expect_end();
    std::vector<bool> seen(ids.generations.size());
    for (const std::uint32_t slot : ids.free) {
        if (slot >= seen.size() || seen[slot] || ids.generations[slot] == used_up)
            in.fail("has a free slot that is none");
        seen[slot] = true;
    }
    find_live();
}

void LiveEntities::write(ByteWriter& out) const {
    out.number(static_cast<std::uint32_t>(ids.generations.size()));
    out.numbers(std::span<const std::uint32_t>(ids.generations));
    out.number(static_cast<std::uint32_t>(ids.free.size()));
    out.numbers(std::span<const std::uint32_t>(ids.free));
}

void LiveEntities::find_live() {
    place.assign(ids.generations.size(), 0);
    for (const std::uint32_t slot : ids.free) place[slot] = nowhere;
    for (std::uint32_t slot = 0; slot < place.size(); ++slot) {
        if (ids.generations[slot] == used_up) place[slot] = nowhere;
        if (place[slot] == nowhere) continue;
        place[slot] = count();
        entities.push_back({slot, ids.generations[slot]});
    }
}

} // namespace hachure::detail
