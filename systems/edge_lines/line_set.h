#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace hachure {

/// What a line is drawn for. Where lines of two kinds meet, the later one in this list lies on top.
enum class DrawnKind : std::uint8_t { suggestive, material, crease, intersection, border, silhouette };
inline constexpr std::size_t drawn_kinds = 6;

/// As a lift: the line is hidden wherever it is.
inline constexpr float never_seen = -std::numeric_limits<float>::infinity();

/// Consecutive points of a LineSet that make one line.
struct LineChain {
    std::uint32_t first = 0;
    std::uint32_t count = 0; ///< points; a closed line repeats its first one at the end
    DrawnKind kind = DrawnKind::silhouette;
    bool closed = false; ///< has no ends
};

/// Lines of an entity in its space, sorted by kind.
struct LineSet {
    std::vector<glm::vec3> points;
    std::vector<float> weights; ///< per point: opacity, 0 to 1
    std::vector<float> lifts;   ///< per point: metres towards the eye from where it is asked whether it is seen
    std::vector<LineChain> chains;

    void clear() {
        points.clear();
        weights.clear();
        lifts.clear();
        chains.clear();
    }
};

/// A piece of a line as it is drawn, in pixels from the picture's lower left corner. The layout is what
/// shaders/edge_lines/edge_lines.vert reads per instance; all of it is linear along the piece on the screen.
struct LineSegment {
    glm::vec2 start, end;
    glm::vec2 depth;      ///< window depth at start and end
    glm::vec2 half_width; ///< pixels
    glm::vec2 weight;     ///< opacity
    glm::vec2 arc;        ///< pixels along the line, from its beginning
    glm::vec2 ends; ///< where on that scale the line begins and ends, for its taper; far away where it has no ends
};

} // namespace hachure
