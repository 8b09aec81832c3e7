#pragma once

#include <hachure/runtime/scene/stroke_set.h>
#include <hachure/systems/abstracted_lines/stroke_frame.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// A straight piece of a stroke as it is drawn, in pixels from the picture's lower left corner. The layout is what
/// shaders/abstracted_lines/stroke.vert reads per instance; all pairs are linear along the piece.
struct StrokeSegment {
    glm::vec2 start, end;
    glm::vec2 half_width; ///< pixels
    glm::vec2 opacity;
    glm::vec2 arc;     ///< pixels along the stroke, from its first point
    glm::vec2 ends;    ///< where on that scale it begins and ends, for its taper; far away where it has no free ends
    glm::vec3 ahead;   ///< of the texture's coordinate for each axis: at arc length 0
    glm::vec3 weights; ///< of the three
    glm::vec2 turn;    ///< how much of the texture is turned over; the length of a closed stroke, else 0
};

/// Segments of one entity and colour, drawn with one call.
struct StrokeBatch {
    std::uint32_t owner = 0; ///< object id
    std::uint32_t first = 0, count = 0;
};

/// Batches of one colour that are combined by their maximum, so that joints and crossings don't darken, and then laid
/// over the groups before.
struct StrokeGroup {
    glm::vec3 color{0.0f};
    std::vector<StrokeBatch> batches;
};

/// What is drawn of strokes.
struct StrokeBatches {
    std::vector<StrokeSegment> segments;
    std::vector<StrokeGroup> groups;

    /// From the strokes that are to be drawn: kind by kind, in the order of owners within one.
    void fill(const StrokeSet& set);
};

} // namespace hachure
