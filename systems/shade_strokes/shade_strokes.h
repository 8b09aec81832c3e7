#pragma once

namespace hachure {

class App;

/// Surfaces that carry ShadeStrokes get sketchy strokes where they are dark, which follow the light (Sorman & Hult
/// 2005): found and kept up to date on the CPU, drawn by the GPU into the texture `line_layer`. docs/shade-strokes.md
/// says how.
void register_shade_strokes(App& app);

} // namespace hachure
