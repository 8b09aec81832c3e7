#include <hachure/runtime/assets/svg_path.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace hachure::assets {
namespace {

/// Where two pieces meet, the outline goes no farther out than this times half the width: sharp bends stay bends.
constexpr float longest_miter = 1.5f;

/// A round end smaller than this is a point, pixels.
constexpr float smallest_cap = 0.02f;

void append(std::string& path, char command, glm::vec2 p) {
    fmt::format_to(std::back_inserter(path), "{}{:.2f} {:.2f}", command, p.x, p.y);
}

void append_cap(std::string& path, float radius, glm::vec2 to) {
    if (radius < smallest_cap)
        append(path, 'L', to);
    else
        fmt::format_to(std::back_inserter(path), "A{0:.2f} {0:.2f} 0 0 1 {1:.2f} {2:.2f}", radius, to.x, to.y);
}

glm::vec2 direction(std::span<const SvgPoint> points, std::size_t piece) {
    const glm::vec2 step = points[piece + 1].place - points[piece].place;
    const float length = glm::length(step);
    return length > 0.0f ? step / length : glm::vec2(1.0f, 0.0f);
}

/// From a point of the line to its outline on the left of those who look along it with y down.
glm::vec2 side_of(std::span<const SvgPoint> points, std::size_t i) {
    const glm::vec2 before = direction(points, i > 0 ? i - 1 : 0);
    const glm::vec2 after = direction(points, std::min(i, points.size() - 2));
    const glm::vec2 sum = before + after;
    const float length = glm::length(sum);
    const glm::vec2 along = length > 1e-3f ? sum / length : after;
    const float cosine = std::max(glm::dot(along, after), 1.0f / longest_miter);
    return 0.5f * points[i].width / cosine * glm::vec2(along.y, -along.x);
}

} // namespace

std::string svg_path(std::span<const SvgPoint> points, bool closed) {
    std::string path;
    const std::size_t count = points.size() - (closed ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) append(path, i == 0 ? 'M' : 'L', points[i].place);
    if (closed) path += 'Z';
    return path;
}

std::string svg_outline(std::span<const SvgPoint> points, bool round_start, bool round_end) {
    std::string path;
    for (std::size_t i = 0; i < points.size(); ++i)
        append(path, i == 0 ? 'M' : 'L', points[i].place + side_of(points, i));
    for (std::size_t i = points.size(); i-- > 0;) {
        const glm::vec2 to = points[i].place - side_of(points, i);
        if (i + 1 == points.size() && round_end)
            append_cap(path, 0.5f * points[i].width, to);
        else
            append(path, 'L', to);
    }
    if (round_start) append_cap(path, 0.5f * points[0].width, points[0].place + side_of(points, 0));
    path += 'Z';
    return path;
}

} // namespace hachure::assets
