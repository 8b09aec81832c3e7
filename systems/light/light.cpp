#include <hachure/components/name.h>
#include <hachure/components/transform.h>
#include <hachure/components/world_transform.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/scene/light_list.h>
#include <hachure/runtime/scene/light_strength.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/light/light.h>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace hachure {
namespace {

/// Place and axes of a light in the world; a light that moves with the camera has its transform in the camera's axes.
glm::mat4 world_from_light(const Light& light, const glm::mat4& transform, const View& view) {
    if (light.rig == LightRig::world) return transform;
    return glm::inverse(view.view_from_world) * transform;
}

ShadingLight shading_light(const Light& light, const glm::mat4& place) {
    ShadingLight result;
    const glm::vec3 backward = glm::normalize(glm::vec3(place[2]));
    const bool directional = light.kind == LightKind::directional;
    result.position = directional ? glm::vec4(backward, 0.0f) : glm::vec4(glm::vec3(place[3]), 1.0f);
    result.direction = -backward;
    result.color = light.color * light.intensity;
    result.range = light.range;
    result.spot = light.kind == LightKind::spot;
    result.inner_cone = light.inner_cone;
    result.outer_cone = std::max(light.outer_cone, light.inner_cone + 1e-4f);
    result.gaze = directional && light.rig == LightRig::gaze;
    return result;
}

float strength(const ShadingLight& light) { return std::max({light.color.r, light.color.g, light.color.b}); }

/// Up and to the right of the camera, perpendicular to the gaze.
struct StandardLight {
    Light light{.rig = LightRig::camera};
    /// Turns +Z, where a light comes from, to (1, 1, 0) / sqrt 2: a quarter turn about (-1, 1, 0) / sqrt 2.
    glm::quat rotation = glm::angleAxis(1.57079632679f, glm::normalize(glm::vec3(-1.0f, 1.0f, 0.0f)));

    [[nodiscard]] glm::mat4 pose() const { return glm::mat4_cast(rotation); }
};

void gather_lights(Query<const Light, const WorldTransform> placed, const View& view, LightList& list,
                   LightStrength& whole) {
    std::vector<std::pair<Entity, ShadingLight>> found;
    for (auto [entity, light, transform] : placed) {
        const glm::mat4 place = world_from_light(light, transform.matrix, view);
        if (glm::length(glm::vec3(place[2])) > 0.0f) found.emplace_back(entity, shading_light(light, place));
    }
    if (found.empty()) {
        const StandardLight standard;
        found.emplace_back(Entity::null,
                           shading_light(standard.light, world_from_light(standard.light, standard.pose(), view)));
    }
    std::ranges::sort(found, [](const auto& a, const auto& b) {
        const float sa = strength(a.second), sb = strength(b.second);
        return sa != sb ? sa > sb : a.first < b.first;
    });
    if (found.size() > LightList::max_lights) found.resize(LightList::max_lights);
    const float strongest = found.empty() ? 0.0f : strength(found.front().second);
    whole.strongest = strongest;

    list.lights.clear();
    for (auto& [entity, light] : found) {
        // Tones are relative: the strongest light gives full colour whatever its unit (lux, candela).
        light.color = strongest > 0.0f ? light.color / strongest : glm::vec3(0.0f);
        list.lights.push_back(light);
    }
}

} // namespace

Entity spawn_default_light(World& world) {
    const StandardLight standard;
    const Entity entity = world.create();
    world.add(entity, Transform{.rotation = standard.rotation});
    world.add(entity, standard.light);
    world.add(entity, DefaultLight{});
    world.add(entity, Name{"light"});
    return entity;
}

void register_light(App& app) {
    app.add_component<Light>();
    app.world().set_resource(LightList{});
    app.world().set_resource(LightStrength{});
    app.add_system(Stage::light, "light", gather_lights).after("camera");
}

} // namespace hachure
