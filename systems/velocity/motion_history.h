#pragma once

#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/gpu_meshes.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <glm/mat4x4.hpp>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace hachure {

/// A surface, where it is and where it was in the frame before.
struct Motion {
    glm::mat4 world_from_entity{1.0f};
    glm::mat4 previous_world{1.0f};
    bool deforms = false; ///< its vertices move, too: `vertex_array` has both shapes, else only the mesh's own
    const gpu::VertexArray* vertex_array = nullptr;
    std::uint32_t index_count = 0;
};

/// Remembers places and shapes of one frame for the next.
class MotionHistory {
public:
    /// Takes in this frame's list; the motions, in its order, are those since the frame that was taken in before. A
    /// surface that was not there has not moved. Pointers hold until the next call.
    void update(const MeshStore& store, GpuMeshes& meshes, const DrawList& list, const glm::mat4& clip_from_world);

    [[nodiscard]] const std::vector<Motion>& motions() const { return motions_; }
    [[nodiscard]] const glm::mat4& previous_clip() const { return previous_clip_; }

    /// What the motions follow from: this frame's list and the one before.
    [[nodiscard]] std::uint64_t key() const { return key_; }

private:
    /// A surface as the last frame had it.
    struct Past {
        glm::mat4 world{1.0f};
        std::uint32_t mesh = 0;
        std::uint64_t version = 0; ///< of the shape; 0 for the mesh's own
        std::vector<glm::vec3> positions;
        std::uint64_t frame = 0; ///< in which it was seen last
        gpu::Buffer now, before;
        gpu::VertexArray vertex_array;
    };

    Motion motion_of(const MeshStore& store, GpuMeshes& meshes, const DrawItem& item, Past& past);
    static void upload_shapes(const GpuMesh& mesh, const DrawItem& item, Past& past);

    std::unordered_map<Entity, Past> past_;
    std::vector<Motion> motions_;
    glm::mat4 clip_{1.0f}, previous_clip_{1.0f};
    std::uint64_t list_key_ = 0, key_ = 0;
    std::uint64_t frame_ = 0;
};

} // namespace hachure
