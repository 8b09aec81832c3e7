#pragma once

#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/runtime/scene/render_context.h>
#include <hachure/systems/deform/deform_input.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace hachure {

/// Deforms surfaces on the GPU, into the buffers of GpuMeshes that they are drawn from. A resource; belongs to the
/// context that is current when it first runs.
class GpuDeformer {
public:
    /// Finds the items of the list whose shape is not in its buffer yet. False when the frame has none that are
    /// deformed on the GPU.
    bool plan(const DrawList& list, const DeformInputs& inputs, const RenderContext& render);

    /// Grows whenever `plan` found something to do.
    [[nodiscard]] std::uint64_t runs() const { return runs_; }

    /// Vertices of what is to be deformed.
    [[nodiscard]] std::uint64_t vertices(const MeshStore& store) const;

    /// Deforms what `plan` found; the buffers may be drawn from, read and copied afterwards.
    void run(const MeshStore& store, const DeformInputs& inputs, RenderContext& render);

private:
    /// What a mesh brings for being deformed, besides its vertices.
    struct MeshData {
        gpu::Buffer influences; ///< joints as they are packed, then weights
        gpu::Buffer morphs;     ///< see shaders/deform/morph.glsl
    };

    const MeshData& mesh_data(const MeshStore& store, std::uint32_t index);
    void upload_poses(const DeformInputs& inputs);
    void deform(const MeshStore& store, const DrawItem& item, const DeformInput& input, std::size_t pose,
                RenderContext& render);

    std::unordered_map<std::uint32_t, MeshData> meshes_;
    std::vector<DrawItem> planned_;
    std::vector<glm::vec4> poses_;         ///< of all that is to be deformed
    std::vector<std::size_t> first_poses_; ///< of each, into them
    gpu::Buffer pose_buffer_;
    std::uint64_t runs_ = 0;
    std::uint64_t generation_ = 0; ///< of the shaders that the shapes were made with
};

} // namespace hachure
