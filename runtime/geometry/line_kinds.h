#pragma once

#include <cstdint>

namespace hachure::geometry {

/// Why a line is drawn, and which of an edge's faces its eye sees from the front; to be combined.
enum LineKind : std::uint32_t {
    line_silhouette = 1u, ///< between a front face and a back face
    line_crease = 2u,     ///< faces meet at an angle
    line_border = 4u,     ///< one face only
    line_material = 8u,   ///< faces of different materials
    line_front0 = 16u,    ///< `face0` of the edge is seen from the front
    line_front1 = 32u,    ///< `face1` is; turned over where the two disagree about their sides
};

/// The kinds that a mesh has whatever it is seen from.
inline constexpr std::uint32_t line_features = line_crease | line_border | line_material;

/// An edge that is drawn.
struct ChosenEdge {
    std::uint32_t edge;  ///< into the edges of an EdgeTable
    std::uint32_t kinds; ///< LineKind

    friend bool operator==(const ChosenEdge&, const ChosenEdge&) = default;
};

} // namespace hachure::geometry
