#pragma once

#include <hachure/components/metal.h>
#include <hachure/runtime/geometry/stripe_frames.h>
#include <hachure/runtime/geometry/stripe_mesh.h>
#include <hachure/runtime/gpu/buffer.h>
#include <hachure/runtime/gpu/vertex_array.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/mesh_store.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace hachure {

/// The coordinate of a mesh's stripes, shared by all surfaces that are laid out alike.
struct StripeLayout {
    geometry::StripeMesh stripes;

    // On the GPU, made when first drawn; all by vertex of `stripes`.
    gpu::Buffer coordinate, weight, clarity, indices;
    gpu::Buffer texcoords, colors, normal_texcoords; ///< where the mesh has them
};

/// A mesh in some shape with its stripes, as metal.vert reads it: locations 0 to 5 as those of GpuMesh, 6 the
/// coordinate, 7 the frame (StripeFramesJob), 8 the weight; where the layout has lean, 9 the normal without bumps and
/// how it turns, and 10 the clarity.
struct StripedShape {
    gpu::Buffer positions, normals, tangents, frames, smooth_normals;
    gpu::VertexArray vertex_array;
    std::uint64_t layout = 0;
    std::uint64_t version = 0; ///< of the DrawShape
    glm::mat3 stretch{1.0f};   ///< of the transform that the frames are for
};

/// What to draw metal with, by entity. Nothing is computed again but what a change asks for: the layout when the mesh
/// or the settings of its stripes changed, the frames when the shape did. Of the thread of the render context.
class MetalSurfaces {
public:
    [[nodiscard]] bool has_layout(std::uint64_t key) const { return layouts_.contains(key); }
    void add(std::uint64_t key, geometry::StripeMesh stripes);

    /// The item's vertices with their stripes; its layout is there. Null while the GPU alone knows its shape, and for a
    /// mesh without normals or triangles.
    [[nodiscard]] const gpu::VertexArray* vertex_array(const SurfaceMesh& mesh, const DrawItem& item,
                                                       std::uint64_t layout);

    /// Drops the shapes of entities that are not in `items`, and layouts that are not in `layouts`.
    void forget_but(std::span<const DrawItem> items, const std::unordered_set<std::uint64_t>& layouts);

    [[nodiscard]] std::size_t layout_count() const { return layouts_.size(); }
    [[nodiscard]] std::size_t shape_count() const { return rest_.size() + own_.size(); }
    /// How often frames were computed.
    [[nodiscard]] std::uint64_t frames_computed() const { return frames_computed_; }

private:
    static void upload(const SurfaceMesh& mesh, StripeLayout& layout);
    static void make(const SurfaceMesh& mesh, const StripeLayout& layout, StripedShape& shape);
    void fill(const SurfaceMesh& mesh, const DrawItem& item, const StripeLayout& layout, StripedShape& shape);
    void compute_frames(const StripeLayout& layout, const glm::mat3& stretch);

    std::unordered_map<std::uint64_t, StripeLayout> layouts_;
    std::unordered_map<std::uint64_t, StripedShape> rest_; ///< by layout: of meshes in their own shape
    std::unordered_map<Entity, StripedShape> own_;         ///< of surfaces that deform or are stretched
    std::uint64_t frames_computed_ = 0;

    // Scratch, kept from frame to frame.
    geometry::StripeFramesJob job_;
    std::vector<glm::vec3> positions_, normals_, stretched_positions_, stretched_normals_;
    std::vector<glm::vec4> tangents_, frames_, smooth_normals_;
};

} // namespace hachure
