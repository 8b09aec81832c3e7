#pragma once

#include <hachure/runtime/geometry/polylines.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace hachure::geometry {

/// How a texture lies along a stroke, three times over: once for each axis of its entity, blended by `weights`. At arc
/// length s of a stroke of length L the texture's coordinate for an axis is s + ahead - fraction * L, in pixels.
struct StrokePhase {
    glm::vec3 ahead{0.0f};
    glm::vec3 fraction{0.5f};
    glm::vec3 weights{1.0f, 0.0f, 0.0f}; ///< sum 1; mostly one of them is
    float turn = 0.5f; ///< how much of the texture shows with its left on the right: 0 or 1 but for a short change
};

/// Says where the textures of strokes begin, from nothing but this frame, so that they still stay put.
///
/// Where a line begins and ends changes from frame to frame, so that what is counted from an end slides. Here a line is
/// counted from its centre of gravity, opacity being the mass, to which ends that fade in and out do not matter. That
/// centre has the coordinate that it has on an axis of its entity: it is the same wherever the entity moves and turns,
/// and where the line runs along the axis and only part of it shows, the parts agree. Of the three axes that one counts
/// which the line runs along best, with others blended in where it runs between them.
///
/// The coordinate has the sign of the line's direction along the axis, and a line has none: textures are to be
/// mirrored at 0 (and wherever they end), then both signs give one picture. Which side of the texture is left follows
/// from which way round the stroke runs about its entity; where it runs straight towards it, both are blended.
///
/// A closed line begins, for each axis, where its first harmonic along that axis is at its most, and its coordinate is
/// to go both ways round from there until it meets: no seam, and no need for whole periods.
struct StrokePhaseJob {
    const PolylineSet* lines = nullptr; ///< before they are simplified: what is integrated should be dense
    std::span<const glm::vec3> places;  ///< by point: in the axes of its entity, in units of a pixel at the entity
    std::span<const glm::vec2> origins; ///< by line: where its entity is in the picture, pixels

    std::vector<StrokePhase> phases{}; ///< out, by line; kept from run to run

    /// Asserts that sizes agree.
    void validate() const;
    void run();
};

} // namespace hachure::geometry
