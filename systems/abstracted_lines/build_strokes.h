#pragma once

#include <hachure/runtime/geometry/link_ridges.h>
#include <hachure/runtime/geometry/reconcile_polylines.h>
#include <hachure/runtime/geometry/simplify_polylines.h>
#include <hachure/runtime/geometry/stroke_phase.h>
#include <hachure/runtime/geometry/trace_ridges.h>
#include <hachure/runtime/scene/stroke_set.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/abstracted_lines/stroke_frame.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure {

/// What the GPU found of lines, row by row, the bottom row first.
struct RidgeMaps {
    int width = 0, height = 0;
    std::vector<glm::vec4> points, directions;                   ///< diffuse, as geometry::RidgeImage
    std::vector<glm::vec4> specular_points, specular_directions; ///< likewise
    std::vector<std::uint32_t> owners;                           ///< object ids
    std::vector<float> depths;                                   ///< window depth, reversed: 0 where nothing is
};

/// Makes strokes of what the GPU found: kind by kind, on several threads; the result does not depend on them.
class StrokeBuilder {
public:
    void build(const RidgeMaps& maps, const StrokeFrame& frame, const View& view, StrokeSet& set);

private:
    /// What becomes strokes of one kind.
    struct Work {
        StrokeKind kind = StrokeKind::dark;
        geometry::TraceRidgesJob trace;
        geometry::LinkRidgesJob link;
        geometry::ReconcilePolylinesJob reconcile;
        geometry::SimplifyPolylinesJob simplify;
        geometry::StrokePhaseJob phase;
        std::vector<float> depths;      ///< by point of `reconcile`
        std::vector<glm::vec3> places;  ///< likewise
        std::vector<glm::vec2> origins; ///< by line
    };

    void run(Work& work, const RidgeMaps& maps, const StrokeFrame& frame, const View& view) const;
    static void append(const Work& work, const StrokeFrame& frame, StrokeSet& set);

    std::array<Work, stroke_kinds> works_;
    std::vector<geometry::LineLimits> limits_; ///< by owner
};

} // namespace hachure
