#pragma once

namespace hachure {

class App;

/// Surfaces that carry EdgeLines get lines: found on the CPU when view or mesh moved, clipped there or tested against a
/// finer depth buffer, and drawn as anti-aliased strips into the texture `line_layer` (premultiplied); or, cheaper and
/// coarser, from differences of neighbouring pixels. docs/edge-lines.md says how.
void register_edge_lines(App& app);

} // namespace hachure
