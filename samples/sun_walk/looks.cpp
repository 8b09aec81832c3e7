#include "looks.h"

#include <array>

namespace sun_walk {
namespace {

using namespace hachure;

/// One colour, whatever the light: strokes alone say where it is dark.
Toon paper(const glm::vec3& color) { return {.light = color, .shade = color, .ramp_use = RampUse::replace}; }

Look pencil() {
    constexpr glm::vec3 white(1.0f);
    return {
        "pencil", {.line_width = 1.3f, .tip = ShadeTip::pencil, .color = {0.05f, 0.05f, 0.06f}}, paper(white), white};
}

Look ink() {
    constexpr glm::vec3 cream(0.93f, 0.88f, 0.76f);
    return {
        "ink",
        {.amplitude = 0.006f, .line_width = 1.0f, .tip = ShadeTip::ink, .color = {0.0f, 0.01f, 0.06f}, .opacity = 1.0f},
        paper(cream),
        cream};
}

/// Strokes over tones of their own: the model is drawn under them.
Look charcoal() {
    return {"charcoal over tones",
            {.amplitude = 0.012f, .line_width = 3.0f, .tip = ShadeTip::charcoal, .color = {0.02f, 0.015f, 0.015f}},
            {.bands = 3, .light = {1.0f, 0.86f, 0.62f}, .shade = {0.62f, 0.4f, 0.32f}, .ramp_use = RampUse::replace},
            {0.96f, 0.9f, 0.8f}};
}

} // namespace

std::span<const Look> looks() {
    static const std::array all{pencil(), ink(), charcoal()};
    return all;
}

} // namespace sun_walk
