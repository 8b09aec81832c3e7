#pragma once

#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/ecs/world.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hachure {

/// What spawn_model put into the world.
struct SpawnedModel {
    Entity root;                  ///< all else is below it: to move, copy or destroy the model
    std::vector<Entity> surfaces; ///< entities with Surface, in the order of the file's nodes
    std::vector<Entity> cameras;  ///< the first is active
    std::vector<Entity> lights;
    std::vector<glm::vec3> points;     ///< every vertex of every surface that a triangle uses, in the world, at rest
    std::vector<std::string> clips;    ///< names of what an Animation of the root can play, in the order of the file
    std::vector<std::string> warnings; ///< one line each: images that could not be used, repaired weights and clips
};

/// Puts the default scene of `model` into `world`: an entity per node, with Name, Transform, and Surface, Camera and
/// Light as the node says, below a root; meshes and textures go to the world's MeshStore. Skinned surfaces
/// stand below the root with a Skin, morphing ones have MorphWeights; the root of a model with clips has a Rig, and
/// plays them when it is given an Animation. Characters stand in their rest pose.
SpawnedModel spawn_model(World& world, const assets::Model& model);

/// What of a model is in the stores of a world, so that the model can be spawned again without being stored again.
struct StoredModel {
    std::map<std::pair<std::int32_t, std::size_t>, std::uint32_t> meshes; ///< by mesh and number of joints
    std::map<std::int32_t, std::uint32_t> bindings;                       ///< by skin
    std::optional<std::uint32_t> clips;                                   ///< index into the ClipStore
    std::optional<std::vector<glm::vec3>> points;                         ///< as SpawnedModel::points
};

/// The same for a model that is spawned many times: what `stored` holds is used, what it lacks is stored and noted. It
/// is for one model and one world. After the first time the model's vertices and images are not read any more.
SpawnedModel spawn_model(World& world, const assets::Model& model, StoredModel& stored);

} // namespace hachure
