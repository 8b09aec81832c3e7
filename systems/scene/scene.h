#pragma once

namespace hachure {

class App;

/// Scene files (docs/scenes.md): see load_scene.h, save_scene.h. It has no systems; entities remember what their file
/// said of them (components/scene.h).
void register_scene(App& app);

} // namespace hachure
