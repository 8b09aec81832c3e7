#pragma once

#include <hachure/runtime/ecs/reflect.h>

#include <glm/vec3.hpp>

namespace hachure {

enum class LightKind { directional, point, spot };

/// What a light's direction and place are relative to.
enum class LightRig {
    world,  ///< it stands in the scene; its direction is the entity's -Z
    camera, ///< it moves with the camera: the entity's rotation is relative to the camera's axes
    gaze,   ///< as `camera`; directional light also turns with the line of sight to each point, from the camera's axis
};

/// A light of the scene. With rig `camera` and the default rotation of `spawn_default_light` it comes from up and to
/// the right, perpendicular to the gaze, so that l.n spans [-1, 1] over what is seen (Gooch 1998, section 4.2). In a
/// perspective view that holds on the camera's axis, and less far from it; with rig `gaze` it holds everywhere.
struct Light {
    LightKind kind = LightKind::directional;
    LightRig rig = LightRig::world;
    glm::vec3 color{1.0f};
    float intensity = 1.0f;
    float range = 0.0f;
    float inner_cone = 0.0f;
    float outer_cone = 0.785398f;

    friend bool operator==(const Light&, const Light&) = default;
};

/// Marks the light that a scene gets which brings none: a style may place it as suits it.
struct DefaultLight {};

inline void reflect(TypeBuilder<Light>& type) {
    type.name("light").doc("a light; shines along the entity's -Z");
    type.field("kind", &Light::kind).doc("kind of light").options({"directional", "point", "spot"});
    type.field("rig", &Light::rig)
        .doc("stands in the world, moves with the camera, or also turns with the line of sight to each point")
        .options({"world", "camera", "gaze"});
    type.field("color", &Light::color).color().doc("colour of the light");
    type.field("intensity", &Light::intensity).doc("strength").range(0, 1e9);
    type.field("range", &Light::range).doc("distance at which it ends; 0 for no limit").unit("m").range(0, 1e12);
    type.field("inner_cone", &Light::inner_cone).doc("angle of full strength (spot)").unit("rad").range(0, 1.5708);
    type.field("outer_cone", &Light::outer_cone).doc("angle where it ends (spot)").unit("rad").range(0, 1.5708);
}

} // namespace hachure
