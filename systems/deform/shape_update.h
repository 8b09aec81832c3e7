#pragma once

#include <hachure/components/deform.h>
#include <hachure/components/deformed.h>
#include <hachure/runtime/geometry/normals.h>
#include <hachure/runtime/geometry/skin.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// What a surface was last deformed by, and memory that is kept from frame to frame.
struct DeformState {
    bool made = false; ///< there is a shape
    std::uint32_t mesh = 0;
    Deform settings;
    std::vector<geometry::JointMatrix> palette; ///< empty without a skin
    std::vector<geometry::JointMotion> motions; ///< for dual quaternions
    std::vector<float> weights;                 ///< of the morph targets; empty without any
    std::vector<glm::vec3> morphed_positions;   ///< what is skinned, where a mesh morphs as well
    std::vector<glm::vec3> morphed_normals;
    std::vector<glm::vec4> morphed_tangents;
    geometry::SmoothNormalsJob normals;
};

/// One surface that is to be deformed: `prepare` says whether there is anything to do; then `resize`, `run` over ranges
/// of its vertices, on any thread, and `finish`.
class ShapeUpdate {
public:
    /// All must outlive this.
    ShapeUpdate(const SurfaceMesh& mesh, DeformState& state) : mesh_(&mesh), state_(&state) {}

    /// Takes in what the shape follows from: the palette of the joints where they are now (empty without a skin; what
    /// the state had is swapped in), and the weights of the morph targets (empty without any). False when that is what
    /// the state was made from already.
    bool prepare(std::uint32_t mesh_index, const Deform& settings, std::span<const float> weights,
                 std::vector<geometry::JointMatrix>& palette);

    /// Where the result goes.
    void resize(Deformed& shape);

    /// How many ranges there are.
    [[nodiscard]] std::size_t ranges() const { return bounds_.size(); }

    void run(std::size_t range);

    /// When all ranges are done. `version` is the new shape's.
    void finish(std::uint64_t version);

    [[nodiscard]] std::size_t vertices() const { return mesh_->positions.size(); }

private:
    [[nodiscard]] bool skins() const { return !state_->palette.empty(); }
    [[nodiscard]] bool morphs() const;
    geometry::Bounds run_morph(geometry::VertexRange range);
    geometry::Bounds run_skin(geometry::VertexRange range);

    const SurfaceMesh* mesh_;
    DeformState* state_;
    Deformed* shape_ = nullptr;
    std::vector<geometry::Bounds> bounds_; ///< by range
};

} // namespace hachure
