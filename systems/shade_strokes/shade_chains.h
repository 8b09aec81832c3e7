#pragma once

#include <hachure/systems/shade_strokes/slot_array.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

/// The strokes of a shaded surface as data (Sorman & Hult 2005, sections 2.1 and 2.3.3): chains of segments along which
/// zigzag strokes are drawn. Made and kept up by ShadeUpdateJob, drawn by the GPU.
namespace hachure {

/// A point that rides on a mesh, however that deforms.
struct SurfacePoint {
    std::uint32_t triangle; ///< of the mesh: its position in the indices / 3
    float u, v;             ///< weights of the triangle's corners 1 and 2; that of corner 0 is 1 - u - v
};

inline constexpr std::size_t rib_points = 5;

/// A place of a chain, and points of the surface beside it, so that strokes hug the surface.
struct ShadeNode {
    /// From the right of the chain to its left, as seen against the surface's normal: at U = -1, bend[0], 0,
    /// bend[1], 1. The outer ones are `amplitude` away from the middle along the surface, or where it ends or turns
    /// away before that. In between the surface is about straight.
    SurfacePoint rib[rib_points];
    float bend[2];   ///< where the surface bends most between the middle and an outer point: in (-1, 0) and in (0, 1)
    float amplitude; ///< mean distance of the two outer points, in the mesh's units, along the surface; finite
    /// Length of the chain from where it was begun, in the mesh's units; negative before that. It rises along a chain,
    /// but for segments that joined two chains: each part keeps its own count, so that its strokes stay as they are.
    float along;
    std::uint32_t random; ///< the same for all nodes that were laid one from another: which zigzag they share
};

/// A piece of a chain, within one cell. Dead slots have `cell == no_slot` and alpha 0.
struct ShadeSegment {
    std::uint32_t from, to;      ///< nodes
    std::uint32_t before, after; ///< segments beside it in the chain, or `no_slot`
    std::uint32_t cell, chain;
    float alpha;          ///< how strongly its strokes are drawn, in [0, 1]
    std::uint32_t random; ///< a random number that stays while the segment lives
};

/// What only the update needs to know of a segment.
struct ShadeSegmentLinks {
    std::uint32_t cell_previous, cell_next; ///< segments beside it in its cell's list, or `no_slot`
    float shade;                            ///< that it delivers to its cell at alpha 1, as narrow as it is now
    float laid;                             ///< the same with all of its amplitude
    float max_alpha;                        ///< the pressure of the pen that drew it, in (0, 1]
};

/// An end of a chain that could go on: it waits in the list of the cell that it would go on into.
struct ShadeEnd {
    std::uint32_t cell = no_slot;                     ///< `no_slot`: it can't go on
    std::uint32_t previous = no_slot, next = no_slot; ///< ends beside it in that list: 2 * chain + side
    glm::vec3 heading{0.0f};                          ///< unit; where it would go on to
};

/// Segments one behind the other. Dead slots have `first == no_slot`.
struct ShadeChain {
    std::uint32_t first = no_slot, last = no_slot; ///< segments
    glm::vec3 general{0.0f};                       ///< where it was begun to, unit: no segment runs against it
    glm::vec3 normal{0.0f};                        ///< of the surface where it was begun, unit
    std::uint64_t random = 0;                      ///< its own stream of random numbers
    float max_alpha = 1.0f;                        ///< the pressure of its pen, in (0, 1]
    ShadeEnd end[2];                               ///< its begin, its end
};

/// What a cell holds.
struct ShadeCellState {
    std::uint32_t first = no_slot; ///< segment: the head of its list
    std::uint32_t ends = no_slot;  ///< the head of the list of ends that could go on into it: 2 * chain + side
    float delivered = 0.0f;        ///< shade: the sum of alpha * shade of its segments
    float unmet = -1.0f;           ///< the need that it could not meet, so that it is not tried again; or -1
};

/// All strokes of a surface.
struct ShadeChains {
    SlotArray<ShadeNode> nodes;
    SlotArray<ShadeSegment> segments;
    std::vector<ShadeSegmentLinks> links; ///< per slot of segments
    SlotArray<ShadeChain> chains;
    std::vector<ShadeCellState> cells; ///< per cell of the ShadeMesh
    std::uint64_t born = 0;            ///< chains begun so far: the counter of their random numbers
};

} // namespace hachure
