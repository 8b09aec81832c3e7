#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/simplify_polylines.h>
#include <hachure/runtime/geometry/straight_piece.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hachure::geometry {

void SimplifyPolylinesJob::validate() const {
    HACHURE_ASSERT(lines != nullptr, "lines to simplify");
    HACHURE_ASSERT(tolerance > 0.0f && width_tolerance > 0.0f && opacity_tolerance > 0.0f, "tolerances above 0");
}

/// How much a point differs from the straight piece between two others, 1 for what is just tolerated.
float SimplifyPolylinesJob::deviation(std::uint32_t point, std::uint32_t first, std::uint32_t last) const {
    const LinePoint &a = lines->points[first], &b = lines->points[last], &p = lines->points[point];
    const float t = nearest_part(a.place, b.place, p.place);
    return std::max({glm::distance(p.place, glm::mix(a.place, b.place, t)) / tolerance,
                     std::abs(p.width - glm::mix(a.width, b.width, t)) / width_tolerance,
                     std::abs(p.opacity - glm::mix(a.opacity, b.opacity, t)) / opacity_tolerance});
}

std::uint32_t SimplifyPolylinesJob::farthest_from(std::uint32_t point, std::uint32_t last) const {
    std::uint32_t farthest = point;
    float most = 0.0f;
    for (std::uint32_t i = point + 1; i < last; ++i) {
        const float distance = glm::distance(lines->points[point].place, lines->points[i].place);
        if (distance > most) farthest = i;
        most = std::max(most, distance);
    }
    return farthest;
}

void SimplifyPolylinesJob::keep_points(std::uint32_t first, std::uint32_t last) {
    stretches.assign(1, {first, last});
    while (!stretches.empty()) {
        const auto [begin, end] = stretches.back();
        stretches.pop_back();
        kept[begin] = kept[end] = 1;
        std::uint32_t worst = begin;
        float most = 1.0f;
        for (std::uint32_t i = begin + 1; i < end; ++i) {
            const float d = deviation(i, begin, end);
            if (d > most) worst = i;
            most = std::max(most, d);
        }
        if (worst == begin) continue;
        stretches.emplace_back(worst, end);
        stretches.emplace_back(begin, worst);
    }
}

void SimplifyPolylinesJob::simplify(const Polyline& line) {
    const std::uint32_t last = line.first + line.count - 1;
    const std::uint32_t middle = line.closed ? farthest_from(line.first, last) : line.first;
    if (middle != line.first) {
        keep_points(line.first, middle);
        keep_points(middle, last);
    } else {
        keep_points(line.first, last);
    }
    Polyline result = line;
    result.first = static_cast<std::uint32_t>(simplified.points.size());
    result.length = 0.0f;
    for (std::uint32_t i = line.first; i <= last; ++i) {
        if (!kept[i]) continue;
        if (i > line.first) result.length += glm::distance(simplified.points.back().place, lines->points[i].place);
        simplified.points.push_back(lines->points[i]);
    }
    result.count = static_cast<std::uint32_t>(simplified.points.size()) - result.first;
    simplified.lines.push_back(result);
}

void SimplifyPolylinesJob::run() {
    simplified.clear();
    kept.assign(lines->points.size(), 0);
    for (const Polyline& line : lines->lines) simplify(line);
}

} // namespace hachure::geometry
