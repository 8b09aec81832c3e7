#pragma once

#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/skin_palette.h>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace hachure {

/// The shape of a surface in this frame, in place of its mesh's own; systems/deform computes it. In entity space, by
/// vertex of the mesh; without positions, normals and tangents where the GPU makes them.
struct Deformed {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;             ///< unit
    std::vector<glm::vec4> tangents;            ///< empty where the mesh has none
    geometry::Bounds bounds;                    ///< of the positions; somewhat larger where the GPU makes them
    bool on_gpu = false;                        ///< the vertices are in buffers of the GPU alone (GpuMeshes)
    std::vector<geometry::JointMatrix> palette; ///< what its skin did, for what is carried along; empty without one
    std::vector<geometry::JointMotion> motions; ///< the same as motions, with dual quaternions
    std::uint64_t version = 0;                  ///< another one whenever the shape is; no two of a world share one
};

} // namespace hachure
