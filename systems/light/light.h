#pragma once

#include <hachure/components/light.h>
#include <hachure/runtime/ecs/world.h>

namespace hachure {

class App;

/// The resource LightList follows the Light entities and, for lights that ride with the camera, the View. A world
/// without a Light is lit by the default one.
void register_light(App& app);

/// Adds the light of Gooch 1998, section 4.2: up and to the right of the camera, perpendicular to the gaze, white.
Entity spawn_default_light(World& world);

} // namespace hachure
