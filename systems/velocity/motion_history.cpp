#include <hachure/runtime/gpu/frame_graph_key.h>
#include <hachure/systems/velocity/motion_history.h>

#include <span>

namespace hachure {

void MotionHistory::update(const MeshStore& store, GpuMeshes& meshes, const DrawList& list,
                           const glm::mat4& clip_from_world) {
    ++frame_;
    previous_clip_ = frame_ == 1 ? clip_from_world : clip_;
    key_ = gpu::key_of(list.key, list_key_);
    motions_.clear();
    for (const DrawItem& item : list.items) motions_.push_back(motion_of(store, meshes, item, past_[item.entity]));
    std::erase_if(past_, [this](const auto& entry) { return entry.second.frame != frame_; });
    clip_ = clip_from_world;
    list_key_ = list.key;
}

Motion MotionHistory::motion_of(const MeshStore& store, GpuMeshes& meshes, const DrawItem& item, Past& past) {
    // A surface that was hidden for a while comes back from nowhere.
    const bool known = past.frame + 1 == frame_ && past.frame > 0 && past.mesh == item.mesh;
    const GpuMesh& mesh = meshes.mesh(store, item.mesh);
    Motion motion;
    motion.world_from_entity = item.world_from_entity;
    motion.previous_world = known ? past.world : item.world_from_entity;
    motion.index_count = static_cast<std::uint32_t>(store.mesh(item.mesh).indices.size());
    // systems/deform leaves no shape to the GPU alone while motions are wanted.
    motion.deforms = item.shape.version != 0 && !item.shape.on_gpu;
    if (motion.deforms) {
        if (!known) past.positions.assign(item.shape.positions.begin(), item.shape.positions.end());
        upload_shapes(mesh, item, past);
        if (past.version != item.shape.version)
            past.positions.assign(item.shape.positions.begin(), item.shape.positions.end());
    }
    motion.vertex_array = motion.deforms ? &past.vertex_array : &mesh.vertex_array;
    past.world = item.world_from_entity;
    past.mesh = item.mesh;
    past.version = item.shape.version;
    past.frame = frame_;
    return motion;
}

void MotionHistory::upload_shapes(const GpuMesh& mesh, const DrawItem& item, Past& past) {
    const std::span<const glm::vec3> now = item.shape.positions;
    if (past.now.bytes() != now.size_bytes()) {
        past.now = gpu::Buffer(now.size_bytes(), gpu::BufferUsage::dynamic, "velocity: shape");
        past.before = gpu::Buffer(now.size_bytes(), gpu::BufferUsage::dynamic, "velocity: shape before");
        past.vertex_array = gpu::VertexArray("velocity");
        for (const GLuint location : {0u, 1u}) {
            past.vertex_array.set_attribute({.location = location, .components = 3, .binding = location});
            past.vertex_array.set_vertex_buffer(location, location == 0 ? past.now : past.before, sizeof(glm::vec3));
        }
        past.vertex_array.set_index_buffer(mesh.indices);
    }
    past.now.update(now);
    past.before.update(std::span<const glm::vec3>(past.positions));
}

} // namespace hachure
