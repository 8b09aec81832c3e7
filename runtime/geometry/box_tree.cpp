#include <hachure/runtime/geometry/box_tree.h>

#include <algorithm>

namespace hachure::geometry {

BoxTree::BoxTree(std::span<const Bounds> boxes) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].empty()) items_.push_back({boxes[i], i});
    if (items_.empty()) return;
    nodes_.reserve(items_.size());
    nodes_.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(items_.size()));
}

/// Halves the items by the middles of their boxes along the widest axis: the depth stays under 32 whatever they are.
void BoxTree::split(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    Bounds box, middles;
    std::uint32_t last = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
        box.include(items_[i].box);
        middles.include(items_[i].box.center());
        last = std::max(last, items_[i].index);
    }
    nodes_[node] = {box, begin, end - begin, last};
    constexpr std::uint32_t leaf = 4;
    if (end - begin <= leaf) return;
    const glm::vec3 extent = middles.extent();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [axis](const Item& a, const Item& b) {
                         const float at = a.box.low[axis] + a.box.high[axis], bt = b.box.low[axis] + b.box.high[axis];
                         return at != bt ? at < bt : a.index < b.index;
                     });
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].child = child;
    nodes_[node].count = 0;
    nodes_.resize(nodes_.size() + 2);
    split(child, begin, middle);
    split(child + 1, middle, end);
}

} // namespace hachure::geometry
