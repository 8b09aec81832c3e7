#include <hachure/runtime/geometry/plane_tree.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace hachure::geometry {
namespace {

using Quad = float __attribute__((vector_size(16)));
using QuadBits = int __attribute__((vector_size(16)));

Quad load(const float* from) {
    Quad value;
    __builtin_memcpy(&value, from, sizeof value);
    return value;
}

/// What is asked for this many nodes before it is needed has come by then.
constexpr std::size_t ahead = 12;

template <class T> void prefetch(const T& object) {
    for (std::size_t line = 0; line < sizeof object; line += 64)
        __builtin_prefetch(reinterpret_cast<const char*>(&object) + line);
}

/// A bit per lane that is set.
std::uint32_t mask_of(const QuadBits& flags) {
#if defined(__SSE__)
    return static_cast<std::uint32_t>(__builtin_ia32_movmskps(reinterpret_cast<Quad>(flags)));
#else
    return (flags[0] & 1u) | (flags[1] & 2u) | (flags[2] & 4u) | (flags[3] & 8u);
#endif
}

/// What `glm::dot(plane, eye)` computes, in its order, so that nothing is rounded differently.
Quad dot(const float (*element)[PlaneTree::width], std::size_t lane, const glm::vec4& eye) {
    const Quad x = load(element[0] + lane) * eye.x, y = load(element[1] + lane) * eye.y;
    const Quad z = load(element[2] + lane) * eye.z, w = load(element[3] + lane) * eye.w;
    return (x + y) + (z + w);
}

} // namespace

/// How far a sum over the elements of a plane, of a box or as given, can be from the exact one: each has 4 products and
/// 3 sums, and the eye and the distance relative to the centre are rounded first. That is 6 ulps at most for each.
float PlaneTree::slack(const glm::vec4& eye, const glm::vec4& from_center) const {
    const auto reach = [&](const glm::vec4& e, float distance) {
        return largest_.normal * (std::abs(e.x) + std::abs(e.y) + std::abs(e.z)) + distance * std::abs(e.w);
    };
    const float ulps = 16.0f * 0x1p-24f;
    return ulps * (reach(eye, largest_.distance) + reach(from_center, largest_.from_center)) + 1e-36f;
}

/// Level by level from the root: all nodes of one that the eye's hyperplane passes through.
void PlaneTree::mark(const glm::vec4& eye, Scratch& scratch) const {
    scratch.tested_nodes = scratch.tested_items = 0;
    scratch.bits.resize((item_count_ + 63) / 64);
    scratch.touched.resize((scratch.bits.size() + 63) / 64);
    if (levels_.empty()) return;
    scratch.nodes.resize(flips_.size() + width);
    scratch.next.resize(flips_.size() + width);

    // Of each element, the side of a box on which its sum with the eye is least, and most.
    const glm::vec4 from_center(glm::dvec4(glm::dvec3(eye) - static_cast<double>(eye.w) * center_, eye.w));
    const float room = slack(eye, from_center);
    std::size_t least_side[4], most_side[4];
    for (int i = 0; i < 4; ++i) {
        least_side[i] = from_center[i] > 0.0f ? 0 : 1;
        most_side[i] = 1 - least_side[i];
    }
    std::size_t count = 1;
    scratch.nodes[0] = 0;
    for (std::size_t level = levels_.size(); level-- > 0;) {
        const std::size_t children = level == 0 ? flips_.size() : levels_[level - 1].size();
        std::size_t found = 0;
        for (std::size_t n = 0; n < count; ++n) {
            const Boxes& boxes = levels_[level][scratch.nodes[n]];
            if (n + ahead < count) prefetch(levels_[level][scratch.nodes[n + ahead]]);
            std::uint32_t through = 0;
            for (std::size_t lane = 0; lane < width; lane += 4) {
                Quad least{}, most{};
                for (int i = 0; i < 4; ++i) {
                    least += load(boxes.side[least_side[i]][i] + lane) * from_center[i];
                    most += load(boxes.side[most_side[i]][i] + lane) * from_center[i];
                }
                // Written so that what is not a number is looked into.
                through |= (~mask_of(least > room) & ~mask_of(most < -room) & 15u) << lane;
            }
            const std::uint32_t first = scratch.nodes[n] * static_cast<std::uint32_t>(width);
            for (; through != 0; through &= through - 1) {
                const std::uint32_t child = first + static_cast<std::uint32_t>(std::countr_zero(through));
                if (child < children) scratch.next[found++] = child;
            }
        }
        scratch.tested_nodes += count * width;
        std::swap(scratch.nodes, scratch.next);
        count = found;
    }
    scratch.tested_items = count * width;
    for (std::size_t n = 0; n < count; ++n) {
        if (n + ahead < count) {
            const std::size_t block = scratch.nodes[n + ahead];
            for (std::size_t k = 0; k < per_item_; ++k) prefetch(planes_[block * per_item_ + k]);
            prefetch(items_[block * width]);
        }
        mark_block(eye, scratch.nodes[n], scratch);
    }
}

void PlaneTree::mark_block(const glm::vec4& eye, std::size_t block, Scratch& scratch) const {
    const Planes* planes = &planes_[block * per_item_];
    std::uint32_t front[3] = {0, 0, 0};
    for (std::size_t k = 0; k < per_item_; ++k)
        for (std::size_t lane = 0; lane < width; lane += 4)
            front[k] |= mask_of(dot(planes[k].element, lane, eye) > 0.0f) << lane;
    front[1] ^= flips_[block];
    if (per_item_ == 2) front[2] = front[1];
    std::uint32_t found = (front[0] | front[1] | front[2]) & ~(front[0] & front[1] & front[2]);
    for (; found != 0; found &= found - 1) {
        const int lane = std::countr_zero(found);
        const std::uint32_t item = items_[block * width + static_cast<std::size_t>(lane)];
        if (item == left_out) continue;
        const std::uint64_t bit = std::uint64_t{1} << (item % 64);
        Bits& bits = scratch.bits[item / 64];
        bits.found |= bit;
        if (((front[0] >> lane) & 1u) != 0) bits.front |= bit;
        scratch.touched[item / 4096] |= std::uint64_t{1} << (item / 64 % 64);
    }
}

} // namespace hachure::geometry
