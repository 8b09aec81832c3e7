#pragma once

#include <hachure/components/camera.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/geometry/bounds.h>
#include <hachure/runtime/scene/view.h>

namespace hachure {

class App;

/// The resource View follows the active camera and the Canvas.
void register_camera(App& app);

/// The view of `camera` standing at `world_from_camera` (turned and placed; its scale is ignored) on a canvas.
[[nodiscard]] View make_view(const Camera& camera, const glm::mat4& world_from_camera, Canvas canvas);

/// Adds a perspective camera that sees all of `bounds` on `canvas`, from the front, a little from the right and above.
Entity spawn_framing_camera(World& world, const geometry::Bounds& bounds, Canvas canvas);

} // namespace hachure
