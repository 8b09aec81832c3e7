#pragma once

#include <cstddef>

/// What the compiled forms of the skinning loop share.
namespace hachure::geometry::skin_loop {

/// The spans of a SkinJob as bare pointers to the floats of the whole mesh.
struct Arguments {
    const float* rest_positions;
    const float* rest_normals;  ///< or null
    const float* rest_tangents; ///< or null
    const void* joints;
    const float* weights;
    const unsigned* block_firsts; ///< of SkinBlocks, as are the next two
    const unsigned* block_joints;
    const float* block_weights;
    const float* palette; ///< 16 floats per entry: JointMatrix or JointMotion
    float* positions;
    float* normals;
    float* tangents;
    std::size_t first, end;
    float low[3], high[3]; ///< out: bounds of the positions; to be set by the caller
};

using Loop = void (*)(Arguments&);

/// Which of the loops of one instruction set.
struct Variant {
    bool dual_quaternion;
    std::size_t joint_bytes; ///< 1, 2 or 4
    bool eight;              ///< influences per vertex, else four
};

[[nodiscard]] Loop portable_loop(const Variant& variant);
[[nodiscard]] Loop avx2_loop(const Variant& variant);
[[nodiscard]] Loop avx512_loop(const Variant& variant);

/// The normal of one vertex by its blended matrix (3 rows of 4), in double; the rest normal where none is left.
void careful_normal(const float* matrix, const float* rest, float* out);

/// The tangent of one vertex, perpendicular to `normal`; any such direction where none is left. Leaves w, the
/// fourth.
void careful_tangent(const float* matrix, const float* rest, const float* normal, float* out);

} // namespace hachure::geometry::skin_loop
