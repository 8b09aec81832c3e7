#pragma once

namespace hachure {

class App;

/// AOV `velocity`: how far what a pixel shows has moved on the screen since the frame before, by camera, transform and
/// deformation. Only when asked for; nothing is kept from frame to frame before.
void register_velocity(App& app);

} // namespace hachure
