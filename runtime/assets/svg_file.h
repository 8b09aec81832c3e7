#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hachure::assets {

/// A place on a line of a drawing.
struct SvgPoint {
    glm::vec2 place{0.0f}; ///< pixels from the upper left corner
    float width = 1.0f;    ///< of the line there, pixels
    float opacity = 1.0f;  ///< 0 to 1
};

struct SvgLine {
    std::vector<SvgPoint> points; ///< at least two; a closed line repeats its first one at the end
    bool closed = false;
};

/// A layer of a drawing: what editors (Inkscape) list by name, show and hide.
struct SvgLayer {
    std::string label;     ///< any text
    std::string id;        ///< letters, digits, '-' and '_', beginning with a letter; its own in the drawing
    glm::vec3 color{0.0f}; ///< of its lines, linear
    std::vector<SvgLine> lines;
    std::vector<SvgLayer> layers; ///< above its lines
};

/// A drawing of lines.
struct SvgDrawing {
    int width = 0, height = 0;  ///< pixels
    glm::vec3 background{1.0f}; ///< linear
    std::vector<SvgLayer> layers;
};

/// The drawing as SVG 1.1 with Inkscape's layers. A line of one width and opacity is a path with a stroke of that
/// width, round caps and joins; one whose width varies is its filled outline; one whose opacity does, outlines of a
/// twelfth of opacity at most each, that meet edge to edge. Numbers have two decimals.
[[nodiscard]] std::string svg_text(const SvgDrawing& drawing);

/// Writes it; the file appears whole or not at all. Throws Error naming the file.
void write_svg(const std::filesystem::path& file, const SvgDrawing& drawing);

/// Whether the file is there and is a whole drawing of that size, as `write_svg` makes them.
[[nodiscard]] bool is_whole_svg(const std::filesystem::path& file, int width, int height);

} // namespace hachure::assets
