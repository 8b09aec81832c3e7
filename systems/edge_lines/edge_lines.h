#pragma once

namespace hachure {

class App;

/// Surfaces that carry EdgeLines get lines along their silhouettes, creases and borders: edges are chosen on the CPU
/// when view or mesh moved, and drawn as anti-aliased strips whose visibility the depth buffer decides. The lines of
/// all entities go into the texture `line_layer` (premultiplied, combined by maximum, so that joints don't darken).
void register_edge_lines(App& app);

} // namespace hachure
