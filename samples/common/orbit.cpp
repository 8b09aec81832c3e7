#include <hachure/components/transform.h>
#include <hachure/samples/common/orbit.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>

namespace samples {

using namespace hachure;

Orbit::Orbit(World& world, Entity camera, float distance) : world_(world), camera_(camera), distance_(distance) {
    const Transform& transform = world_.get<Transform>(camera_);
    pivot_ = transform.translation - transform.rotation * glm::vec3(0.0f, 0.0f, distance_);
}

void Orbit::turn(float yaw, float pitch) {
    Transform& transform = world_.get_mutable<Transform>(camera_);
    transform.rotation = glm::normalize(glm::angleAxis(-yaw, glm::vec3(0.0f, 1.0f, 0.0f)) * transform.rotation *
                                        glm::angleAxis(-pitch, glm::vec3(1.0f, 0.0f, 0.0f)));
    place();
}

void Orbit::approach(float factor) {
    zoom_ = std::clamp(zoom_ * factor, 0.3f, 10.0f);
    place();
}

void Orbit::place() {
    Transform& transform = world_.get_mutable<Transform>(camera_);
    transform.translation = pivot_ + transform.rotation * glm::vec3(0.0f, 0.0f, distance_ * zoom_);
}

} // namespace samples
