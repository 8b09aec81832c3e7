#pragma once

#include <hachure/tests/support/shade_rig.h>

#include <cmath>
#include <ctime>
#include <vector>

namespace hachure::bench {

/// Milliseconds that all threads have computed so far: other programs on the machine don't count.
inline double busy_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Milliseconds of the sweep over the light and of the update of strokes.
struct ShadeFrameCost {
    double light_ms, update_ms;
    [[nodiscard]] double ms() const { return light_ms + update_ms; }
};

/// Where the sun of the frames stands, at an angle around the Y axis.
inline glm::vec3 sun_at(double degrees) {
    const auto a = static_cast<float>(glm::radians(degrees));
    return {std::sin(a), 0.4f, std::cos(a)};
}

/// One frame.
inline ShadeFrameCost shade_frame(test::ShadeRig& rig, double degrees) {
    const double start = busy_ms();
    const std::vector<ShadingLight> lights{test::shade_sun(sun_at(degrees))};
    rig.light.lights = lights;
    rig.light.run();
    rig.light.lights = {};
    const double middle = busy_ms();
    rig.update.changed = rig.light.swept;
    rig.update.run();
    return {middle - start, busy_ms() - middle};
}

} // namespace hachure::bench
