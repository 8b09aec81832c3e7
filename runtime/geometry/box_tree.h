#pragma once

#include <hachure/runtime/geometry/bounds.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// A binary tree of boxes over boxes (of triangles, say): which of them touch a given one?
class BoxTree {
public:
    /// Empty boxes are never found.
    explicit BoxTree(std::span<const Bounds> boxes);

    /// Calls `visit(i)` for each box i >= `first` that touches `box`, in an order that depends on the boxes alone.
    template <class Visit> void each_touching(const Bounds& box, std::uint32_t first, Visit&& visit) const {
        std::uint32_t stack[64], depth = 0;
        if (!nodes_.empty()) stack[depth++] = 0;
        while (depth > 0) {
            const Node& node = nodes_[stack[--depth]];
            if (node.last < first || !touch(node.box, box)) continue;
            if (node.count == 0) {
                stack[depth++] = node.child + 1;
                stack[depth++] = node.child;
                continue;
            }
            for (std::uint32_t i = node.child; i < node.child + node.count; ++i)
                if (items_[i].index >= first && touch(items_[i].box, box)) visit(items_[i].index);
        }
    }

private:
    struct Node {
        Bounds box;
        std::uint32_t child = 0; ///< the first of two nodes, or of `count` items
        std::uint32_t count = 0; ///< 0 for an inner node
        std::uint32_t last = 0;  ///< the greatest index of a box below
    };
    struct Item {
        Bounds box;
        std::uint32_t index;
    };

    [[nodiscard]] static bool touch(const Bounds& a, const Bounds& b) {
        return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
               a.low.z <= b.high.z && b.low.z <= a.high.z;
    }
    void split(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

    std::vector<Item> items_;
    std::vector<Node> nodes_;
};

} // namespace hachure::geometry
