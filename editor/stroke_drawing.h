#pragma once

#include <hachure/runtime/assets/svg_file.h>
#include <hachure/runtime/ecs/world.h>

namespace hachure {

/// Makes frames of this world know the lines of all entities that carry AbstractedLines, so that they can be written.
/// Throws Error naming `output` when no entity does.
void want_strokes(World& world, const std::string& output);

/// The strokes of the last frame as a drawing: a layer per entity, in it one per kind. Lines of entities that are drawn
/// as strokes thin out towards their free ends, those that pixels draw do not.
[[nodiscard]] assets::SvgDrawing stroke_drawing(const World& world);

} // namespace hachure
