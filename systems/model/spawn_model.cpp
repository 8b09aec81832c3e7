#include <hachure/components/camera.h>
#include <hachure/components/deform.h>
#include <hachure/components/light.h>
#include <hachure/components/morph_weights.h>
#include <hachure/components/name.h>
#include <hachure/components/rig.h>
#include <hachure/components/skin.h>
#include <hachure/components/surface.h>
#include <hachure/components/transform.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/scene/clip_store.h>
#include <hachure/runtime/scene/mesh_store.h>
#include <hachure/systems/model/bind_pointers.h>
#include <hachure/systems/model/merge_primitives.h>
#include <hachure/systems/model/posed_vertices.h>
#include <hachure/systems/model/spawn_model.h>
#include <hachure/systems/model/surface_material.h>

#include <algorithm>
#include <map>
#include <utility>

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

/// The world's R, made when absent.
template <class R> R& resource_of(World& world) {
    if (!world.find_resource<R>()) world.set_resource(R{});
    return world.resource_mutable<R>();
}

class ModelSpawner {
public:
    ModelSpawner(World& world, const Model& model, StoredModel& stored)
        : world_(world), model_(model), stored_(stored), matrices_(node_matrices(model.nodes)),
          store_(resource_of<MeshStore>(world)), materials_(model, store_, result_.warnings),
          nodes_(model.nodes.size(), Entity::null), morphs_(model.nodes.size(), Entity::null),
          surfaces_(model.nodes.size(), Entity::null) {}

    SpawnedModel run() {
        const assets::Scene& scene = model_.scenes[static_cast<std::size_t>(model_.default_scene)];
        result_.root = world_.create_with(Name{scene.name.empty() ? "model" : scene.name}, Transform{});
        std::vector<std::pair<std::int32_t, Entity>> pending;
        for (auto root = scene.roots.rbegin(); root != scene.roots.rend(); ++root)
            pending.emplace_back(*root, result_.root);
        while (!pending.empty()) {
            const auto [index, parent] = pending.back();
            pending.pop_back();
            const Entity entity = spawn_node(static_cast<std::size_t>(index), parent);
            const std::vector<std::int32_t>& children = model_.nodes[static_cast<std::size_t>(index)].children;
            for (auto child = children.rbegin(); child != children.rend(); ++child)
                pending.emplace_back(*child, entity);
        }
        for (const auto& [entity, skin] : skinned_) world_.add(entity, skin_component(skin));
        add_rig();
        if (!stored_.points) stored_.points = scene_points(model_, model_.nodes);
        result_.points = *stored_.points;
        return std::move(result_);
    }

private:
    Entity spawn_node(std::size_t index, Entity parent) {
        const Node& node = model_.nodes[index];
        const Entity entity = world_.create();
        nodes_[index] = entity;
        world_.add(entity, Name{node.name.empty() ? "node " + std::to_string(index) : node.name});
        world_.add(entity, Transform{node.translation, node.rotation, node.scale});
        if (node.matrix) world_.add(entity, LocalMatrix{*node.matrix});
        world_.set_parent(entity, parent);
        if (node.mesh >= 0) add_surface(entity, index);
        if (node.camera >= 0) {
            camera_entities_.emplace(node.camera, entity);
            add_camera(entity, model_.cameras[static_cast<std::size_t>(node.camera)]);
        }
        if (node.light >= 0) {
            light_entities_.emplace(node.light, entity);
            world_.add(entity, light_component(model_.lights[static_cast<std::size_t>(node.light)]));
            result_.lights.push_back(entity);
        }
        return entity;
    }

    void add_rig() {
        if (model_.animations.empty()) return;
        if (!stored_.clips) stored_.clips = store_clips();
        const animation::ClipSet& set = world_.resource<ClipStore>().clips(*stored_.clips).set;
        for (const animation::Clip& clip : set.clips) result_.clips.push_back(clip.name);
        Rig rig{.clips = *stored_.clips, .nodes = nodes_, .morphs = morphs_};
        const PointerOwners owners{surfaces_, camera_entities_, light_entities_};
        for (std::size_t clip = 0; clip < set.clips.size(); ++clip)
            bind_pointers(set.clips[clip], static_cast<std::uint32_t>(clip), owners, rig.pointers, result_.warnings);
        world_.add(result_.root, std::move(rig));
    }

    std::uint32_t store_clips() {
        ModelClips clips{animation::compile_clips(model_, result_.warnings), {}};
        clips.rest = animation::rest_pose(model_, clips.set.layout);
        return resource_of<ClipStore>(world_).add(std::move(clips));
    }

    void add_camera(Entity entity, const assets::Camera& source) {
        Camera camera = camera_component(source);
        camera.active = result_.cameras.empty();
        world_.add(entity, camera);
        result_.cameras.push_back(entity);
    }

    /// A skinned mesh stands in the model, not below its node: glTF ignores that node's transform.
    void add_surface(Entity node_entity, std::size_t index) {
        const Node& node = model_.nodes[index];
        const std::uint32_t mesh = store_mesh(node);
        Entity entity = node_entity;
        if (node.skin >= 0) {
            entity = world_.create_with(Name{world_.get<Name>(node_entity).text}, Transform{});
            world_.set_parent(entity, result_.root);
            skinned_.emplace_back(entity, node.skin);
        }
        if (store_.mesh(mesh).morphs.size() > 0) {
            world_.add(entity, morph_weights(node, store_.mesh(mesh).morphs.size()));
            morphs_[index] = entity;
        }
        world_.add(entity, Surface{mesh});
        if (store_.mesh(mesh).deforms()) world_.add(entity, Deform{});
        result_.surfaces.push_back(entity);
        surfaces_[index] = entity;
    }

    MorphWeights morph_weights(const Node& node, std::size_t targets) const {
        const assets::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
        MorphWeights weights{node.morph_weights.empty() ? mesh.morph_weights : node.morph_weights};
        weights.values.resize(targets, 0.0f);
        return weights;
    }

    /// When all nodes are there.
    Skin skin_component(std::int32_t index) {
        const assets::Skin& skin = model_.skins[static_cast<std::size_t>(index)];
        Skin result;
        SkinBinding binding{skin.name, skin.inverse_bind, {}};
        for (const std::int32_t joint : skin.joints) {
            result.joints.push_back(nodes_[static_cast<std::size_t>(joint)]);
            binding.rest.push_back(matrices_[static_cast<std::size_t>(joint)]);
        }
        const auto [entry, fresh] = stored_.bindings.try_emplace(index, 0);
        if (fresh) entry->second = store_.add(std::move(binding));
        result.binding = entry->second;
        return result;
    }

    /// Nodes share the vertices of a mesh, and those that skin it alike its weights.
    std::uint32_t store_mesh(const Node& node) {
        const std::size_t joints = node.skin < 0 ? 0 : model_.skins[static_cast<std::size_t>(node.skin)].joints.size();
        const auto [entry, fresh] = stored_.meshes.try_emplace({node.mesh, joints}, 0);
        if (!fresh) return entry->second;
        const assets::Mesh& mesh = model_.meshes[static_cast<std::size_t>(node.mesh)];
        const auto material = [&](std::int32_t index) { return materials_.get(index); };
        std::vector<assets::Primitive> primitives = mesh.primitives;
        for (assets::Primitive& primitive : primitives) materials_.prepare(primitive);
        SurfaceMesh merged = merge_primitives(mesh.name, primitives, material, joints);
        for (std::string& warning : geometry::skin_weight_warnings(merged.skin.repairs(), "mesh '" + mesh.name + "'"))
            result_.warnings.push_back(std::move(warning));
        return entry->second = store_.add(std::move(merged));
    }

    World& world_;
    const Model& model_;
    StoredModel& stored_;
    std::vector<glm::mat4> matrices_;
    SpawnedModel result_;
    MeshStore& store_;
    SurfaceMaterials materials_;
    std::vector<Entity> nodes_;                                            ///< by node
    std::vector<Entity> morphs_;                                           ///< by node
    std::vector<Entity> surfaces_;                                         ///< by node
    std::multimap<std::int32_t, Entity> camera_entities_, light_entities_; ///< by camera and light of the file
    std::vector<std::pair<Entity, std::int32_t>> skinned_;
};

} // namespace

SpawnedModel spawn_model(World& world, const Model& model) {
    StoredModel stored;
    return spawn_model(world, model, stored);
}

SpawnedModel spawn_model(World& world, const Model& model, StoredModel& stored) {
    return ModelSpawner(world, model, stored).run();
}

} // namespace hachure
