#pragma once

#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/ecs/world.h>

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace hachure {

/// What spawn_model put into the world.
struct SpawnedModel {
    std::vector<Entity> roots;
    std::vector<Entity> surfaces; ///< entities with Surface, in the order of the file's nodes
    std::vector<Entity> cameras;  ///< the first is active
    std::vector<Entity> lights;
    std::vector<glm::vec3> points;     ///< every vertex of every surface that a triangle uses, in the world
    std::vector<std::string> warnings; ///< images that could not be used, one line each
};

/// Puts the default scene of `model` into `world`: an entity per node, with Name, Transform, and Surface, Camera and
/// Light as the node says; meshes and textures go to the world's MeshStore. Characters stand in their rest
/// pose.
SpawnedModel spawn_model(World& world, const assets::Model& model);

} // namespace hachure
