#pragma once

#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/geometry/line_kinds.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Lines that a mesh has whatever it is seen from. Found once, chosen from every frame.
namespace hachure::geometry {

/// Marks the edges whose faces meet at more than `crease_angle` (radians between their normals), one byte per edge.
/// Noise on dense surfaces makes single edges that sharp; they are left out: creases that hang together are kept when
/// they are `long_crease` times the size of the mesh (the diagonal of its bounds) in all, or when they are
/// `short_crease` times that size and have `min_crease_edges` edges. `noise` in [0, 1] scales the three; with 0 the
/// angle alone decides.
[[nodiscard]] std::vector<std::uint8_t> find_creases(std::span<const glm::vec3> positions, std::span<const Edge> edges,
                                                     std::span<const glm::vec4> planes, float crease_angle,
                                                     float noise = 1.0f);
inline constexpr std::size_t min_crease_edges = 6;
inline constexpr float long_crease = 0.06f;
inline constexpr float short_crease = 0.01f;

/// Marks the edges whose two faces have different materials, one byte per edge. `face_materials` has one element per
/// triangle.
[[nodiscard]] std::vector<std::uint8_t> find_material_edges(std::span<const Edge> edges,
                                                            std::span<const std::uint32_t> face_materials);

/// The edges that are creases, borders or between materials, ascending, with those kinds: what the jobs that choose
/// edges take. `creases` and `materials` have one byte per edge, not 0 for yes, or are empty.
[[nodiscard]] std::vector<ChosenEdge> feature_edges(std::span<const Edge> edges, std::span<const std::uint8_t> creases,
                                                    std::span<const std::uint8_t> materials);

} // namespace hachure::geometry
