#pragma once

#include <hachure/runtime/gpu/shader_source.h>
#include <hachure/runtime/scene/light_list.h>

#include <algorithm>
#include <string>
#include <vector>

namespace hachure {

/// Lights up to this many are unrolled; more are a loop, so that their number makes no program of its own.
constexpr std::size_t max_unrolled_lights = 4;

/// Adds what lets shaders/common/lights.glsl leave out all that these lights don't do. On llvmpipe one directional
/// light takes a third of the time that way, as much as without a loop over lights.
inline void add_light_defines(const LightList& list, std::vector<gpu::ShaderDefine>& defines) {
    if (list.lights.size() > max_unrolled_lights) return;
    defines.push_back({"LIGHT_COUNT", std::to_string(list.lights.size())});
    const auto any = [&](auto&& is) { return std::ranges::any_of(list.lights, is); };
    if (any([](const ShadingLight& light) { return light.spot || light.range > 0.0f; }))
        defines.push_back({"LIGHTS_END", ""});
    if (any([](const ShadingLight& light) { return light.gaze; })) defines.push_back({"LIGHTS_GAZE", ""});
}

} // namespace hachure
