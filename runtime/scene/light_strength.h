#pragma once

namespace hachure {

/// How strong the light is that the colours of this frame's LightList are relative to: the strongest of the scene, in
/// the unit of its file. A resource of its own: to most who are lit it means nothing. systems/light fills it in.
struct LightStrength {
    float strongest = 1.0f;
};

} // namespace hachure
