#include <hachure/systems/shade_strokes/chain_editor.h>
#include <hachure/systems/shade_strokes/shade_random.h>

#include <utility>

namespace hachure {
namespace {

constexpr ShadeSegment dead_segment{no_slot, no_slot, no_slot, no_slot, no_slot, no_slot, 0.0f, 0};

std::uint32_t id_of(std::uint32_t chain, ChainSide side) { return 2 * chain + static_cast<std::uint32_t>(side); }
std::size_t index(ChainSide side) { return static_cast<std::size_t>(side); }

} // namespace

std::uint32_t ChainEditor::begin_chain(std::uint64_t random, const glm::vec3& general, const glm::vec3& normal,
                                       float max_alpha) {
    ShadeChain chain;
    chain.random = random;
    chain.general = general;
    chain.normal = normal;
    chain.max_alpha = max_alpha;
    return chains_.chains.take(chain);
}

std::uint32_t ChainEditor::grow(std::uint32_t chain, ChainSide side, std::uint32_t tip, std::uint32_t next,
                                std::uint32_t cell, float shade) {
    ShadeChain& own = chains_.chains.edit(chain);
    const bool at_end = side == ChainSide::end;
    const std::uint64_t bits = shade_bits(own.random, ShadePurpose::segment, chains_.born++);
    const std::uint32_t beside = at_end ? own.last : own.first;
    const std::uint32_t segment =
        chains_.segments.take({at_end ? tip : next, at_end ? next : tip, at_end ? beside : no_slot,
                               at_end ? no_slot : beside, cell, chain, 0.0f, static_cast<std::uint32_t>(bits >> 32)});
    if (segment >= chains_.links.size()) chains_.links.resize(segment + 1);
    chains_.links[segment] = {no_slot, no_slot, shade, shade, own.max_alpha};
    if (beside != no_slot) {
        ShadeSegment& other = chains_.segments.edit(beside);
        (at_end ? other.after : other.before) = segment;
    }
    (at_end ? own.last : own.first) = segment;
    if (beside == no_slot) own.first = own.last = segment;
    link_to_cell(segment, cell);
    return segment;
}

void ChainEditor::remove(std::uint32_t segment, const glm::vec3& heading) {
    const ShadeSegment gone = chains_.segments[segment];
    unlink_from_cell(segment);
    chains_.segments.give_back(segment, dead_segment);
    if (gone.before == no_slot) {
        stop_waiting(gone.chain, ChainSide::begin);
        chains_.nodes.give_back(gone.from, {});
    }
    if (gone.after == no_slot) {
        stop_waiting(gone.chain, ChainSide::end);
        chains_.nodes.give_back(gone.to, {});
    }
    std::uint32_t rest = gone.chain; // the chain of what comes behind
    if (gone.before != no_slot && gone.after != no_slot) {
        const ShadeChain& own = chains_.chains[gone.chain];
        rest = begin_chain(shade_bits(own.random, ShadePurpose::chain, chains_.born++), own.general, own.normal,
                           own.max_alpha);
        const ShadeEnd end = chains_.chains[gone.chain].end[1];
        stop_waiting(gone.chain, ChainSide::end);
        chains_.chains.edit(rest).last = chains_.chains[gone.chain].last;
        if (end.cell != no_slot) wait(rest, ChainSide::end, end.cell, end.heading);
    }
    if (gone.before != no_slot) {
        chains_.segments.edit(gone.before).after = no_slot;
        chains_.chains.edit(gone.chain).last = gone.before;
        wait(gone.chain, ChainSide::end, gone.cell, heading);
    }
    if (gone.after != no_slot) {
        chains_.segments.edit(gone.after).before = no_slot;
        chains_.chains.edit(rest).first = gone.after;
        if (rest != gone.chain) own_from(gone.after, rest);
        wait(rest, ChainSide::begin, gone.cell, -heading);
    }
    if (gone.before == no_slot && gone.after == no_slot) {
        chains_.chains.edit(gone.chain).first = chains_.chains.edit(gone.chain).last = no_slot;
        drop_empty(gone.chain);
    }
}

void ChainEditor::join(std::uint32_t first, std::uint32_t second) {
    stop_waiting(first, ChainSide::end);
    stop_waiting(second, ChainSide::begin);
    const ShadeEnd end = chains_.chains[second].end[1];
    stop_waiting(second, ChainSide::end);
    const std::uint32_t before = chains_.chains[first].last, behind = chains_.chains[second].first;
    chains_.segments.edit(before).after = behind;
    chains_.segments.edit(behind).before = before;
    chains_.chains.edit(first).last = chains_.chains[second].last;
    own_from(behind, first);
    if (end.cell != no_slot) wait(first, ChainSide::end, end.cell, end.heading);
    chains_.chains.give_back(second, {});
}

void ChainEditor::drop_empty(std::uint32_t chain) {
    stop_waiting(chain, ChainSide::begin);
    stop_waiting(chain, ChainSide::end);
    chains_.chains.give_back(chain, {});
}

void ChainEditor::wait(std::uint32_t chain, ChainSide side, std::uint32_t cell, const glm::vec3& heading) {
    stop_waiting(chain, side);
    ShadeCellState& place = chains_.cells[cell];
    const std::uint32_t id = id_of(chain, side);
    if (place.ends != no_slot) chains_.chains.edit(place.ends / 2).end[place.ends % 2].previous = id;
    chains_.chains.edit(chain).end[index(side)] = {cell, no_slot, place.ends, heading};
    place.ends = id;
}

void ChainEditor::stop_waiting(std::uint32_t chain, ChainSide side) {
    const ShadeEnd end = chains_.chains[chain].end[index(side)];
    if (end.cell == no_slot) return;
    if (end.previous != no_slot)
        chains_.chains.edit(end.previous / 2).end[end.previous % 2].next = end.next;
    else
        chains_.cells[end.cell].ends = end.next;
    if (end.next != no_slot) chains_.chains.edit(end.next / 2).end[end.next % 2].previous = end.previous;
    chains_.chains.edit(chain).end[index(side)] = {};
}

void ChainEditor::refresh(std::uint32_t cell) {
    double sum = 0.0;
    for (std::uint32_t s = chains_.cells[cell].first; s != no_slot; s = chains_.links[s].cell_next)
        sum += double(chains_.segments[s].alpha) * chains_.links[s].shade;
    chains_.cells[cell].delivered = static_cast<float>(sum);
}

std::uint32_t ChainEditor::outer_node(std::uint32_t chain, ChainSide side) const {
    const ShadeChain& own = chains_.chains[chain];
    return side == ChainSide::end ? chains_.segments[own.last].to : chains_.segments[own.first].from;
}

void ChainEditor::link_to_cell(std::uint32_t segment, std::uint32_t cell) {
    const std::uint32_t head = chains_.cells[cell].first;
    chains_.links[segment].cell_next = head;
    chains_.links[segment].cell_previous = no_slot;
    if (head != no_slot) chains_.links[head].cell_previous = segment;
    chains_.cells[cell].first = segment;
}

void ChainEditor::unlink_from_cell(std::uint32_t segment) {
    const ShadeSegmentLinks& links = chains_.links[segment];
    if (links.cell_previous != no_slot)
        chains_.links[links.cell_previous].cell_next = links.cell_next;
    else
        chains_.cells[chains_.segments[segment].cell].first = links.cell_next;
    if (links.cell_next != no_slot) chains_.links[links.cell_next].cell_previous = links.cell_previous;
}

void ChainEditor::own_from(std::uint32_t segment, std::uint32_t chain) {
    for (std::uint32_t s = segment; s != no_slot; s = chains_.segments[s].after) chains_.segments.edit(s).chain = chain;
}

} // namespace hachure
