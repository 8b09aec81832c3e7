#include <hachure/runtime/assert.h>
#include <hachure/systems/shade_strokes/chain_walk.h>
#include <hachure/systems/shade_strokes/shade_random.h>
#include <hachure/systems/shade_strokes/shade_update.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hachure {
namespace {

constexpr int most_rounds = 32;            // of handing round what clipped: each round settles a segment at least
constexpr std::uint32_t most_chains = 48;  // begun in a cell at a time
constexpr std::uint32_t most_failures = 4; // in a row that give up on a cell
constexpr std::uint32_t most_waiting = 16; // ends tried in a cell at a time
constexpr std::uint32_t candidates = 4;    // for the start of a chain: the one in the widest gap is taken
constexpr float faded = 1.0f / 512.0f;     // alpha that nobody sees
constexpr double inner_fading = 0.25;      // of a segment within a chain, over that of one at its end, at alpha 1

/// Distance of a point from a straight piece.
double distance_from(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square > 0.0 ? glm::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

} // namespace

void ShadeUpdateJob::validate() const {
    HACHURE_ASSERT(mesh != nullptr && chains != nullptr, "a mesh and its chains");
    HACHURE_ASSERT(needed.size() == mesh->cell_count(), "a need per cell");
    HACHURE_ASSERT(settings.amplitude > 0.0f && settings.min_amplitude > 0.0f && settings.max_amplitude > 0.0f,
                   "amplitudes are positive");
    HACHURE_ASSERT(settings.density > 0.0f && settings.dead_band > 0.0f, "density and dead band are positive");
}

void ShadeUpdateJob::reset() { last_mesh = nullptr; }

void ShadeUpdateJob::start_over() {
    ShadeChains& all = *chains;
    all.nodes.clear();
    all.segments.clear();
    all.links.clear();
    all.chains.clear();
    all.born = 0;
    all.cells.assign(mesh->cell_count(), ShadeCellState{});
    last_mesh = mesh;
    last_settings = settings;
}

void ShadeUpdateJob::run() {
    stats = {};
    const bool anew = last_mesh != mesh || !(last_settings == settings);
    if (anew) start_over();
    touched_.clear();
    if (!changed && !narrowed && !anew) return;
    ChainEditor editor(*chains);
    if (narrowed)
        for (std::uint32_t cell = 0; cell < mesh->cell_count(); ++cell) narrow(editor, cell);
    for (const std::uint32_t cell : mesh->order)
        if (differs(cell)) touched_.push_back(cell);
    stats.swept = static_cast<std::uint32_t>(mesh->order.size());
    stats.touched = static_cast<std::uint32_t>(touched_.size());
    for (const std::uint32_t cell : touched_)
        if (missing(cell) < 0.0f) weaken(editor, cell);
    ChainWalk walk(*mesh, settings, narrowing, needed, *chains);
    for (const std::uint32_t cell : touched_) {
        // Chains that came by may have brought enough already.
        if (missing(cell) > 0.0f) strengthen(editor, cell, least_share);
        if (walk.wants(cell)) extend(walk, cell);
        if (walk.wants(cell)) begin_chains(walk, cell);
        if (missing(cell) > settings.dead_band) strengthen(editor, cell, 0.0);
        note_unmet(cell);
    }
    stats.steps = walk.steps;
    stats.joined = walk.joined;
}

/// Accounts for how narrow the strokes of a cell are. One that could not meet its need and has less now tries again.
void ShadeUpdateJob::narrow(ChainEditor& editor, std::uint32_t cell) {
    ShadeCellState& state = chains->cells[cell];
    if (state.first == no_slot) return;
    const float before = state.delivered;
    for (std::uint32_t s = state.first; s != no_slot; s = chains->links[s].cell_next) {
        const ShadeSegment& segment = chains->segments[s];
        editor.narrow(s, narrowing.of(chains->nodes[segment.from], chains->nodes[segment.to]));
    }
    editor.refresh(cell);
    if (state.delivered < before) state.unmet = -1.0f;
}

bool ShadeUpdateJob::differs(std::uint32_t cell) const {
    const ShadeCellState& state = chains->cells[cell];
    const float need = needed[cell], difference = need - state.delivered;
    if (need <= 0.0f) return state.first != no_slot;
    if (std::abs(difference) <= settings.dead_band) return false;
    return !(difference > 0.0f && state.unmet >= 0.0f && need <= state.unmet + settings.dead_band);
}

/// Takes alpha from every segment, most from ends of chains: so chains shrink from their ends, and are split only where
/// nothing else is left; from others a part of what they have, or a small end would lose all of its own at once. Those
/// that fade out go.
void ShadeUpdateJob::weaken(ChainEditor& editor, std::uint32_t cell) {
    double excess = needed[cell] <= 0.0f ? std::numeric_limits<double>::max() : -double{missing(cell)};
    for (int round = 0; round < most_rounds && excess > 1e-6; ++round) {
        const double shade = list_fading(cell);
        if (open.empty()) break;
        const double total_alpha = excess / std::max(shade, 1e-12);
        for (std::size_t i = 0; i < open.size(); ++i) {
            const std::uint32_t s = open[i];
            const double alpha = chains->segments[s].alpha, taken = std::min(alpha, total_alpha * fading_[i]);
            excess -= taken * chains->links[s].shade;
            editor.set_alpha(s, static_cast<float>(alpha - taken));
            if (chains->segments[s].alpha <= faded) remove(editor, s);
        }
    }
    editor.refresh(cell);
}

/// Lists the segments of a cell and how fast each fades, over one at the end of a chain; returns what they lose where
/// that loses an alpha of 1.
double ShadeUpdateJob::list_fading(std::uint32_t cell) {
    double shade = 0.0;
    open.clear();
    fading_.clear();
    for (std::uint32_t s = chains->cells[cell].first; s != no_slot; s = chains->links[s].cell_next) {
        const ShadeSegment& segment = chains->segments[s];
        const bool end = segment.before == no_slot || segment.after == no_slot;
        open.push_back(s);
        fading_.push_back(end ? 1.0 : inner_fading * segment.alpha);
        shade += fading_.back() * chains->links[s].shade;
    }
    return shade;
}

void ShadeUpdateJob::remove(ChainEditor& editor, std::uint32_t segment) {
    const ShadeSegment& gone = chains->segments[segment];
    const glm::dvec3 run = mesh->at(chains->nodes[gone.to].rib[2]) - mesh->at(chains->nodes[gone.from].rib[2]);
    const double length = glm::length(run);
    editor.remove(segment, length > 0.0 ? glm::vec3(run / length) : glm::vec3(0.0f));
    ++stats.removed;
}

/// Gives as much alpha to every segment, as far as their pens can: as if they were `least` of the cell's shade, where
/// they are less.
void ShadeUpdateJob::strengthen(ChainEditor& editor, std::uint32_t cell, double least) {
    open.clear();
    for (std::uint32_t s = chains->cells[cell].first; s != no_slot; s = chains->links[s].cell_next) open.push_back(s);
    double wanted = missing(cell);
    for (int round = 0; round < most_rounds && wanted > 1e-6; ++round) {
        double shade = 0.0;
        for (const std::uint32_t s : open)
            if (chains->segments[s].alpha < chains->links[s].max_alpha) shade += chains->links[s].shade;
        if (!(shade > 0.0)) break;
        const double total_alpha = wanted / std::max(shade, least); // of each, not shared between them (readings.md)
        for (const std::uint32_t s : open) {
            const double alpha = chains->segments[s].alpha, most = chains->links[s].max_alpha;
            const double added = std::clamp(most - alpha, 0.0, total_alpha);
            editor.set_alpha(s, static_cast<float>(std::min(most, alpha + added)));
            wanted -= added * chains->links[s].shade;
        }
        if (shade < least) break;
    }
    editor.refresh(cell);
}

/// Lets chains that wait at the cell go on.
void ShadeUpdateJob::extend(ChainWalk& walk, std::uint32_t cell) {
    std::array<std::uint32_t, most_waiting> ends{};
    std::size_t count = 0;
    for (std::uint32_t e = chains->cells[cell].ends; e != no_slot && count < ends.size();
         e = chains->chains[e / 2].end[e % 2].next)
        ends[count++] = e;
    for (std::size_t i = 0; i < count && walk.wants(cell); ++i) {
        const ShadeChain& chain = chains->chains[ends[i] / 2];
        if (chain.first == no_slot || chain.end[ends[i] % 2].cell != cell) continue; // joined meanwhile
        if (walk.extend(ends[i] / 2, static_cast<ChainSide>(ends[i] % 2))) ++stats.extended;
    }
}

void ShadeUpdateJob::begin_chains(ChainWalk& walk, std::uint32_t cell) {
    std::uint32_t failures = 0;
    for (std::uint32_t i = 0; i < most_chains && failures < most_failures && walk.wants(cell); ++i) {
        const std::uint64_t random = shade_bits(settings.seed, ShadePurpose::chain, chains->born++);
        const float before = chains->cells[cell].delivered;
        const ShadeCells::Point start = start_point(cell, random);
        if (walk.begin({start.triangle, start.weight}, random)) ++stats.begun;
        failures = chains->cells[cell].delivered > before ? 0 : failures + 1;
    }
}

/// Of a few random points of the cell the one that is farthest from its strokes.
ShadeCells::Point ShadeUpdateJob::start_point(std::uint32_t cell, std::uint64_t random) const {
    ShadeCells::Point best{};
    double widest = -1.0;
    for (std::uint32_t i = 0; i < candidates; ++i) {
        const auto uniform = [&](std::uint32_t k) { return shade_uniform(random, ShadePurpose::start, 3 * i + k); };
        const ShadeCells::Point point = mesh->cells.point_in(cell, uniform(0), uniform(1), uniform(2));
        const glm::dvec3 place = mesh->at(mesh->point(point.triangle, point.weight));
        double gap = std::numeric_limits<double>::max();
        for (std::uint32_t s = chains->cells[cell].first; s != no_slot; s = chains->links[s].cell_next) {
            const ShadeSegment& segment = chains->segments[s];
            gap = std::min(gap, distance_from(place, mesh->at(chains->nodes[segment.from].rib[2]),
                                              mesh->at(chains->nodes[segment.to].rib[2])));
        }
        if (gap <= widest) continue;
        widest = gap;
        best = point;
    }
    return best;
}

void ShadeUpdateJob::note_unmet(std::uint32_t cell) {
    const bool unmet = missing(cell) > settings.dead_band;
    chains->cells[cell].unmet = unmet ? needed[cell] : -1.0f;
    stats.unmet += unmet ? 1 : 0;
}

} // namespace hachure
