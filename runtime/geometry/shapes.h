#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

/// Shapes with closed-form normals: fixtures, samples, ground truth. Computed in double and rounded once. Centred on
/// the origin, axis along +Y, front faces outwards and counter-clockwise, lengths in metres. Texture coordinates run
/// over [0, 1]; vertices are repeated at their seams and on hard edges.
namespace hachure::geometry {

struct Shape {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< unit
    std::vector<glm::vec2> texcoords;
    std::vector<std::uint32_t> indices; ///< 3 per triangle
};

/// Meridians and parallels; `slices` >= 3 around, `stacks` >= 2 from pole to pole.
[[nodiscard]] Shape uv_sphere(double radius, std::uint32_t slices, std::uint32_t stacks);

/// An icosahedron subdivided `level` <= 8 times (20 * 4^level triangles), all vertices on the sphere, none repeated;
/// texture coordinates are longitude and latitude, and wrap within triangles at the seam.
[[nodiscard]] Shape icosphere(double radius, std::uint32_t level);

/// A tube of radius `minor` around a circle of radius `major` > minor: `around` >= 3 sections of `across` >= 3 corners.
[[nodiscard]] Shape torus(double major, double minor, std::uint32_t around, std::uint32_t across);

/// The same surface on an irregular mesh: every vertex moved on the torus by up to `jitter` of a cell (in [0, 0.45]),
/// every quad cut along a diagonal drawn by `seed`. Vertices are not repeated, so the mesh is closed; texture
/// coordinates wrap within triangles at the seams.
[[nodiscard]] Shape irregular_torus(double major, double minor, std::uint32_t around, std::uint32_t across,
                                    double jitter, std::uint32_t seed);

/// Closed by two discs; `slices` >= 3.
[[nodiscard]] Shape cylinder(double radius, double height, std::uint32_t slices);

/// Closed by a disc below; `slices` >= 3. The tip is repeated for every slice, with the normal of its middle.
[[nodiscard]] Shape cone(double radius, double height, std::uint32_t slices);

/// A square in y = 0 that faces +Y, with `cells` >= 1 quads a side.
[[nodiscard]] Shape plane(double size, std::uint32_t cells);

/// Six squares with normals of their own.
[[nodiscard]] Shape cube(double size);

} // namespace hachure::geometry
