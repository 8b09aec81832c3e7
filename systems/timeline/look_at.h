#pragma once

#include <hachure/runtime/ecs/world.h>

#include <glm/vec3.hpp>

namespace hachure {

/// The place of an entity in the world, from the Transforms of it and of all above as they are now, before the stage
/// transform has written WorldTransform.
[[nodiscard]] glm::dvec3 place_in_world(const World& world, Entity entity);

/// Turns an entity so that its -Z points to a place of the world, its +Y as far up as it can. False when nothing
/// changed: it does already, stands there itself, or has no Transform.
bool turn_to(World& world, Entity entity, const glm::dvec3& place);

} // namespace hachure
