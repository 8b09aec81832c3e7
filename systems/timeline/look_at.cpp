#include <hachure/components/transform.h>
#include <hachure/systems/timeline/look_at.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>

namespace hachure {
namespace {

/// The turn that brings -Z to `direction` (unit), with Y in the half plane of `up` (unit).
glm::dquat turn_along(const glm::dvec3& direction, const glm::dvec3& up) {
    glm::dvec3 right = glm::cross(direction, up);
    // Straight up or down: then Z is as good as Y.
    if (glm::length(right) < 1e-6) right = glm::cross(direction, glm::dvec3(0.0, 0.0, -1.0));
    if (glm::length(right) < 1e-6) right = glm::cross(direction, glm::dvec3(1.0, 0.0, 0.0));
    right = glm::normalize(right);
    return glm::quat_cast(glm::dmat3(right, glm::cross(right, direction), -direction));
}

} // namespace

glm::dvec3 place_in_world(const World& world, Entity entity) {
    glm::dvec3 place(0.0);
    for (; entity; entity = world.parent(entity))
        if (const Transform* above = world.find<Transform>(entity))
            place = glm::dvec3(above->translation) + glm::dquat(above->rotation) * (glm::dvec3(above->scale) * place);
    return place;
}

bool turn_to(World& world, Entity entity, const glm::dvec3& place) {
    const Transform* transform = world.find<Transform>(entity);
    const glm::dvec3 way = place - place_in_world(world, entity);
    const double length = glm::length(way);
    if (!transform || !(length > 1e-9) || !std::isfinite(length)) return false;
    glm::dquat above(1.0, 0.0, 0.0, 0.0);
    for (Entity parent = world.parent(entity); parent; parent = world.parent(parent))
        if (const Transform* turned = world.find<Transform>(parent)) above = glm::dquat(turned->rotation) * above;
    const glm::dquat wanted = glm::conjugate(above) * turn_along(way / length, glm::dvec3(0.0, 1.0, 0.0));
    const glm::quat rotation(glm::normalize(wanted));
    if (rotation == transform->rotation) return false;
    world.find_mutable<Transform>(entity)->rotation = rotation;
    return true;
}

} // namespace hachure
