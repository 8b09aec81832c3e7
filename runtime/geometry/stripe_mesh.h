#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// How the streaks of brushed metal are laid on a surface.
struct StripeSettings {
    /// Sets of stripes per half turn of the surface's normal across the streaks, where it is curved, and across the
    /// object's size (the diagonal of its bounds), where it is flat. Sheets whose direction field has n singularities
    /// get sqrt(n) times as many, at most 5 times, and up to twice that where flat: a coordinate needs room to turn
    /// between them. Positive.
    double sets = 1.0;
    /// The least detail whose curvature counts, over the size of each smooth part: curvature is smoothed to this
    /// length.
    double detail = 0.1;
    /// Radians. The surface is cut along an edge where its faces turn by more than this and its normals are not shared:
    /// every side has streaks of its own, as parts milled apart have.
    double crease_angle = 0.6;
};

/// A mesh with a coordinate that counts sets of stripes across the streaks (Knoeppel et al. 2013 and 2015).
///
/// The coordinate is meant for a pattern that is even and of period 2: what is drawn at u depends on the distance of u
/// from the nearest even number, so that it holds one set from 0 to 1 and its mirror image from 1 to 2. Two triangles
/// at an edge agree up to the sign of u and a multiple of 2, hence in what is drawn; vertices are repeated where they
/// differ in u itself.
///
/// The first vertices are those of the input in their order; the others are repeated ones.
struct StripeMesh {
    std::vector<std::uint32_t> source_vertex; ///< per vertex: the vertex of the input that it lies on
    std::vector<std::uint32_t> indices;       ///< 3 per triangle, in the order of the input
    std::vector<float> coordinate;            ///< u per vertex, in sets; finite, and at most 1e5 in size
    /// Per vertex in [0, 1]: how much of the pattern is drawn. 0 at the corners of singular triangles, where there is
    /// no coordinate, and 1 elsewhere: the pattern fades to its mean around a singularity.
    std::vector<float> weight;
    /// Per vertex: the first vertex that is the same point of the same smooth sheet of surface, itself for most.
    std::vector<std::uint32_t> stands_for;
    /// Per vertex: 1 where its u falls when that of the vertex that stands for it rises.
    std::vector<std::uint8_t> mirrored;
    /// Per vertex: the normal without the bumps of the surface, where the drawn normal n is (0, 0, 1), X of
    /// StripeFramesJob (1, 0, 0) and n x X (0, 1, 0). Unit.
    std::vector<glm::vec3> lean;
    /// Per vertex in [0, 1]: how clear it is which stripe faces a light. 0 near singularities, where stripes turn
    /// round, and where they are much wider than they were to be.
    std::vector<float> clarity;

    [[nodiscard]] bool operator==(const StripeMesh&) const = default;
};

/// Lays streaks on any mesh: they follow the direction of least curvature (in absolute value) where there is one, and
/// elsewhere run smoothly from there or, on spheres and planes, along the object's Y axis; on faces across that axis
/// along X. See docs/stripes.md.
///
/// `normals` (unit, one per vertex) tell which edges are hard; without them the angle alone does. `indices` hold 3 per
/// triangle, in range; positions are finite. Whatever else is wrong with the mesh (borders, edges with many triangles,
/// triangles without an area, repeated triangles), the result is finite. Triangles without an area get weight 0.
///
/// The result is a function of the arguments alone, bit by bit; a change of the positions in their last bits moves it
/// little.
[[nodiscard]] StripeMesh make_stripe_mesh(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                          std::span<const std::uint32_t> indices, const StripeSettings& settings = {});

} // namespace hachure::geometry
