#pragma once

#include <hachure/components/model_extras.h>
#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/ecs/reflect.h>
#include <hachure/runtime/ecs/world.h>

#include <span>
#include <string>
#include <vector>

namespace hachure {

/// Writes what the entity's ModelExtras say into its components, and adds those that it lacks; does nothing where there
/// are none. What holds for `surface` alone: an entity without a mesh does not get one. spawn_model and apply_style
/// call it: what a file says of its own things comes before what a style says of all.
void apply_model_extras(World& world, Entity entity);

/// The entities of a model, for what its file says of them.
struct ModelEntities {
    Entity root;
    std::span<const Entity> nodes;    ///< by node of the file; null for those that are in no scene
    std::span<const Entity> surfaces; ///< by node of the file: what draws its mesh, often the node's own entity
};

/// What the file says of a spawned model (assets/gltf_extras.h), in the order in which it applies: materials, which
/// speak of the surfaces that use them, then nodes, then the scene, which speaks of the root.
struct FileExtras {
    struct Said {
        Entity entity;
        ModelExtras::Component component;
    };
    std::vector<Said> said;
    std::string style;                 ///< a style's name or the path of its file, that the scene asks for; often empty
    std::vector<std::string> warnings; ///< what is wrong, by component or field, and skipped; one line each
};

/// Reads them, and gives the entities the parts (runtime/scene/scene_parts.h) that they have; what is said of
/// components is returned. Everything of the model is in the world by now. Fields that hold entities are paths of
/// names, those that hold files are relative to the folder of the model and stay inside it.
[[nodiscard]] FileExtras read_model_extras(World& world, const TypeRegistry& types, const assets::Model& model,
                                           const ModelEntities& entities);

} // namespace hachure
