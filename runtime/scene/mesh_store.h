#pragma once

#include <hachure/runtime/assets/image.h>
#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/geometry/morph.h>
#include <hachure/runtime/geometry/skin_weights.h>
#include <hachure/runtime/geometry/weld.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace hachure {

/// What the shading of a surface needs to know of its material.
struct SurfaceMaterial {
    std::string name;
    glm::vec4 base_color{1.0f};           ///< linear RGBA
    std::int32_t base_color_texture = -1; ///< into the MeshStore's textures, -1 for none
    glm::vec2 uv_offset{0.0f};
    glm::vec2 uv_scale{1.0f};
    float uv_rotation = 0.0f;         ///< radians
    std::int32_t normal_texture = -1; ///< into the MeshStore's textures, -1 for none; needs the mesh's tangents
    float normal_scale = 1.0f;        ///< of the normal map's x and y
    glm::vec2 normal_uv_offset{0.0f};
    glm::vec2 normal_uv_scale{1.0f};
    float normal_uv_rotation = 0.0f; ///< radians
    float alpha_cutoff = 0.0f;       ///< fragments below it are not drawn; 0 keeps all
    bool double_sided = false;
};

/// Consecutive triangles of a mesh with one material.
struct Submesh {
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
    SurfaceMaterial material;
};

/// A mesh in entity space, as all systems see it. Arrays are empty or have one element per vertex.
struct SurfaceMesh {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> tangents; ///< xyz unit, w +-1: for normal maps, whose y is w * cross(normal, tangent)
    std::vector<glm::vec2> texcoords;
    std::vector<glm::vec2> normal_texcoords; ///< where normal maps don't use `texcoords`; empty where all do
    std::vector<glm::vec4> colors;
    std::vector<std::uint32_t> indices; ///< 3 per triangle, over all submeshes
    std::vector<Submesh> submeshes;
    geometry::SkinWeights skin;    ///< of no vertices where it has none
    geometry::MorphTargets morphs; ///< none where it has none
    geometry::Bounds bounds;
    /// Per vertex of a mesh that deforms: the first one at its place with its normal.
    std::vector<std::uint32_t> normal_weld;

    [[nodiscard]] bool deforms() const { return skin.vertex_count() > 0 || morphs.size() > 0; }
};

/// A skin as surfaces are bound to it.
struct SkinBinding {
    std::string name;
    std::vector<glm::mat4> inverse_bind; ///< by joint
    std::vector<glm::mat4> rest;         ///< by joint: its place in the model, for joints that are no entities
};

/// What the bytes of a texture say: colours in sRGB, or plain numbers as in a normal map.
enum class ColorSpace : std::uint8_t { srgb, linear };

/// A decoded texture and how it is sampled.
struct SurfaceTexture {
    assets::Image image; ///< u8, 1 to 4 channels
    assets::Wrap wrap_s = assets::Wrap::repeat;
    assets::Wrap wrap_t = assets::Wrap::repeat;
    assets::Filter magnify = assets::Filter::linear;
    assets::Filter minify = assets::Filter::linear;
    bool mipmaps = true;
    ColorSpace color_space = ColorSpace::srgb;
};

/// The meshes, textures and skins of a world, by index. A resource; what is added stays until the world ends, and
/// references stay valid.
class MeshStore {
public:
    std::uint32_t add(SurfaceMesh mesh) {
        mesh.bounds = geometry::bounds_of(mesh.positions);
        if (mesh.deforms()) mesh.normal_weld = geometry::weld_normals(mesh.positions, mesh.normals);
        meshes_.push_back(std::move(mesh));
        return static_cast<std::uint32_t>(meshes_.size() - 1);
    }
    std::int32_t add(SurfaceTexture texture) {
        textures_.push_back(std::move(texture));
        return static_cast<std::int32_t>(textures_.size() - 1);
    }
    std::uint32_t add(SkinBinding skin) {
        skins_.push_back(std::move(skin));
        return static_cast<std::uint32_t>(skins_.size() - 1);
    }
    [[nodiscard]] const SurfaceMesh& mesh(std::uint32_t index) const { return meshes_.at(index); }
    [[nodiscard]] const SurfaceTexture& texture(std::int32_t index) const {
        return textures_.at(static_cast<std::size_t>(index));
    }
    [[nodiscard]] const SkinBinding& skin(std::uint32_t index) const { return skins_.at(index); }
    [[nodiscard]] std::size_t mesh_count() const { return meshes_.size(); }
    [[nodiscard]] std::size_t texture_count() const { return textures_.size(); }

private:
    std::deque<SurfaceMesh> meshes_;
    std::deque<SurfaceTexture> textures_;
    std::deque<SkinBinding> skins_;
};

} // namespace hachure
