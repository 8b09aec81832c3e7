#pragma once

#include <hachure/runtime/geometry/claimed_middles.h>
#include <hachure/runtime/geometry/link_ridges.h>
#include <hachure/runtime/geometry/polylines.h>
#include <hachure/runtime/geometry/trace_ridges.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hachure::geometry {

/// Makes lines say what pixels show, no more and no less, for owners whose lines pixels draw.
///
/// Lines that are traced and linked are better than what pixels claim: they go on where lines meet, and leave out what
/// few pixels claim. For a drawing of what the pixels show that is to be undone. What of a line is not within `reach`
/// of where pixels show one is moved there, or cut out where there is none near; and the middles that pixels claim
/// strongly, but no line passes within `reach`, become lines of their own, as wide as those pixels show them.
struct ReconcilePolylinesJob {
    const PolylineSet* lines = nullptr;
    RidgeImage image{};
    float sign = 1.0f;                    ///< of the lines' curvature
    std::span<const LineLimits> limits{}; ///< by owner: lines of those that keep gaps are reconciled; none: all are
    float reach = 0.36f;                  ///< pixels
    float strong = 0.45f;                 ///< opacity from which on a claimed middle must be on a line

    PolylineSet reconciled{}; ///< out, kept from run to run: the lines in their order, or parts of them, then new ones

    /// Asserts that there are lines, and that numbers are in range.
    void validate() const;
    void run();

    /// Scratch, kept from run to run.
    ClaimedMiddles middles{};
    std::vector<LinePoint> samples{};
    std::vector<LinePoint> walk{};
    std::vector<std::uint8_t> on_line{}; ///< per claim

private:
    [[nodiscard]] bool applies(std::uint32_t owner) const { return limits.empty() || limits[owner].gaps; }
    void sample(const Polyline& line);
    [[nodiscard]] bool move_to_claims(LinePoint& point, std::uint32_t owner) const;
    [[nodiscard]] bool shown_between(const LinePoint& a, const LinePoint& b, std::uint32_t owner) const;
    void reconcile(const Polyline& line);
    void finish(const Polyline& from, std::uint32_t first, bool start_joined, bool end_joined);
    void mark_along(glm::vec2 a, glm::vec2 b, std::uint32_t owner);
    [[nodiscard]] float shown_width(const LinePoint& point, std::uint32_t owner) const;
    [[nodiscard]] LinePoint shown_at(const ClaimedMiddle& claim) const;
    [[nodiscard]] std::uint32_t next_claim(const ClaimedMiddle& from, glm::vec2 ahead) const;
    void walk_from(std::uint32_t claim, glm::vec2 ahead);
    void add_line_through(std::uint32_t claim);
};

} // namespace hachure::geometry
