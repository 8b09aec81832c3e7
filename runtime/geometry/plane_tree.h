#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Finds, among items of a few planes each, those whose planes do not all see an eye from the same side: edges between
/// a front face and a back face, or triangles that the contour of a smooth surface crosses.
///
/// A plane (n, d) is a point in four dimensions, and an eye a hyperplane through their origin that parts front from
/// back (Hertzmann & Zorin 2000, section 4). Items lie in a tree of boxes there; what is altogether on one side of the
/// eye is not looked into. Boxes are tested with room for what floats round, and items are decided by
/// dot(plane, eye) > 0 in floats, so that the answer is that of a plain loop bit for bit.
class PlaneTree {
public:
    static constexpr std::size_t width = 8;                ///< children of a node, items of a block
    static constexpr std::uint32_t flip = 0x80000000u;     ///< in a plane's index: its two sides are exchanged
    static constexpr std::uint32_t left_out = 0xffffffffu; ///< as an item's last index: it is never found

    PlaneTree() = default;

    /// `items` has `per_item` (2 or 3) indices of planes for every item. With `flip` set, which only the second of two
    /// may have, the front of the plane is where dot(plane, eye) > 0 is not true. Planes are finite.
    PlaneTree(std::span<const glm::vec4> planes, std::span<const std::uint32_t> items, std::size_t per_item);

    /// Takes other planes for the same items. It answers exactly whatever they are, and fast while planes near each
    /// other stay so. On several threads; allocates nothing.
    void refit(std::span<const glm::vec4> planes);

    [[nodiscard]] std::size_t size() const { return item_count_; } ///< items, those left out included
    [[nodiscard]] std::size_t per_item() const { return per_item_; }
    [[nodiscard]] std::size_t bytes() const; ///< of memory

    /// 64 items.
    struct Bits {
        std::uint64_t found = 0;
        std::uint64_t front = 0; ///< of those found: the first plane's front is seen
    };

    /// Kept by the caller from query to query, for one tree at a time.
    struct Scratch {
        std::vector<std::uint32_t> nodes{}, next{};
        std::vector<Bits> bits{};                       ///< all zero between queries
        std::vector<std::uint64_t> touched{};           ///< a bit per element of `bits`; likewise
        std::size_t tested_nodes = 0, tested_items = 0; ///< out: how much was looked at
    };

    /// Calls `visit(item, front)` for each item found, by rising items. No allocation after the first query.
    template <class Visit> void query(const glm::vec4& eye, Scratch& scratch, Visit&& visit) const {
        mark(eye, scratch);
        for (std::size_t t = 0; t < scratch.touched.size(); ++t) {
            for (std::uint64_t words = scratch.touched[t]; words != 0; words &= words - 1) {
                const std::size_t word = 64 * t + static_cast<std::size_t>(__builtin_ctzll(words));
                const Bits bits = scratch.bits[word];
                scratch.bits[word] = {};
                for (std::uint64_t left = bits.found; left != 0; left &= left - 1) {
                    const int bit = __builtin_ctzll(left);
                    visit(static_cast<std::uint32_t>(64 * word + static_cast<std::size_t>(bit)),
                          ((bits.front >> bit) & 1u) != 0);
                }
            }
            scratch.touched[t] = 0;
        }
    }

private:
    /// Boxes of `width` children, by side (low, high) and element.
    struct alignas(64) Boxes {
        float side[2][4][width];
    };
    /// A plane of each of `width` items, by element.
    struct alignas(64) Planes {
        float element[4][width];
    };
    /// The largest elements of all planes, which say how much can be rounded.
    struct Largest {
        float normal = 0.0f, distance = 0.0f, from_center = 0.0f;

        void include(const Largest& other);
    };

    void mark(const glm::vec4& eye, Scratch& scratch) const;
    template <std::size_t planes_of_item>
    void mark_blocks(const glm::vec4& eye, std::span<const std::uint32_t> blocks, Scratch& scratch) const;
    [[nodiscard]] float slack(const glm::vec4& eye, const glm::vec4& from_center) const;
    void sort_items(std::span<const glm::vec4> planes, std::span<const std::uint32_t> items);
    void fit_block(std::size_t block, std::span<const glm::vec4> planes, Largest& largest);
    void fit_node(std::size_t level, std::size_t node);

    std::size_t item_count_ = 0, per_item_ = 2;
    glm::dvec3 center_{0.0}; ///< boxes are of planes relative to here, where their d is small
    Largest largest_;
    std::vector<std::uint32_t> items_{};       ///< by place in the tree: which item; `left_out` where there is none
    std::vector<std::uint32_t> indices_{};     ///< by place, `per_item_` each: which planes
    std::vector<Planes> planes_{};             ///< by block, `per_item_` each
    std::vector<std::uint8_t> flips_{};        ///< by block: a bit per item whose second plane is flipped
    std::vector<std::uint8_t> used_{};         ///< by block: a bit per item that there is
    std::vector<std::vector<Boxes>> levels_{}; ///< [0]: of blocks; the last has one element
};

} // namespace hachure::geometry
