#pragma once

#include <hachure/runtime/geometry/edges.h>
#include <hachure/runtime/geometry/topology.h>

namespace hachure::geometry {

/// Joins the neighbours of triangles without an area in a finished list of edges, as edges.h promises, and returns how
/// many were bridged. A sliver stays when one of its edges is non-manifold, or when its long edge was that of another
/// sliver: then there is no telling which neighbour lies behind which part of it.
std::uint32_t bridge_slivers(std::span<const glm::vec3> positions, const WeldedTriangles& triangles,
                             std::vector<Edge>& edges);

} // namespace hachure::geometry
