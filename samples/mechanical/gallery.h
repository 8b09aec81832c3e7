#pragma once

#include <hachure/runtime/assets/model.h>

#include <vector>

#include "figure.h"

/// The model in white, without textures: what lines alone are drawn on.
hachure::assets::Model whitened(hachure::assets::Model model);

/// What the renderer does, in three rows: a character in tones and in toon, a statue in tones and, whitened, in lines
/// alone; the statue in lines of tone, brushes and strokes, the character in strokes; below them figure 10. `character`
/// stands in the middle of its walk, where it has a clip of that name.
std::vector<Cell> gallery(const hachure::assets::Model& character, const hachure::assets::Model& statue,
                          const hachure::assets::Model& white_statue, const hachure::assets::Model& part);
