#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/plane_tree.h>
#include <hachure/runtime/parallel.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hachure::geometry {
namespace {

constexpr std::size_t width = PlaneTree::width;
constexpr std::size_t chunk = 2048; ///< blocks or nodes that one task fits

std::size_t groups(std::size_t count, std::size_t size) { return (count + size - 1) / size; }

/// Where planes come nearest to in the least squares: relative to it they have the smallest distances, so that boxes
/// are small. A little pull towards the origin decides where planes leave it open.
glm::dvec3 common_point(std::span<const glm::vec4> planes) {
    glm::dmat3 squares(0.0);
    glm::dvec3 right(0.0);
    for (const glm::vec4& plane : planes) {
        const glm::dvec3 n(plane);
        for (int i = 0; i < 3; ++i) squares[i] += n[i] * n;
        right -= static_cast<double>(plane.w) * n;
    }
    const double pull = 1e-9 * (squares[0][0] + squares[1][1] + squares[2][2]);
    if (!(pull > 0.0)) return glm::dvec3(0.0);
    for (int i = 0; i < 3; ++i) squares[i][i] += pull;
    return glm::inverse(squares) * right;
}

/// What items are sorted by: the middle of their planes, and how far these are apart. Distances count in units of the
/// mesh's size, and half: an eye that sees all of it is that much farther away than it is wide.
struct Key {
    std::array<float, 5> at;
    std::uint32_t item;
};

int widest(std::span<const Key> keys) {
    std::array<float, 5> low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (const Key& key : keys)
        for (std::size_t i = 0; i < 5; ++i) {
            low[i] = std::min(low[i], key.at[i]);
            high[i] = std::max(high[i], key.at[i]);
        }
    std::size_t best = 0;
    for (std::size_t i = 1; i < 5; ++i)
        if (high[i] - low[i] > high[best] - low[best]) best = i;
    return static_cast<int>(best);
}

/// Sorts keys so that each run of `width`, of `width` runs, and so on are near each other. `span` is the size of a
/// child.
void sort_near(std::span<Key> keys, std::size_t span) {
    if (keys.size() <= width) return;
    const std::size_t children = groups(keys.size(), span);
    if (children == 1) return sort_near(keys, span / width);
    const std::size_t middle = children / 2 * span;
    const auto axis = static_cast<std::size_t>(widest(keys));
    // Ties are broken by the item, so that the tree does not depend on the library's way to select.
    std::nth_element(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(middle), keys.end(),
                     [axis](const Key& a, const Key& b) {
                         return a.at[axis] != b.at[axis] ? a.at[axis] < b.at[axis] : a.item < b.item;
                     });
    const std::span<Key> halves[2] = {keys.first(middle), keys.subspan(middle)};
    if (keys.size() < 32768) {
        for (const std::span<Key>& half : halves) sort_near(half, span);
    } else {
        parallel_for(2, [&](std::size_t i) { sort_near(halves[i], span); });
    }
}

/// Calls `body(i)` for all below `count` on several threads, in chunks.
template <class Body> void for_each_chunked(std::size_t count, Body&& body) {
    parallel_for(groups(count, chunk), [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min(count, (c + 1) * chunk); ++i) body(i);
    });
}

} // namespace

void PlaneTree::Largest::include(const Largest& other) {
    normal = std::max(normal, other.normal);
    distance = std::max(distance, other.distance);
    from_center = std::max(from_center, other.from_center);
}

PlaneTree::PlaneTree(std::span<const glm::vec4> planes, std::span<const std::uint32_t> items, std::size_t per_item)
    : item_count_(items.size() / per_item), per_item_(per_item) {
    HACHURE_ASSERT(per_item == 2 || per_item == 3, "items of two or three planes");
    HACHURE_ASSERT(items.size() % per_item == 0 && planes.size() < flip, "whole items");
    center_ = common_point(planes);
    sort_items(planes, items);
    const std::size_t blocks = groups(items_.size(), width);
    items_.resize(blocks * width, left_out);
    indices_.resize(blocks * width * per_item_);
    for (std::size_t at = 0; at < items_.size(); ++at)
        for (std::size_t k = 0; k < per_item_; ++k)
            indices_[at * per_item_ + k] = items_[at] == left_out ? 0u : items[items_[at] * per_item_ + k];
    planes_.resize(blocks * per_item_);
    flips_.resize(blocks, 0);
    used_.resize(blocks, 0);
    for (std::size_t at = 0; at < items_.size(); ++at)
        if (items_[at] != left_out)
            used_[at / width] = static_cast<std::uint8_t>(used_[at / width] | (1u << (at % width)));
    for (std::size_t nodes = blocks; nodes > 0; nodes = groups(nodes, width)) {
        // Room for the children of each: the last level has one element, of the root's children.
        levels_.emplace_back(groups(nodes, width));
        if (nodes <= width) break;
    }
    refit(planes);
}

void PlaneTree::sort_items(std::span<const glm::vec4> planes, std::span<const std::uint32_t> items) {
    double size = 0.0;
    for (const glm::vec4& plane : planes)
        size = std::max(size, std::abs(static_cast<double>(plane.w) + glm::dot(glm::dvec3(plane), center_)));
    const double unit = size > 0.0 ? 0.5 / size : 0.0;
    std::vector<Key> keys;
    keys.reserve(item_count_);
    for (std::size_t item = 0; item < item_count_; ++item) {
        if (items[item * per_item_ + per_item_ - 1] == left_out) continue;
        glm::dvec4 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
        for (std::size_t k = 0; k < per_item_; ++k) {
            const std::uint32_t index = items[item * per_item_ + k];
            const glm::dvec4 plane(planes[index & ~flip]);
            const glm::dvec4 point(glm::dvec3(plane), unit * (plane.w + glm::dot(glm::dvec3(plane), center_)));
            const glm::dvec4 seen = (index & flip) != 0 ? -point : point;
            low = glm::min(low, seen);
            high = glm::max(high, seen);
        }
        const glm::vec4 middle(0.5 * (low + high));
        const auto apart = static_cast<float>(0.5 * glm::length(high - low));
        keys.push_back({{middle.x, middle.y, middle.z, middle.w, apart}, static_cast<std::uint32_t>(item)});
    }
    std::size_t span = width;
    while (span * width < keys.size()) span *= width;
    sort_near(keys, span);
    items_.resize(keys.size());
    for (std::size_t at = 0; at < keys.size(); ++at) items_[at] = keys[at].item;
}

void PlaneTree::refit(std::span<const glm::vec4> planes) {
    if (levels_.empty()) return;
    const std::size_t blocks = flips_.size();
    const std::size_t tasks = groups(blocks, chunk);
    std::vector<Largest> largest(tasks);
    parallel_for(tasks, [&](std::size_t task) {
        for (std::size_t block = task * chunk; block < std::min(blocks, (task + 1) * chunk); ++block)
            fit_block(block, planes, largest[task]);
    });
    largest_ = {};
    for (const Largest& part : largest) largest_.include(part);
    std::size_t nodes = blocks;
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        nodes = groups(nodes, width);
        for_each_chunked(nodes, [&](std::size_t node) { fit_node(level, node); });
    }
}

/// Gathers the planes of a block and puts the box around them into its parent.
void PlaneTree::fit_block(std::size_t block, std::span<const glm::vec4> planes, Largest& largest) {
    glm::vec4 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
    for (std::size_t lane = 0; lane < width; ++lane) {
        const std::size_t at = block * width + lane;
        const bool empty = items_[at] == left_out;
        for (std::size_t k = 0; k < per_item_; ++k) {
            const std::uint32_t index = indices_[at * per_item_ + k];
            const glm::vec4 plane = empty ? glm::vec4(0.0f) : planes[index & ~flip];
            for (int i = 0; i < 4; ++i) planes_[block * per_item_ + k].element[i][lane] = plane[i];
            if (empty) continue;
            const auto distance =
                static_cast<float>(static_cast<double>(plane.w) + glm::dot(glm::dvec3(plane), center_));
            largest.include({std::max({std::abs(plane.x), std::abs(plane.y), std::abs(plane.z)}), std::abs(plane.w),
                             std::abs(distance)});
            glm::vec4 seen(glm::vec3(plane), distance);
            if ((index & flip) != 0) {
                seen = -seen;
                flips_[block] = static_cast<std::uint8_t>(flips_[block] | (1u << lane));
            }
            low = glm::min(low, seen);
            high = glm::max(high, seen);
        }
    }
    Boxes& boxes = levels_[0][block / width];
    for (int i = 0; i < 4; ++i) {
        boxes.side[0][i][block % width] = low[i];
        boxes.side[1][i][block % width] = high[i];
    }
}

/// Puts the box around the children of a node of a level into its parent there.
void PlaneTree::fit_node(std::size_t level, std::size_t node) {
    const Boxes& children = levels_[level - 1][node];
    const std::size_t below = level == 1 ? flips_.size() : levels_[level - 2].size();
    const std::size_t count = std::min(width, below - node * width);
    Boxes& boxes = levels_[level][node / width];
    for (int i = 0; i < 4; ++i) {
        boxes.side[0][i][node % width] = *std::min_element(children.side[0][i], children.side[0][i] + count);
        boxes.side[1][i][node % width] = *std::max_element(children.side[1][i], children.side[1][i] + count);
    }
}

std::size_t PlaneTree::bytes() const {
    std::size_t boxes = 0;
    for (const std::vector<Boxes>& level : levels_) boxes += level.size() * sizeof(Boxes);
    return boxes + planes_.size() * sizeof(Planes) + flips_.size() + used_.size() +
           (items_.size() + indices_.size()) * sizeof(std::uint32_t);
}

} // namespace hachure::geometry
