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

    /// Where the vertices of an item are, in the mesh's order: floats, from the buffer's begin on, 3 each. As for
    /// vertex_array(), which uses the same buffer.
    [[nodiscard]] const gpu::Buffer& positions(const MeshStore& store, const DrawItem& item);

    /// Where a compute shader writes the shape of an item that is deformed on the GPU (DrawShape::on_gpu), made when
    /// there is none: floats, the positions of all vertices, then their normals (3 each), then, where the mesh has
    /// them, their tangents (4 each). The vertex array draws from this buffer.
    [[nodiscard]] const gpu::Buffer& shape_buffer(const MeshStore& store, const DrawItem& item);

    /// The buffer holds the item's shape now.
    void shape_written(const DrawItem& item);

    /// Whether the buffer does. Until then the item is drawn in its mesh's own shape.
    [[nodiscard]] bool has_shape(const DrawItem& item) const;

    /// Drops the shapes of entities that are not in `items`.
    void forget_shapes_but(std::span<const DrawItem> items);

    [[nodiscard]] const gpu::Texture& texture(const MeshStore& store, std::int32_t index);

private:
    /// The vertices of a deformed surface; the rest is its mesh's.
    struct Shape {
        gpu::Buffer positions, normals, tangents;
        gpu::Buffer on_gpu; ///< all three in one, where the GPU writes them
        gpu::VertexArray vertex_array;
        std::uint32_t mesh = 0;
        std::uint64_t version = 0; ///< 0: nothing was written yet
    };

    void make_shape(const SurfaceMesh& mesh, const GpuMesh& base, const DrawItem& item, Shape& shape);

    std::unordered_map<std::uint32_t, GpuMesh> meshes_;
    std::unordered_map<Entity, Shape> shapes_;
    std::unordered_map<std::int32_t, gpu::Texture> textures_;
};

} // namespace hachure
