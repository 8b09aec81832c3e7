#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// A mesh with tangents. The first vertices are those of the input in their order; a vertex where mirrored and
/// unmirrored texture meet is repeated at the end.
struct ComputedTangents {
    std::vector<glm::vec4> tangents;    ///< xyz: unit, perpendicular to the normal, towards growing u; w: +-1
    std::vector<std::uint32_t> source;  ///< per vertex: the vertex of the input to take every other attribute from
    std::vector<std::uint32_t> indices; ///< 3 per triangle, in the order of the input
};

/// Tangents of a surface for normal maps, in glTF's convention: v grows downwards in the picture, and the bitangent
/// w * cross(normal, tangent) points up in it. `normals` are unit; all attributes are finite, one per vertex.
///
/// They are MikkTSpace's: per corner, the triangle's direction of growing u is projected onto the plane of the vertex
/// normal and weighted with the corner's angle there, and summed over the triangles that share position, normal,
/// texture coordinate and handedness, whatever vertices they use. There are three differences. Triangles are summed
/// even when no edge connects them, which matters only where fans touch in one point. Triangles whose texture has no
/// area take the tangent of their vertex, the unmirrored one where there are two. Where nothing says what the tangent
/// is, it is some vector perpendicular to the normal instead of zero.
[[nodiscard]] ComputedTangents vertex_tangents(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                               std::span<const glm::vec2> texcoords,
                                               std::span<const std::uint32_t> indices);

} // namespace hachure::geometry
