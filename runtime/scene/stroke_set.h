#pragma once

#include <hachure/runtime/ecs/entity.h>
#include <hachure/runtime/geometry/polylines.h>
#include <hachure/runtime/geometry/stroke_phase.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <string_view>
#include <vector>

namespace hachure {

/// What a line is drawn for, in the order of drawing.
enum class StrokeKind : std::uint8_t { dark, specular_dark, highlight, specular };
inline constexpr std::size_t stroke_kinds = 4;

[[nodiscard]] constexpr std::string_view name_of(StrokeKind kind) {
    switch (kind) {
    case StrokeKind::dark:
        return "dark";
    case StrokeKind::specular_dark:
        return "specular_dark";
    case StrokeKind::highlight:
        return "highlight";
    case StrokeKind::specular:
        break;
    }
    return "specular";
}

/// A line of the picture as one stroke.
struct Stroke {
    Entity entity;
    StrokeKind kind = StrokeKind::dark;
    bool drawn = false;          ///< as a stroke; else only known
    geometry::Polyline line;     ///< of the set's points
    geometry::StrokePhase phase; ///< where its texture lies
    glm::vec3 color{0.0f};       ///< linear
    float taper = 0.0f;          ///< over how many of its widths it thins out towards its free ends
};

/// The lines of the last frame that was drawn, as strokes: first by kind, then as they were found. Places are in pixels
/// from the picture's lower left corner. A resource, made by systems/abstracted_lines.
struct StrokeSet {
    /// The program wants the strokes of all entities that have such lines, however they are drawn. Else there are those
    /// of frames in which some entity is drawn as strokes.
    bool wanted = false;

    int width = 0, height = 0; ///< of the picture, pixels
    std::vector<geometry::LinePoint> points;
    std::vector<Stroke> strokes;
};

} // namespace hachure
