#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/components/name.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/systems/model/merge_primitives.h>
#include <hachure/systems/model/rest_pose.h>
#include <hachure/systems/model/spawn_model.h>

#include <algorithm>
#include <map>

namespace hachure {
namespace {

using assets::Model;
using assets::Node;

/// Decodes a texture when its first material asks for it.
class Textures {
public:
    Textures(const Model& model, MeshStore& store, std::vector<std::string>& warnings)
        : model_(model), store_(store), warnings_(warnings) {}

    std::int32_t get(std::int32_t index) {
        if (index < 0) return -1;
        const auto [entry, fresh] = loaded_.try_emplace(index, -1);
        if (fresh) entry->second = load(model_.textures[static_cast<std::size_t>(index)]);
        return entry->second;
    }

private:
    std::int32_t load(const assets::Texture& texture) {
        if (texture.image < 0) return -1;
        const assets::EncodedImage& source = model_.images[static_cast<std::size_t>(texture.image)];
        if (source.bytes.empty()) return -1;
        try {
            assets::Image image = assets::read_image_memory(source.name, source.bytes);
            if (image.type != assets::PixelType::u8) throw Error(source.name, "is not an 8-bit image");
            return store_.add(SurfaceTexture{std::move(image), texture.wrap_s, texture.wrap_t, texture.magnify});
        } catch (const Error& error) {
            warnings_.push_back(error.what());
            return -1;
        }
    }

    const Model& model_;
    MeshStore& store_;
    std::vector<std::string>& warnings_;
    std::map<std::int32_t, std::int32_t> loaded_;
};

SurfaceMaterial surface_material(const Model& model, std::int32_t index, Textures& textures) {
    SurfaceMaterial result;
    if (index < 0) return result; // glTF's default: white, one side
    const assets::Material& material = model.materials[static_cast<std::size_t>(index)];
    result.name = material.name;
    result.base_color = material.base_color;
    result.base_color_texture = textures.get(material.base_color_texture.texture);
    result.uv_offset = material.base_color_texture.offset;
    result.uv_scale = material.base_color_texture.scale;
    result.uv_rotation = material.base_color_texture.rotation;
    result.alpha_cutoff = material.alpha_mode == assets::AlphaMode::mask ? material.alpha_cutoff : 0.0f;
    result.double_sided = material.double_sided;
    return result;
}

Camera camera_component(const assets::Camera& camera) {
    Camera result;
    result.projection = camera.orthographic ? Projection::orthographic : Projection::perspective;
    result.yfov = camera.yfov;
    result.ymag = camera.ymag;
    result.znear = std::max(camera.znear, 1e-6f);
    result.zfar = camera.zfar.value_or(0.0f);
    return result;
}

Light light_component(const assets::Light& light) {
    Light result;
    result.kind = static_cast<LightKind>(light.kind);
    result.color = light.color;
    result.intensity = light.intensity;
    result.range = light.range.value_or(0.0f);
    result.inner_cone = light.inner_cone;
    result.outer_cone = light.outer_cone;
    return result;
}

class Spawner {
public:
    Spawner(World& world, const Model& model)
        : world_(world), model_(model), matrices_(node_matrices(model)), store_(world.resource_mutable<MeshStore>()),
          textures_(model, store_, result_.warnings) {}

    SpawnedModel run() {
        const assets::Scene& scene = model_.scenes[static_cast<std::size_t>(model_.default_scene)];
        std::vector<std::pair<std::int32_t, Entity>> pending;
        for (auto root = scene.roots.rbegin(); root != scene.roots.rend(); ++root)
            pending.emplace_back(*root, Entity{});
        while (!pending.empty()) {
            const auto [index, parent] = pending.back();
            pending.pop_back();
            const Entity entity = spawn_node(static_cast<std::size_t>(index), parent);
            const std::vector<std::int32_t>& children = model_.nodes[static_cast<std::size_t>(index)].children;
            for (auto child = children.rbegin(); child != children.rend(); ++child)
                pending.emplace_back(*child, entity);
        }
        return std::move(result_);
    }

private:
    Entity spawn_node(std::size_t index, Entity parent) {
        const Node& node = model_.nodes[index];
        const Entity entity = world_.create();
        world_.add(entity, Name{node.name.empty() ? "node " + std::to_string(index) : node.name});
        world_.add(entity, Transform{node.translation, node.rotation, node.scale});
        if (node.matrix) world_.add(entity, LocalMatrix{*node.matrix});
        if (parent)
            world_.set_parent(entity, parent);
        else
            result_.roots.push_back(entity);
        if (node.mesh >= 0) add_surface(entity, index);
        if (node.camera >= 0) add_camera(entity, model_.cameras[static_cast<std::size_t>(node.camera)]);
        if (node.light >= 0) {
            world_.add(entity, light_component(model_.lights[static_cast<std::size_t>(node.light)]));
            result_.lights.push_back(entity);
        }
        return entity;
    }

    void add_camera(Entity entity, const assets::Camera& source) {
        Camera camera = camera_component(source);
        camera.active = result_.cameras.empty();
        world_.add(entity, camera);
        result_.cameras.push_back(entity);
    }

    /// A skinned mesh stands in the scene, not below its node: glTF ignores that node's transform.
    void add_surface(Entity node_entity, std::size_t index) {
        const Node& node = model_.nodes[index];
        const bool skinned = node.skin >= 0;
        const std::uint32_t mesh = store_mesh(node, skinned);
        Entity entity = node_entity;
        if (skinned) {
            entity = world_.create();
            world_.add(entity, Name{world_.get<Name>(node_entity).text});
            world_.add(entity, Transform{});
            result_.roots.push_back(entity);
        }
        world_.add(entity, Surface{mesh});
        result_.surfaces.push_back(entity);
        const glm::mat4 matrix = skinned ? glm::mat4(1.0f) : matrices_[index];
        add_points(store_.mesh(mesh), matrix);
    }

    void add_points(const SurfaceMesh& mesh, const glm::mat4& matrix) {
        std::vector<bool> used(mesh.positions.size(), false);
        for (const std::uint32_t index : mesh.indices) used[index] = true;
        for (std::size_t i = 0; i < used.size(); ++i)
            if (used[i]) result_.points.push_back(glm::vec3(matrix * glm::vec4(mesh.positions[i], 1.0f)));
    }

    /// Nodes that share an undeformed mesh share its vertices.
    std::uint32_t store_mesh(const Node& node, bool skinned) {
        const bool shared = !skinned && node.morph_weights.empty();
        if (shared) {
            const auto found = shared_meshes_.find(node.mesh);
            if (found != shared_meshes_.end()) return found->second;
        }
        const assets::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
        const auto material = [&](std::int32_t index) { return surface_material(model_, index, textures_); };
        std::vector<assets::Primitive> primitives = rest_pose(model_, node, matrices_);
        for (assets::Primitive& primitive : primitives) use_base_color_texcoords(primitive);
        const std::uint32_t index = store_.add(merge_primitives(mesh.name, primitives, material));
        if (shared) shared_meshes_.emplace(node.mesh, index);
        return index;
    }

    /// A SurfaceMesh has one set of texture coordinates: the one of the base colour.
    void use_base_color_texcoords(assets::Primitive& primitive) const {
        if (primitive.material < 0) return;
        const assets::Material& material = model_.materials[static_cast<std::size_t>(primitive.material)];
        if (material.base_color_texture.texcoord == 1) primitive.texcoords[0] = primitive.texcoords[1];
    }

    World& world_;
    const Model& model_;
    std::vector<glm::mat4> matrices_;
    SpawnedModel result_;
    MeshStore& store_;
    Textures textures_;
    std::map<std::int32_t, std::uint32_t> shared_meshes_;
};

} // namespace

SpawnedModel spawn_model(World& world, const Model& model) { return Spawner(world, model).run(); }

} // namespace hachure
