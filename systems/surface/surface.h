#pragma once

namespace hachure {

class App;

/// What is drawn: the resource DrawList follows Surface, WorldTransform and the View; the frame's targets (`color`,
/// `depth_buffer`, and on request the AOVs `depth`, `normal`, `object_id`) are made and cleared; surfaces that no
/// capability shades are drawn in their plain colour.
void register_surface(App& app);

} // namespace hachure
