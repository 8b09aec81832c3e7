#pragma once

namespace hachure {

class App;

/// Surfaces that carry Toon are drawn with flat tones ("toon.claim", "toon.pass"), cut from the light that they receive
/// (shaders/common/tone.glsl). Those that ask for abstracted normals get AbstractedNormals ("toon.normals", stage
/// deform).
void register_toon(App& app);

} // namespace hachure
