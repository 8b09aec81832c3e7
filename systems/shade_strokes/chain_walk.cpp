#include <hachure/systems/shade_strokes/chain_direction.h>
#include <hachure/systems/shade_strokes/chain_walk.h>
#include <hachure/systems/shade_strokes/shade_random.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace hachure {
namespace {

using geometry::WalkPlace;
using geometry::WalkStep;
using geometry::WalkTriangle;

constexpr std::uint32_t most_steps = 4096, most_idle = 16;
constexpr double least_piece = 0.15;    // of a cell's side: a shorter one counts for the cell that comes next
constexpr double least_length = 0.01;   // of a cell's side: there is no shorter piece
constexpr double least_divided = 0.004; // of a cell's side: where a segment leaves the surface nevertheless
constexpr double idle_length = 1e-6;    // over the model's size: a step that gets nowhere
constexpr double least_kink = 0.5;      // cosine: a chain does not go on around sharper corners
constexpr double join_bend = 0.05;      // how far aside of the walk an end may lie, over the length of the last segment
constexpr double join_cosine = 0.9;     // 25 degrees
constexpr double least_pressure = 0.6;  // of the pen, at alpha 1
constexpr int most_divisions = 8;
constexpr double looked_at = 0.5; // of what patches may be off, at one place: at others they are a little more
constexpr glm::dvec3 downwards{0.31, -0.92, 0.24}; // strokes are begun that way, so that those that meet agree

} // namespace

bool ChainWalk::wants(std::uint32_t cell) const {
    if (!(mesh_.cells.area[cell] > 1e-4f * mesh_.cell_side * mesh_.cell_side)) return false;
    return needed_[cell] - chains_.cells[cell].delivered > 0.5f * settings_.dead_band;
}

bool ChainWalk::begin(const WalkPlace& place, std::uint64_t random) {
    const WalkTriangle triangle(mesh_.sheets, place.triangle);
    if (triangle.flat) return false;
    const glm::dvec3 down = triangle.tangent(downwards);
    const glm::dvec3 heading = chain_direction(mesh_, triangle, place, down, settings_.trueness, random, 0.0);
    if (!(glm::dot(heading, heading) > 0.0)) return false;
    const double pressure = least_pressure + (1.0 - least_pressure) * shade_uniform(random, ShadePurpose::pressure, 0);
    const std::uint32_t chain =
        editor_.begin_chain(random, glm::vec3(heading), glm::vec3(triangle.normal), static_cast<float>(pressure));
    ShadeNode first = make_shade_rib(mesh_, settings_, place, heading, 0.0).node;
    first.random = static_cast<std::uint32_t>(random >> 32);
    const std::uint32_t start = chains_.nodes.take(first);
    bool any = walk(chain, ChainSide::end, place, heading, start);
    // The walk may have joined another chain, whose begin stays this one's.
    any = walk(chain, ChainSide::begin, place, -heading, start) || any;
    if (any) return true;
    chains_.nodes.give_back(start, {});
    editor_.drop_empty(chain);
    return false;
}

bool ChainWalk::extend(std::uint32_t chain, ChainSide side) {
    const ShadeEnd end = chains_.chains[chain].end[static_cast<std::size_t>(side)];
    editor_.stop_waiting(chain, side);
    const std::uint32_t tip = editor_.outer_node(chain, side);
    const SurfacePoint point = chains_.nodes[tip].rib[2];
    const double u = point.u, v = point.v;
    const WalkPlace place{mesh_.sheets.triangle_of[point.triangle], {std::max(0.0, 1.0 - u - v), u, v}};
    const WalkTriangle triangle(mesh_.sheets, place.triangle);
    if (triangle.flat) return false;
    return walk(chain, side, place, triangle.tangent(glm::dvec3(end.heading)), tip);
}

bool ChainWalk::walk(std::uint32_t chain, ChainSide side, const WalkPlace& place, const glm::dvec3& heading,
                     std::uint32_t tip) {
    chain_ = chain;
    own_ = chains_.chains[chain];
    side_ = side;
    sign_ = side == ChainSide::end ? 1.0 : -1.0;
    tip_ = tip;
    cell_ = no_slot;
    place_ = place;
    heading_ = heading;
    entered_ = WalkStep::inside;
    start_ = chains_.nodes[tip].along;
    length_ = walked_ = 0.0;
    passed_.clear();
    std::uint32_t idle = 0;
    for (std::uint32_t i = 0; i < most_steps && idle < most_idle; ++i) {
        const WalkTriangle triangle(mesh_.sheets, place_.triangle);
        if (!aim(triangle)) {
            step_back();
            break;
        }
        const WalkStep step =
            geometry::walk_step(triangle, place_.weight, heading_, mesh_.size, mesh_.cells.parts[place_.triangle]);
        ++steps;
        idle = step.length > idle_length * mesh_.size ? 0 : idle + 1;
        if (idle == 0) {
            if (!enter(mesh_.cells.cell_at(place_.triangle, 0.5 * (place_.weight + step.weight)))) return tip_ != tip;
            passed_.push_back({place_, heading_, length_});
        }
        if (!advance(step)) break;
    }
    if (cell_ != no_slot && length_ > 0.0) {
        passed_.push_back({place_, WalkTriangle(mesh_.sheets, place_.triangle).tangent(heading_), length_});
        finish_piece(no_slot);
    }
    return tip_ != tip;
}

/// Turns where the chain wants to run from here; false where it ends.
bool ChainWalk::aim(const WalkTriangle& triangle) {
    if (glm::dot(triangle.normal, glm::dvec3(own_.normal)) < std::cos(0.5 * settings_.chain_turn)) return false;
    glm::dvec3 direction =
        chain_direction(mesh_, triangle, place_, heading_, settings_.trueness, own_.random, start_ + sign_ * walked_);
    if (entered_ != WalkStep::inside) direction = mirrored_inside(triangle, entered_, direction);
    if (sign_ * glm::dot(direction, glm::dvec3(own_.general)) < 0.0) return false;
    if (walked_ > 0.0 && glm::dot(direction, heading_) < least_kink) return false;
    heading_ = direction;
    return true;
}

/// Goes on into a cell; false where the walk ends before it.
bool ChainWalk::enter(std::uint32_t cell) {
    if (cell == cell_) return true;
    const bool open = wants(cell);
    if (cell_ != no_slot && (!open || length_ > least_piece * mesh_.cell_side)) {
        passed_.push_back({place_, heading_, length_});
        if (join_in(cell)) return false;
        finish_piece(no_slot);
    }
    if (open)
        cell_ = cell;
    else if (chains_.chains[chain_].first != no_slot)
        editor_.wait(chain_, side_, cell, glm::vec3(heading_));
    return open;
}

/// To the end of a step and over the edge there; false where the sheet ends.
bool ChainWalk::advance(const WalkStep& step) {
    length_ += step.length;
    walked_ += step.length;
    place_.weight = step.weight;
    entered_ = WalkStep::inside;
    if (step.edge == WalkStep::inside) return true;
    left_ = {place_, heading_, length_};
    std::uint32_t edge = step.edge;
    if (!geometry::cross_edge(mesh_.sheets, place_, edge, heading_)) return false;
    entered_ = edge;
    return true;
}

/// Over the edge again that the walk has just crossed: where it ends there, its last rib lies on the side it came from.
void ChainWalk::step_back() {
    if (entered_ == WalkStep::inside) return;
    place_ = left_.place;
    heading_ = left_.direction;
}

/// Ends the piece that is under way at the open end of a chain in a cell, when there is one, and joins both chains.
bool ChainWalk::join_in(std::uint32_t cell) {
    const std::uint32_t other = meeting(cell);
    if (other == no_slot) return false;
    const bool at_end = side_ == ChainSide::end;
    finish_piece(editor_.outer_node(other, at_end ? ChainSide::begin : ChainSide::end));
    editor_.join(at_end ? chain_ : other, at_end ? other : chain_);
    ++joined;
    return true;
}

ChainWalk::Passed ChainWalk::on_way(double length) const {
    std::size_t i = 0;
    while (i + 1 < passed_.size() && passed_[i + 1].length <= length) ++i;
    Passed result = passed_[i];
    if (i + 1 == passed_.size()) return result;
    const WalkTriangle triangle(mesh_.sheets, result.place.triangle);
    const double rest = std::max(0.0, length - result.length);
    result.place.weight = geometry::walk_step(triangle, result.place.weight, result.direction, rest).weight;
    result.length = length;
    return result;
}

ShadeRib ChainWalk::rib_at(const Passed& passed) const {
    const ShadeNode& tip = chains_.nodes[tip_];
    const double along = tip.along + sign_ * passed.length;
    ShadeRib rib = make_shade_rib(mesh_, settings_, passed.place, sign_ * passed.direction, along);
    rib.node.random = tip.random;
    return rib;
}

void ChainWalk::finish_piece(std::uint32_t next) {
    if (next == no_slot && length_ < least_length * mesh_.cell_side) return;
    fresh_.clear();
    const std::uint32_t tip = next != no_slot ? next : chains_.nodes.take(rib_at(passed_.back()).node);
    lay(tip_, 0.0, tip, length_, 0);
    shade_piece();
    tip_ = tip;
    length_ = 0.0;
    passed_.clear();
}

/// Where between two lengths the way crosses the edge that lies farthest off the straight line between them; nothing
/// where it crosses none, or is straight.
std::optional<double> ChainWalk::most_bent(double begin, double end) const {
    const auto at = [&](const Passed& passed) {
        return WalkTriangle(mesh_.sheets, passed.place.triangle).at(passed.place.weight);
    };
    const glm::dvec3 from = at(on_way(begin)), way = at(on_way(end)) - from;
    const double square = std::max(glm::dot(way, way), 1e-300), margin = 2.0 * least_length * mesh_.cell_side;
    double most = idle_length * mesh_.size;
    std::optional<double> result;
    for (const Passed& passed : passed_) {
        if (!(passed.length > begin + margin && passed.length < end - margin)) continue;
        const glm::dvec3 off = at(passed) - from;
        const double aside = glm::length(off - glm::dot(off, way) / square * way);
        if (aside <= most) continue;
        most = aside;
        result = passed.length;
    }
    return result;
}

/// Where the patch between two nodes leaves the surface, of the places that are looked at; nothing where it stays near
/// enough.
std::optional<ChainWalk::Division> ChainWalk::division(std::uint32_t from, double begin, std::uint32_t to,
                                                       double end) const {
    const double most = looked_at * settings_.rib_deviation * mesh_.size;
    double off = 0.0;
    const auto part_at = [&](double length) {
        const ShadeRib rib = rib_at(on_way(length));
        const double part = (length - begin) / (end - begin);
        off = patch_deviation(mesh_, chains_.nodes[from], chains_.nodes[to], rib, part);
        return Division{length, rib.node};
    };
    // Where the chain crosses an edge comes first: past it, what is left is divided more evenly.
    if (const std::optional<double> edge = most_bent(begin, end))
        if (const Division part = part_at(*edge); off > most) return part;
    if (const Division part = part_at(std::lerp(begin, end, 0.5)); off > most) return part;
    // A patch that leaves the surface by `most` at one place shows it in its middle, if less.
    if (off < 0.25 * most) return std::nullopt;
    for (const double share : {0.25, 0.75, 0.375, 0.625})
        if (const Division part = part_at(std::lerp(begin, end, share)); off > most) return part;
    return std::nullopt;
}

/// Lays a segment between two nodes, or several where the patch between their ribs would leave the surface.
void ChainWalk::lay(std::uint32_t from, double begin, std::uint32_t to, double end, int depth) {
    if (depth < most_divisions && end - begin > least_divided * mesh_.cell_side) {
        if (const std::optional<Division> part = division(from, begin, to, end)) {
            const std::uint32_t between = chains_.nodes.take(part->node);
            lay(from, begin, between, part->length, depth + 1);
            lay(between, part->length, to, end, depth + 1);
            return;
        }
    }
    const double width = double{chains_.nodes[from].amplitude} + chains_.nodes[to].amplitude;
    const double shade = (end - begin) * width * settings_.density / mesh_.cells.area[cell_];
    fresh_.push_back(editor_.grow(chain_, side_, from, to, cell_, static_cast<float>(shade)));
    editor_.narrow(fresh_.back(), narrowing_.of(chains_.nodes[from], chains_.nodes[to]));
}

/// Draws the piece as strongly as its cell needs and the chain's pen can; a small one no more strongly than a larger
/// one.
void ChainWalk::shade_piece() {
    double shade = 0.0;
    for (const std::uint32_t s : fresh_) shade += chains_.links[s].shade;
    const double missing = double{needed_[cell_]} - chains_.cells[cell_].delivered;
    const double most = chains_.chains[chain_].max_alpha;
    const double alpha = shade > 0.0 ? std::clamp(missing / std::max(shade, least_share), 0.0, most) : 0.0;
    for (const std::uint32_t s : fresh_) editor_.set_alpha(s, static_cast<float>(alpha));
    editor_.refresh(cell_);
}

/// The chain in a cell whose open end the walk has come to, running the same way; or `no_slot`.
std::uint32_t ChainWalk::meeting(std::uint32_t cell) const {
    const glm::dvec3 here = WalkTriangle(mesh_.sheets, place_.triangle).at(place_.weight), along = sign_ * heading_;
    for (std::uint32_t s = chains_.cells[cell].first; s != no_slot; s = chains_.links[s].cell_next) {
        const ShadeSegment& segment = chains_.segments[s];
        const bool open = side_ == ChainSide::end ? segment.before == no_slot : segment.after == no_slot;
        if (!open || segment.chain == chain_) continue;
        const ShadeNode& node = chains_.nodes[side_ == ChainSide::end ? segment.from : segment.to];
        if (glm::distance(mesh_.at(node.rib[2]), here) > join_bend * length_) continue;
        const glm::dvec3 run =
            mesh_.at(chains_.nodes[segment.to].rib[2]) - mesh_.at(chains_.nodes[segment.from].rib[2]);
        if (!(glm::dot(run, along) > join_cosine * glm::length(run))) continue;
        const ShadeChain& other = chains_.chains[segment.chain];
        if (glm::dot(own_.normal, other.normal) < std::cos(0.5f * settings_.chain_turn)) continue;
        if (glm::dot(own_.general, other.general) < 0.5f) continue;
        return segment.chain;
    }
    return no_slot;
}

} // namespace hachure
