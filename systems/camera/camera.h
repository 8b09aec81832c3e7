#pragma once

#include <hachure/components/camera.h>
#include <hachure/components/transform.h>
#include <hachure/runtime/ecs/world.h>
#include <hachure/runtime/scene/view.h>

#include <glm/vec3.hpp>

#include <span>

namespace hachure {

class App;

/// The resource View follows the active camera and the Canvas.
void register_camera(App& app);

/// The view of `camera` standing at `world_from_camera` (turned and placed; its scale is ignored) on a canvas.
[[nodiscard]] View make_view(const Camera& camera, const glm::mat4& world_from_camera, Canvas canvas);

/// Adds a perspective camera that sees all of `points` (in the world, at least one) as large as `canvas` allows with a
/// small margin, from the front, a little from the right and above.
Entity spawn_framing_camera(World& world, std::span<const glm::vec3> points, Canvas canvas);

} // namespace hachure
