#include <hachure/runtime/assert.h>
#include <hachure/systems/metal/metal_surfaces.h>
#include <hachure/systems/metal/stretch.h>

#include <glm/matrix.hpp>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

template <class T> void gather(std::span<const T> values, std::span<const std::uint32_t> source, std::vector<T>& out) {
    out.resize(values.empty() ? 0 : source.size());
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = values[source[v]];
}

template <class T>
gpu::Buffer upload_gathered(const std::vector<T>& values, const geometry::StripeMesh& stripes,
                            const std::string& label) {
    if (values.empty()) return {};
    std::vector<T> gathered;
    gather(std::span<const T>(values), stripes.source_vertex, gathered);
    return gpu::Buffer(std::span<const T>(gathered), label);
}

void bind_floats(gpu::VertexArray& vertex_array, GLuint location, const gpu::Buffer& buffer, int components) {
    if (!buffer) return;
    vertex_array.set_attribute({.location = location, .components = components, .binding = location});
    vertex_array.set_vertex_buffer(location, buffer, static_cast<GLsizei>(sizeof(float)) * components);
}

bool can_be_striped(const SurfaceMesh& mesh) {
    return !mesh.indices.empty() && !mesh.positions.empty() && mesh.normals.size() == mesh.positions.size();
}

} // namespace

void MetalSurfaces::add(std::uint64_t key, geometry::StripeMesh stripes) {
    layouts_[key] = {.stripes = std::move(stripes)};
}

const gpu::VertexArray* MetalSurfaces::vertex_array(const SurfaceMesh& mesh, const DrawItem& item,
                                                    std::uint64_t layout_key) {
    if (!can_be_striped(mesh) || item.shape.on_gpu) return nullptr;
    StripeLayout& layout = layouts_.at(layout_key);
    if (!layout.coordinate) upload(mesh, layout);
    const glm::mat3 stretch = stretch_of(glm::mat3(item.world_from_entity));
    const bool as_it_is = item.shape.version == 0 && stretch == glm::mat3(1.0f);
    StripedShape& shape = as_it_is ? rest_[layout_key] : own_[item.entity];
    if (shape.layout != layout_key || !shape.vertex_array)
        make(mesh, layout, shape);
    else if (shape.version == item.shape.version && same_stretch(shape.stretch, stretch))
        return &shape.vertex_array;
    shape.layout = layout_key;
    shape.version = item.shape.version;
    shape.stretch = stretch;
    fill(mesh, item, layout, shape);
    return &shape.vertex_array;
}

void MetalSurfaces::upload(const SurfaceMesh& mesh, StripeLayout& layout) {
    const geometry::StripeMesh& stripes = layout.stripes;
    layout.coordinate = gpu::Buffer(std::span<const float>(stripes.coordinate), mesh.name + " stripes");
    layout.weight = gpu::Buffer(std::span<const float>(stripes.weight), mesh.name + " stripe weights");
    if (!stripes.clarity.empty())
        layout.clarity = gpu::Buffer(std::span<const float>(stripes.clarity), mesh.name + " stripe clarity");
    layout.texcoords = upload_gathered(mesh.texcoords, stripes, mesh.name + " striped texcoords");
    layout.colors = upload_gathered(mesh.colors, stripes, mesh.name + " striped colors");
    layout.normal_texcoords = upload_gathered(mesh.normal_texcoords, stripes, mesh.name + " striped normal texcoords");
    std::vector<std::uint32_t> indices(stripes.indices.size());
    for (const Submesh& submesh : mesh.submeshes)
        meshopt_optimizeVertexCache(indices.data() + submesh.first_index, stripes.indices.data() + submesh.first_index,
                                    submesh.index_count, stripes.source_vertex.size());
    layout.indices = gpu::Buffer(std::span<const std::uint32_t>(indices), mesh.name + " striped indices");
}

void MetalSurfaces::make(const SurfaceMesh& mesh, const StripeLayout& layout, StripedShape& shape) {
    const std::size_t count = layout.stripes.source_vertex.size();
    const gpu::BufferUsage usage = gpu::BufferUsage::dynamic;
    const std::string name = mesh.name + " striped";
    shape = {};
    shape.positions = gpu::Buffer(count * sizeof(glm::vec3), usage, name);
    shape.normals = gpu::Buffer(count * sizeof(glm::vec3), usage, name + " normals");
    if (!mesh.tangents.empty()) shape.tangents = gpu::Buffer(count * sizeof(glm::vec4), usage, name + " tangents");
    shape.frames = gpu::Buffer(count * sizeof(glm::vec4), usage, name + " frames");
    if (!layout.stripes.lean.empty())
        shape.smooth_normals = gpu::Buffer(count * sizeof(glm::vec4), usage, name + " smooth normals");
    shape.vertex_array = gpu::VertexArray(name);
    bind_floats(shape.vertex_array, 0, shape.positions, 3);
    bind_floats(shape.vertex_array, 1, shape.normals, 3);
    bind_floats(shape.vertex_array, 2, layout.texcoords, 2);
    bind_floats(shape.vertex_array, 3, layout.colors, 4);
    bind_floats(shape.vertex_array, 4, shape.tangents, 4);
    bind_floats(shape.vertex_array, 5, layout.normal_texcoords, 2);
    bind_floats(shape.vertex_array, 6, layout.coordinate, 1);
    bind_floats(shape.vertex_array, 7, shape.frames, 4);
    bind_floats(shape.vertex_array, 8, layout.weight, 1);
    bind_floats(shape.vertex_array, 9, shape.smooth_normals, 4);
    bind_floats(shape.vertex_array, 10, layout.clarity, 1);
    shape.vertex_array.set_index_buffer(layout.indices);
}

void MetalSurfaces::fill(const SurfaceMesh& mesh, const DrawItem& item, const StripeLayout& layout,
                         StripedShape& shape) {
    const bool deformed = item.shape.version != 0;
    const std::vector<std::uint32_t>& source = layout.stripes.source_vertex;
    gather(deformed ? item.shape.positions : std::span<const glm::vec3>(mesh.positions), source, positions_);
    gather(deformed ? item.shape.normals : std::span<const glm::vec3>(mesh.normals), source, normals_);
    gather(deformed ? item.shape.tangents : std::span<const glm::vec4>(mesh.tangents), source, tangents_);
    compute_frames(layout, shape.stretch);
    shape.positions.update(std::span<const glm::vec3>(positions_));
    shape.normals.update(std::span<const glm::vec3>(normals_));
    if (!tangents_.empty()) shape.tangents.update(std::span<const glm::vec4>(tangents_));
    shape.frames.update(std::span<const glm::vec4>(frames_));
    if (!smooth_normals_.empty()) shape.smooth_normals.update(std::span<const glm::vec4>(smooth_normals_));
}

void MetalSurfaces::compute_frames(const StripeLayout& layout, const glm::mat3& stretch) {
    ++frames_computed_;
    const bool stretched = stretch != glm::mat3(1.0f);
    const glm::mat3 for_normals = glm::transpose(glm::inverse(stretch));
    if (stretched) {
        stretched_positions_.resize(positions_.size());
        stretched_normals_.resize(normals_.size());
        for (std::size_t v = 0; v < positions_.size(); ++v) {
            stretched_positions_[v] = stretch * positions_[v];
            stretched_normals_[v] = glm::normalize(for_normals * normals_[v]);
        }
    }
    frames_.resize(positions_.size());
    smooth_normals_.resize(layout.stripes.lean.size());
    job_.positions = stretched ? stretched_positions_ : positions_;
    job_.normals = stretched ? stretched_normals_ : normals_;
    job_.indices = layout.stripes.indices;
    job_.coordinate = layout.stripes.coordinate;
    job_.stands_for = layout.stripes.stands_for;
    job_.mirrored = layout.stripes.mirrored;
    job_.lean = layout.stripes.lean;
    job_.smooth_normals = smooth_normals_;
    job_.frames = frames_;
    job_.run();
    if (!stretched) return;
    // So that the matrix of normals takes them to the world: it is scale * rotation * (S^T)^-1.
    const glm::mat3 back = glm::transpose(stretch);
    for (glm::vec4& frame : frames_) frame = glm::vec4(back * glm::vec3(frame), frame.w);
    for (glm::vec4& normal : smooth_normals_) normal = glm::vec4(back * glm::vec3(normal), normal.w);
}

void MetalSurfaces::forget_but(std::span<const DrawItem> items, const std::unordered_set<std::uint64_t>& layouts) {
    std::erase_if(layouts_, [&](const auto& entry) { return !layouts.contains(entry.first); });
    std::erase_if(rest_, [&](const auto& entry) { return !layouts.contains(entry.first); });
    std::unordered_set<Entity> drawn;
    for (const DrawItem& item : items) drawn.insert(item.entity);
    std::erase_if(own_, [&](const auto& entry) {
        return !drawn.contains(entry.first) || !layouts.contains(entry.second.layout);
    });
}

} // namespace hachure
