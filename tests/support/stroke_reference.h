#pragma once

#include <hachure/components/shade_strokes.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/shade_strokes/shade_draw.h>
#include <hachure/systems/shade_strokes/zigzag_tables.h>
#include <hachure/tests/support/shade_rig.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace hachure::test {

/// Where the strokes of a segment begin and end, in double precision and as the papers have it, for a mesh at rest that
/// the world does not move: what shaders/shade_strokes is compared with.
class StrokeReference {
public:
    StrokeReference(const ShadeRig& rig, const View& view, const ShadeStrokes& style)
        : rig_(rig), view_(view), style_(style), tables_(make_zigzag_tables()), unit_(rig.mesh().size / 4096.0) {}

    /// Points of the polyline that its strokes are; nothing where chains with other zigzags were joined.
    [[nodiscard]] std::optional<std::vector<glm::dvec3>> points(const ShadeSegment& segment) const {
        const ShadeNode& from = node(segment.from);
        const ShadeNode& to = node(segment.to);
        const double length = double{to.along} - from.along;
        if (from.random != to.random || !counted(segment.from, segment.to)) return std::nullopt;
        if (partly_free(segment, segment.before) || partly_free(segment, segment.after)) return std::nullopt;
        const std::uint32_t before = node_before(segment), after = node_after(segment);
        if (!counted(before, segment.from) || !counted(segment.to, after)) return std::nullopt;
        const double value[2] = {log_value(before, segment.from, segment.to),
                                 log_value(segment.from, segment.to, after)};
        const ZigzagStart start = zigzag_start(from.random);
        const double begin = point(start.set, static_cast<int>(start.point)).x + from.along / unit_;
        const double end = begin + length / unit_;
        std::vector<double> places{begin};
        const int stride = 1 << static_cast<int>(std::ceil(std::min(value[0], value[1])));
        const int first = static_cast<int>(std::floor((begin - 256.0) / 128.0)) * 128; // of every level
        for (int i = first; point(start.set, i).x <= end; i += stride)
            if (point(start.set, i).x > begin) places.push_back(point(start.set, i).x);
        places.push_back(end);
        std::vector<glm::dvec3> result;
        for (const double place : places) {
            const double v = (place - begin) / (end - begin);
            const double log_value = glm::mix(value[0], value[1], v);
            const auto curve = [&](double stride) { // on straight lines between its points
                double low = begin, high = end;
                glm::dvec2 at_low(0.0), at_high(0.0);
                for (int i = first; point(start.set, i).x < end; i += static_cast<int>(stride)) {
                    const glm::dvec2 p = point(start.set, i);
                    if (p.x <= begin) continue;
                    const glm::dvec2 off =
                        bend(segment, (p.x - begin) / (end - begin)) * glm::dvec2(1.0, 1.0 - p.y * p.y);
                    if (p.x <= place) {
                        low = p.x;
                        at_low = off;
                    } else {
                        high = p.x;
                        at_high = off;
                        break;
                    }
                }
                return high > low ? glm::mix(at_low, at_high, (place - low) / (high - low)) : at_low;
            };
            const double level = std::exp2(std::ceil(log_value)), t = 2.0 * (level - std::exp2(log_value)) / level;
            const glm::dvec2 off = glm::mix(curve(2.0 * level), curve(level), t);
            result.push_back(straight(segment, side(start.set, place, log_value) + off.y, v + off.x));
        }
        return result;
    }

private:
    [[nodiscard]] const ShadeNode& node(std::uint32_t n) const { return rig_.chains().nodes[n]; }
    [[nodiscard]] bool counted(std::uint32_t a, std::uint32_t b) const {
        const double chord = glm::distance(rig_.at(a), rig_.at(b)), along = double{node(b).along} - node(a).along;
        return a == b || (node(a).random == node(b).random && along > 0.3 * chord && along < 3.0 * chord);
    }

    /// Numbered on over the ends of the table.
    [[nodiscard]] glm::dvec2 point(std::uint32_t set, int i) const {
        const int turn = static_cast<int>(std::floor(i / 256.0));
        return glm::dvec2(tables_.point[set * 256 + static_cast<std::uint32_t>(i - 256 * turn)]) +
               glm::dvec2(256.0 * turn, 0.0);
    }

    /// On straight lines through every `stride`-th point.
    [[nodiscard]] double side_of_level(std::uint32_t set, double place, int stride) const {
        int i = static_cast<int>(std::floor((place - 64.0) / stride)) * stride - 2 * stride;
        while (point(set, i + stride).x <= place) i += stride;
        const glm::dvec2 a = point(set, i), b = point(set, i + stride);
        return glm::mix(a.y, b.y, (place - a.x) / (b.x - a.x));
    }

    /// t = 2 (Level - Value) / Level of the way from straight lines of the coarser level (readings.md).
    [[nodiscard]] double side(std::uint32_t set, double place, double log_value) const {
        const double value = std::exp2(log_value), level = std::exp2(std::ceil(log_value));
        const double t = 2.0 * (level - value) / level;
        const int stride = static_cast<int>(level);
        return (1.0 - t) * side_of_level(set, place, 2 * stride) + t * side_of_level(set, place, stride);
    }

    [[nodiscard]] glm::dvec2 pixel(const glm::dvec3& world) const {
        const glm::dvec4 clip = glm::dmat4(view_.clip_from_world) * glm::dvec4(world, 1.0);
        return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(view_.width, view_.height);
    }

    /// Strokes are as far apart as lines of the pen's width need to cover what little shade asks for.
    [[nodiscard]] double log_value(std::uint32_t left, std::uint32_t n, std::uint32_t right) const {
        const double length = double{node(right).along} - node(left).along;
        const glm::dvec2 along = (pixel(rig_.at(right)) - pixel(rig_.at(left))) * (unit_ / length);
        const glm::dvec2 across = 0.5 * (pixel(rig_.at(n, 4)) - pixel(rig_.at(n, 0)));
        const double apart = std::abs(across.x * along.y - across.y * along.x) / glm::length(across);
        const double wanted = style_.line_width / (3.0 * style_.density * full_darkness);
        return std::clamp(std::log2(wanted / (2.0 * apart)), -0.999, 6.0);
    }

    [[nodiscard]] std::array<double, 5> sides(std::uint32_t n) const {
        return {-1.0, node(n).bend[0], 0.0, node(n).bend[1], 1.0};
    }

    /// On straight lines between the two ribs' points.
    [[nodiscard]] glm::dvec3 straight(const ShadeSegment& segment, double side, double v) const {
        const auto line = [&](std::size_t k) { return std::lerp(sides(segment.from)[k], sides(segment.to)[k], v); };
        const auto at = [&](std::size_t k) { return glm::mix(rig_.at(segment.from, k), rig_.at(segment.to, k), v); };
        std::size_t k = 0;
        while (k < 3 && side > line(k + 1)) ++k;
        return glm::mix(at(k), at(k + 1), (side - line(k)) / (line(k + 1) - line(k)));
    }

    /// By how much Hermite's cubic for the chain's middle leaves the straight line, along it and across, as part of the
    /// segment: within the patch; what is normal to it is left out.
    [[nodiscard]] glm::dvec2 bend(const ShadeSegment& segment, double v) const {
        const glm::dvec3 chord = rig_.at(segment.to) - rig_.at(segment.from);
        const glm::dvec3 across = 0.25 * (rig_.at(segment.from, 4) - rig_.at(segment.from, 0) + rig_.at(segment.to, 4) -
                                          rig_.at(segment.to, 0));
        const double length = double{node(segment.to).along} - node(segment.from).along;
        const auto off = [&](const glm::dvec3& slope) {
            const glm::dvec3 normal = glm::cross(chord, across);
            const glm::dvec3 by = glm::inverse(glm::dmat3(chord, across, normal)) * (slope * length - chord);
            return glm::clamp(glm::dvec2(by), glm::dvec2(-0.75, -1.8), glm::dvec2(0.75, 1.8));
        };
        glm::dvec2 result(0.0);
        const std::uint32_t before = node_before(segment), after = node_after(segment);
        if (before != segment.from)
            result += v * (1.0 - v) * (1.0 - v) * off(tangent(before, segment.from, segment.to));
        if (after != segment.to) result -= v * v * (1.0 - v) * off(tangent(segment.from, segment.to, after));
        return result;
    }

    /// Whether a segment beside another one is so much fainter that the chain ends there in part.
    [[nodiscard]] bool partly_free(const ShadeSegment& segment, std::uint32_t beside) const {
        return beside != no_slot && rig_.chains().segments[beside].alpha < 0.5f * segment.alpha;
    }

    [[nodiscard]] std::uint32_t node_before(const ShadeSegment& segment) const {
        return segment.before != no_slot ? rig_.chains().segments[segment.before].from : segment.from;
    }
    [[nodiscard]] std::uint32_t node_after(const ShadeSegment& segment) const {
        return segment.after != no_slot ? rig_.chains().segments[segment.after].to : segment.to;
    }

    /// Of the parabola through three nodes.
    [[nodiscard]] glm::dvec3 tangent(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const double before = double{node(b).along} - node(a).along, after = double{node(c).along} - node(b).along;
        const double t = before / (before + after);
        if (before <= 0.0) return (rig_.at(c) - rig_.at(b)) / after;
        return (1.0 - t) * (rig_.at(b) - rig_.at(a)) / before + t * (rig_.at(c) - rig_.at(b)) / after;
    }

    const ShadeRig& rig_;
    const View& view_;
    const ShadeStrokes& style_;
    ZigzagTables tables_;
    double unit_;
};

} // namespace hachure::test
