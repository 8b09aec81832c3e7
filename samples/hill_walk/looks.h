#pragma once

#include <hachure/components/implicit_brush.h>
#include <hachure/components/toon.h>

#include <span>
#include <string_view>
#include <vector>

namespace hill_walk {

/// What something is drawn with: flat tones, and any number of brushes over them.
struct Look {
    std::string_view name;
    hachure::Toon tones;
    std::vector<hachure::ImplicitBrush> brushes;
};

/// At least two each; the first of the ground, and the first and second of figures, are those that the sample begins
/// with.
[[nodiscard]] std::span<const Look> ground_looks();
[[nodiscard]] std::span<const Look> figure_looks();

} // namespace hill_walk
