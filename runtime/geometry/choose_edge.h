#pragma once

#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/geometry/line_kinds.h>

#include <cstdint>

/// What the jobs that choose edges say of one edge.
namespace hachure::geometry {

inline constexpr std::uint32_t line_kinds = line_silhouette | line_features;

/// line_front0 and line_front1 of an edge by `front(face)`.
template <class Fronts> [[nodiscard]] inline std::uint32_t facing(const Edge& edge, const Fronts& front) {
    const std::uint32_t front0 = front(edge.face0) ? line_front0 : 0u;
    if (edge.face1 == no_face) return front0;
    // Where the two faces disagree which side is the front, one of them is read the other way round.
    const bool mismatch = (edge.flags & edge_orientation_mismatch) != 0;
    return front0 | (front(edge.face1) != mismatch ? line_front1 : 0u);
}

/// The kinds that an edge is drawn as; no bit of `line_kinds` for none.
struct ChooseEdge {
    std::uint32_t wanted;
    bool closed;

    /// `features`: which of them it is; `facing`: line_front0 and line_front1. An edge with one face is a border, and
    /// so no silhouette.
    [[nodiscard]] std::uint32_t operator()(std::uint32_t features, std::uint32_t facing, bool border) const {
        const bool differ = facing == line_front0 || facing == line_front1;
        std::uint32_t kinds = features & wanted;
        if (differ && !border) kinds |= line_silhouette & wanted;
        if (closed && facing == 0) kinds &= ~static_cast<std::uint32_t>(line_features);
        return kinds | facing;
    }
};

} // namespace hachure::geometry
