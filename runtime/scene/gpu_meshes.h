#pragma once

#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/texture.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <cstdint>
#include <span>
#include <unordered_map>

namespace hachure {

/// A mesh of the MeshStore on the GPU. Attribute locations: 0 position, 1 normal, 2 texture coordinates, 3 colour,
/// 4 tangent, 5 texture coordinates of normal maps.
struct GpuMesh {
    gpu::Buffer positions, normals, texcoords, colors, tangents, normal_texcoords, indices;
    gpu::VertexArray vertex_array;
};

/// Uploads meshes and textures when they are first drawn, and shapes of deformed surfaces when they changed.
class GpuMeshes {
public:
    [[nodiscard]] const GpuMesh& mesh(const MeshStore& store, std::uint32_t index);

    /// What to draw an item of the DrawList with: its mesh, in its own shape where it deforms.
    [[nodiscard]] const gpu::VertexArray& vertex_array(const MeshStore& store, const DrawItem& item);

    /// Drops the shapes of entities that are not in `items`.
    void forget_shapes_but(std::span<const DrawItem> items);

    [[nodiscard]] const gpu::Texture& texture(const MeshStore& store, std::int32_t index);

private:
    /// The vertices of a deformed surface; the rest is its mesh's.
    struct Shape {
        gpu::Buffer positions, normals, tangents;
        gpu::VertexArray vertex_array;
        std::uint32_t mesh = 0;
        std::uint64_t version = 0;
    };

    std::unordered_map<std::uint32_t, GpuMesh> meshes_;
    std::unordered_map<Entity, Shape> shapes_;
    std::unordered_map<std::int32_t, gpu::Texture> textures_;
};

} // namespace hachure
