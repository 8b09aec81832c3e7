#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace hachure::geometry {

/// A place on a line in the picture.
struct LinePoint {
    glm::vec2 place{0.0f}; ///< pixels
    float width = 0.0f;    ///< of the line there, pixels
    float opacity = 0.0f;  ///< 0 to 1
};

/// Consecutive points of a PolylineSet.
struct Polyline {
    std::uint32_t first = 0, count = 0; ///< points, at least two; a closed line repeats its first one at the end
    std::uint32_t owner = 0;            ///< whose line it is
    float length = 0.0f;                ///< pixels
    bool closed = false;                ///< has no ends
    bool start_joined = false;          ///< begins at a junction: other lines have the very same point there
    bool end_joined = false;            ///< likewise
};

/// Lines in the picture.
struct PolylineSet {
    std::vector<LinePoint> points;
    std::vector<Polyline> lines;

    void clear() {
        points.clear();
        lines.clear();
    }
};

} // namespace hachure::geometry
