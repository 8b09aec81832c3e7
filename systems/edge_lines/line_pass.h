#pragma once

#include <hachure/runtime/ecs/world.h>

namespace hachure {

/// Declares the pass `edge_lines`, which draws the groups of EdgeLineFrame into the texture `line_layer`
/// (premultiplied) and, where it is wanted, `hidden_lines`.
void declare_line_pass(World& world);

} // namespace hachure
