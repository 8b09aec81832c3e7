#pragma once

#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/texture.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <cstdint>
#include <unordered_map>

namespace hachure {

/// A mesh of the MeshStore on the GPU. Attribute locations: 0 position, 1 normal, 2 texture coordinates, 3 colour,
/// 4 tangent, 5 texture coordinates of normal maps.
struct GpuMesh {
    gpu::Buffer positions, normals, texcoords, colors, tangents, normal_texcoords, indices;
    gpu::VertexArray vertex_array;
};

/// Uploads meshes and textures when they are first drawn.
class GpuMeshes {
public:
    [[nodiscard]] const GpuMesh& mesh(const MeshStore& store, std::uint32_t index);
    [[nodiscard]] const gpu::Texture& texture(const MeshStore& store, std::int32_t index);

private:
    std::unordered_map<std::uint32_t, GpuMesh> meshes_;
    std::unordered_map<std::int32_t, gpu::Texture> textures_;
};

} // namespace hachure
