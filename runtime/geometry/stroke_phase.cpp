#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/stroke_phase.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace hachure::geometry {
namespace {

/// How decided a line is between axes: an eighth power leaves a tenth of the weight to an axis that it runs along
/// three quarters as well.
double decided(double component) {
    const double squared = component * component;
    return squared * squared * squared * squared;
}

/// Within which part of the way round, as a sine, a stroke shows both sides of its texture blended.
constexpr double turning = 0.1;

/// What a place weighs that is not seen: a line all of which is transparent has a middle, too.
constexpr double least_mass = 1e-3;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// The straight piece of a line between two points.
struct Piece {
    glm::dvec2 middle, step;
    glm::dvec3 place;
    double arc, mass; ///< of its middle; opacity times length
};

template <class Visit> void each_piece(const StrokePhaseJob& job, const Polyline& line, Visit&& visit) {
    double arc = 0.0;
    for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i) {
        const LinePoint &a = job.lines->points[i - 1], &b = job.lines->points[i];
        const glm::dvec2 from(a.place), step = glm::dvec2(b.place) - from;
        const double length = glm::length(step);
        const double opacity = std::max(0.5 * (double(a.opacity) + double(b.opacity)), least_mass);
        visit(Piece{from + 0.5 * step, step, 0.5 * (glm::dvec3(job.places[i - 1]) + glm::dvec3(job.places[i])),
                    arc + 0.5 * length, opacity * length});
        arc += length;
    }
}

/// How far the line sweeps round its entity: 1 counter-clockwise all along, -1 clockwise.
double way_round(const StrokePhaseJob& job, const Polyline& line, glm::dvec2 origin) {
    double swept = 0.0, most = 0.0;
    each_piece(job, line, [&](const Piece& piece) {
        const double length = glm::length(piece.step);
        if (length <= 0.0) return;
        swept += piece.mass / length * cross(piece.middle - origin, piece.step);
        most += piece.mass * glm::length(piece.middle - origin);
    });
    return most > 0.0 ? swept / most : 0.0;
}

void weigh(StrokePhase& phase, const glm::dvec3& components) {
    const glm::dvec3 weights(decided(components.x), decided(components.y), decided(components.z));
    const double sum = weights.x + weights.y + weights.z;
    if (sum > 0.0) phase.weights = glm::vec3(weights / sum);
}

StrokePhase open_phase(const StrokePhaseJob& job, const Polyline& line) {
    double mass = 0.0, arc = 0.0;
    glm::dvec3 place(0.0), slope(0.0);
    each_piece(job, line, [&](const Piece& piece) {
        mass += piece.mass;
        arc += piece.mass * piece.arc;
        place += piece.mass * piece.place;
    });
    arc /= mass;
    place /= mass;
    each_piece(job, line, [&](const Piece& piece) { slope += piece.mass * (piece.arc - arc) * (piece.place - place); });
    StrokePhase phase;
    phase.fraction = glm::vec3(static_cast<float>(arc / double(line.length)));
    phase.ahead = glm::vec3(glm::sign(slope) * place);
    const double length = glm::length(slope);
    if (length > 0.0) weigh(phase, slope / length);
    return phase;
}

StrokePhase closed_phase(const StrokePhaseJob& job, const Polyline& line) {
    glm::dvec3 cosine(0.0), sine(0.0);
    const glm::dvec3 first(job.places[line.first]);
    each_piece(job, line, [&](const Piece& piece) {
        const double angle = 2.0 * std::numbers::pi * piece.arc / double(line.length);
        const glm::dvec3 weighed = glm::length(piece.step) * (piece.place - first);
        cosine += std::cos(angle) * weighed;
        sine += std::sin(angle) * weighed;
    });
    StrokePhase phase;
    glm::dvec3 amplitude;
    for (int axis = 0; axis < 3; ++axis) {
        phase.fraction[axis] = static_cast<float>(std::atan2(sine[axis], cosine[axis]) / (2.0 * std::numbers::pi));
        amplitude[axis] = std::hypot(sine[axis], cosine[axis]);
    }
    const double length = glm::length(amplitude);
    if (length > 0.0) weigh(phase, amplitude / length);
    return phase;
}

} // namespace

void StrokePhaseJob::validate() const {
    HACHURE_ASSERT(lines != nullptr && origins.size() == lines->lines.size(), "an origin per line");
    HACHURE_ASSERT(places.size() == lines->points.size(), "a place per point");
}

void StrokePhaseJob::run() {
    phases.clear();
    for (std::size_t i = 0; i < lines->lines.size(); ++i) {
        const Polyline& line = lines->lines[i];
        StrokePhase phase;
        if (line.length > 0.0f) phase = line.closed ? closed_phase(*this, line) : open_phase(*this, line);
        const double left = 0.5 - 0.5 * way_round(*this, line, origins[i]) / turning;
        phase.turn = static_cast<float>(glm::smoothstep(0.0, 1.0, left));
        phases.push_back(phase);
    }
}

} // namespace hachure::geometry
