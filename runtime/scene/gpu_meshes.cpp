#include <hachure/runtime/assert.h>
#include <hachure/runtime/scene/gpu_meshes.h>

#include <meshoptimizer.h>

#include <algorithm>
#include <span>
#include <string>
#include <unordered_set>

namespace hachure {
namespace {

template <class T>
void bind_attribute(gpu::VertexArray& vertex_array, GLuint location, const gpu::Buffer& buffer,
                    std::size_t offset = 0) {
    if (!buffer) return;
    vertex_array.set_attribute({.location = location, .components = T::length(), .binding = location});
    vertex_array.set_vertex_buffer(location, buffer, sizeof(T), offset);
}

template <class T>
gpu::Buffer upload_attribute(gpu::VertexArray& vertex_array, GLuint location, const std::vector<T>& values,
                             const std::string& label) {
    if (values.empty()) return {};
    gpu::Buffer buffer(std::span<const T>(values), label);
    bind_attribute<T>(vertex_array, location, buffer);
    return buffer;
}

/// Triangles in an order that reuses transformed vertices; each submesh keeps its range.
std::vector<std::uint32_t> cache_friendly(const SurfaceMesh& mesh) {
    std::vector<std::uint32_t> ordered(mesh.indices.size());
    for (const Submesh& submesh : mesh.submeshes)
        meshopt_optimizeVertexCache(ordered.data() + submesh.first_index, mesh.indices.data() + submesh.first_index,
                                    submesh.index_count, mesh.positions.size());
    return ordered;
}

GpuMesh upload_mesh(const SurfaceMesh& mesh) {
    GpuMesh result;
    result.vertex_array = gpu::VertexArray(mesh.name);
    result.positions = upload_attribute(result.vertex_array, 0, mesh.positions, mesh.name + " positions");
    result.normals = upload_attribute(result.vertex_array, 1, mesh.normals, mesh.name + " normals");
    result.texcoords = upload_attribute(result.vertex_array, 2, mesh.texcoords, mesh.name + " texcoords");
    result.colors = upload_attribute(result.vertex_array, 3, mesh.colors, mesh.name + " colors");
    result.tangents = upload_attribute(result.vertex_array, 4, mesh.tangents, mesh.name + " tangents");
    result.normal_texcoords =
        upload_attribute(result.vertex_array, 5, mesh.normal_texcoords, mesh.name + " normal texcoords");
    if (!mesh.indices.empty()) {
        const std::vector<std::uint32_t> indices = cache_friendly(mesh);
        result.indices = gpu::Buffer(std::span<const std::uint32_t>(indices), mesh.name + " indices");
        result.vertex_array.set_index_buffer(result.indices);
    }
    return result;
}

/// Vertices of a shape that is uploaded whenever it changes.
void make_shape_of_cpu(const std::string& name, const DrawShape& shape, gpu::VertexArray& vertex_array,
                       gpu::Buffer& positions, gpu::Buffer& normals, gpu::Buffer& tangents) {
    positions = gpu::Buffer(shape.positions.size_bytes(), gpu::BufferUsage::dynamic, name + " shape");
    normals = gpu::Buffer(shape.normals.size_bytes(), gpu::BufferUsage::dynamic, name + " shape normals");
    bind_attribute<glm::vec3>(vertex_array, 0, positions);
    bind_attribute<glm::vec3>(vertex_array, 1, normals);
    if (shape.tangents.empty()) return;
    tangents = gpu::Buffer(shape.tangents.size_bytes(), gpu::BufferUsage::dynamic, name + " shape tangents");
    bind_attribute<glm::vec4>(vertex_array, 4, tangents);
}

/// The same for one that the GPU writes. One buffer: compute shaders are sure of 8 only.
void make_shape_on_gpu(const SurfaceMesh& mesh, gpu::VertexArray& vertex_array, gpu::Buffer& vertices) {
    const std::size_t vectors = mesh.positions.size() * sizeof(glm::vec3);
    const std::size_t tangents = mesh.tangents.size() * sizeof(glm::vec4);
    vertices = gpu::Buffer(2 * vectors + tangents, gpu::BufferUsage::immutable, mesh.name + " shape");
    bind_attribute<glm::vec3>(vertex_array, 0, vertices);
    bind_attribute<glm::vec3>(vertex_array, 1, vertices, vectors);
    if (tangents > 0) bind_attribute<glm::vec4>(vertex_array, 4, vertices, 2 * vectors);
}

/// sRGB formats have four channels, so every image becomes RGBA whatever its channels.
std::vector<std::uint8_t> to_rgba(const assets::Image& image) {
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const std::size_t channels = static_cast<std::size_t>(image.channels);
    std::vector<std::uint8_t> rgba(count * 4);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* in = image.u8() + i * channels;
        std::uint8_t* out = rgba.data() + i * 4;
        out[0] = in[0];
        out[1] = channels >= 3 ? in[1] : in[0];
        out[2] = channels >= 3 ? in[2] : in[0];
        out[3] = channels == 4 ? in[3] : channels == 2 ? in[1] : std::uint8_t{255};
    }
    return rgba;
}

gpu::Wrap gpu_wrap(assets::Wrap wrap) {
    switch (wrap) {
    case assets::Wrap::clamp:
        return gpu::Wrap::clamp_to_edge;
    case assets::Wrap::mirror:
        return gpu::Wrap::mirrored_repeat;
    case assets::Wrap::repeat:
        break;
    }
    return gpu::Wrap::repeat;
}

gpu::Filter gpu_filter(assets::Filter filter) {
    return filter == assets::Filter::nearest ? gpu::Filter::nearest : gpu::Filter::linear;
}

gpu::Texture upload_texture(const SurfaceTexture& source) {
    const assets::Image& image = source.image;
    const bool srgb = source.color_space == ColorSpace::srgb;
    gpu::TextureDesc desc{image.width, image.height, srgb ? gpu::Format::srgb8_alpha8 : gpu::Format::rgba8};
    desc.levels = gpu::mip_levels(image.width, image.height);
    gpu::Texture texture(desc, srgb ? "base color" : "normal map");
    // Texture coordinates run downwards in glTF: its first row is v = 0.
    texture.upload(std::span<const std::uint8_t>(to_rgba(image)), gpu::RowOrder::bottom_first);
    texture.generate_mipmaps();
    texture.set_sampling({.min = gpu_filter(source.minify),
                          .mag = gpu_filter(source.magnify),
                          .mipmaps = source.mipmaps,
                          .wrap_u = gpu_wrap(source.wrap_s),
                          .wrap_v = gpu_wrap(source.wrap_t)});
    return texture;
}

} // namespace

const GpuMesh& GpuMeshes::mesh(const MeshStore& store, std::uint32_t index) {
    const auto found = meshes_.find(index);
    if (found != meshes_.end()) return found->second;
    return meshes_.emplace(index, upload_mesh(store.mesh(index))).first->second;
}

const gpu::VertexArray& GpuMeshes::vertex_array(const MeshStore& store, const DrawItem& item) {
    const GpuMesh& base = mesh(store, item.mesh);
    if (item.shape.version == 0) return base.vertex_array;
    if (item.shape.on_gpu) return has_shape(item) ? shapes_.at(item.entity).vertex_array : base.vertex_array;
    Shape& shape = shapes_[item.entity];
    if (shape.version == item.shape.version && !shape.on_gpu) return shape.vertex_array;
    if (!shape.vertex_array || shape.mesh != item.mesh || shape.on_gpu)
        make_shape(store.mesh(item.mesh), base, item, shape);
    shape.positions.update(item.shape.positions);
    shape.normals.update(item.shape.normals);
    if (!item.shape.tangents.empty()) shape.tangents.update(item.shape.tangents);
    shape.version = item.shape.version;
    return shape.vertex_array;
}

const gpu::Buffer& GpuMeshes::positions(const MeshStore& store, const DrawItem& item) {
    static_cast<void>(vertex_array(store, item)); // uploads what it draws
    if (item.shape.version == 0) return mesh(store, item.mesh).positions;
    if (!item.shape.on_gpu) return shapes_.at(item.entity).positions;
    return has_shape(item) ? shapes_.at(item.entity).on_gpu : mesh(store, item.mesh).positions;
}

const gpu::Buffer& GpuMeshes::shape_buffer(const MeshStore& store, const DrawItem& item) {
    HACHURE_ASSERT(item.shape.on_gpu, "this shape comes from the CPU");
    const GpuMesh& base = mesh(store, item.mesh);
    Shape& shape = shapes_[item.entity];
    if (!shape.on_gpu || shape.mesh != item.mesh) make_shape(store.mesh(item.mesh), base, item, shape);
    return shape.on_gpu;
}

void GpuMeshes::shape_written(const DrawItem& item) { shapes_.at(item.entity).version = item.shape.version; }

bool GpuMeshes::has_shape(const DrawItem& item) const {
    const auto found = shapes_.find(item.entity);
    return found != shapes_.end() && found->second.on_gpu && found->second.mesh == item.mesh &&
           found->second.version == item.shape.version;
}

void GpuMeshes::make_shape(const SurfaceMesh& mesh, const GpuMesh& base, const DrawItem& item, Shape& shape) {
    shape = {};
    shape.mesh = item.mesh;
    shape.vertex_array = gpu::VertexArray(mesh.name + " shape");
    if (item.shape.on_gpu)
        make_shape_on_gpu(mesh, shape.vertex_array, shape.on_gpu);
    else
        make_shape_of_cpu(mesh.name, item.shape, shape.vertex_array, shape.positions, shape.normals, shape.tangents);
    bind_attribute<glm::vec2>(shape.vertex_array, 2, base.texcoords);
    bind_attribute<glm::vec4>(shape.vertex_array, 3, base.colors);
    bind_attribute<glm::vec2>(shape.vertex_array, 5, base.normal_texcoords);
    if (base.indices) shape.vertex_array.set_index_buffer(base.indices);
}

void GpuMeshes::forget_shapes_but(std::span<const DrawItem> items) {
    const auto drawn = static_cast<std::size_t>(
        std::ranges::count_if(items, [](const DrawItem& item) { return item.shape.version != 0; }));
    if (shapes_.size() <= drawn) return;
    std::unordered_set<Entity> kept;
    for (const DrawItem& item : items)
        if (item.shape.version != 0) kept.insert(item.entity);
    std::erase_if(shapes_, [&](const auto& entry) { return !kept.contains(entry.first); });
}

const gpu::Texture& GpuMeshes::texture(const MeshStore& store, std::int32_t index) {
    const auto found = textures_.find(index);
    if (found != textures_.end()) return found->second;
    return textures_.emplace(index, upload_texture(store.texture(index))).first->second;
}

} // namespace hachure
