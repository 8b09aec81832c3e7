#pragma once

#include <hachure/components/camera.h>
#include <hachure/components/light.h>
#include <hachure/runtime/assets/model.h>
#include <hachure/runtime/ecs/reflect.h>

#include <nlohmann/json.hpp>

namespace hachure {

/// The glTF camera that is most like the component. `before` is what the file had, or a default one: its name, aspect
/// and width stay.
[[nodiscard]] assets::Camera gltf_camera(const Camera& camera, assets::Camera before);
[[nodiscard]] assets::Light gltf_light(const Light& light, assets::Light before);

/// The fields in which the component differs from what a reader of the glTF camera makes of it; the first camera of a
/// file is active. Empty for none.
[[nodiscard]] nlohmann::json camera_extras(const TypeRegistry& types, const Camera& camera,
                                           const assets::Camera& written, bool first);
[[nodiscard]] nlohmann::json light_extras(const TypeRegistry& types, const Light& light, const assets::Light& written);

} // namespace hachure
