#pragma once

#include <hachure/components/shade_strokes.h>
#include <hachure/components/toon.h>

#include <glm/vec3.hpp>

#include <span>
#include <string_view>

namespace sun_walk {

/// What things are drawn with: strokes, and flat tones under them.
struct Look {
    std::string_view name;
    hachure::ShadeStrokes strokes;
    hachure::Toon tones;
    glm::vec3 background;
};

/// At least two; the first is that which the sample begins with.
[[nodiscard]] std::span<const Look> looks();

} // namespace sun_walk
