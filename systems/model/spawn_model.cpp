#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/components/name.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/systems/model/merge_primitives.h>
#include <hachure/systems/model/rest_pose.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/model/surface_material.h>

#include <algorithm>
#include <map>

namespace hachure {
namespace {

using assets::Model;
using assets::Node;

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
          materials_(model, store_, result_.warnings) {}

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
        const auto material = [&](std::int32_t index) { return materials_.get(index); };
        std::vector<assets::Primitive> primitives = rest_pose(model_, node, matrices_);
        for (assets::Primitive& primitive : primitives) materials_.prepare(primitive);
        const std::uint32_t index = store_.add(merge_primitives(mesh.name, primitives, material));
        if (shared) shared_meshes_.emplace(node.mesh, index);
        return index;
    }

    World& world_;
    const Model& model_;
    std::vector<glm::mat4> matrices_;
    SpawnedModel result_;
    MeshStore& store_;
    SurfaceMaterials materials_;
    std::map<std::int32_t, std::uint32_t> shared_meshes_;
};

} // namespace

SpawnedModel spawn_model(World& world, const Model& model) { return Spawner(world, model).run(); }

} // namespace hachure
