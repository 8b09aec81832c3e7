#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/trace_ridges.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace hachure::geometry {
namespace {

constexpr std::uint32_t no_ridge = std::numeric_limits<std::uint32_t>::max();

/// Of neighbours that see one line: their tangents are not farther apart than 50 degrees, which leaves room for bends
/// as tight as a pixel and a half.
constexpr float least_cosine = 0.64f;

/// From one pixel to the next a line comes nearer by what lies between them. Beside the edge of a tone pixels don't
/// agree on where the line is, and it may come nearer by this much more, pixels: what they agree on is which side of
/// them it is on. Between two lines the nearest one changes, and what was ahead is behind: nearer by less than this
/// much less, no line passes there.
constexpr float most_more = 1.5f, most_less = 0.5f;

/// How far from a line, pixels, a pixel may be to stand for it alone.
constexpr float alone_reach = 0.75f;

/// One of both normals of a line, the same one for all that run about that way. What angle the choice flips at is
/// of no matter as long as no line of a drawing is likely to run just there.
glm::vec2 normal_of(glm::vec2 tangent) {
    const glm::vec2 normal(-tangent.y, tangent.x);
    return glm::dot(normal, glm::vec2(0.7648f, 0.6442f)) < 0.0f ? -normal : normal;
}

} // namespace

void TraceRidgesJob::validate() const {
    HACHURE_ASSERT(image.width >= 0 && image.height >= 0, "a picture");
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    HACHURE_ASSERT(image.points.size() == pixels && image.directions.size() == pixels && image.owners.size() == pixels,
                   "one of each per pixel");
    HACHURE_ASSERT(pixels < no_ridge / 8, "nodes have 32-bit indices");
}

bool TraceRidgesJob::holds_line(std::size_t pixel) const {
    const glm::vec4& point = image.points[pixel];
    return image.owners[pixel] != 0 && point.w > 0.0f && point.z * sign > 0.0f; // false for what is not a number
}

/// The node between two pixels that the line passes through there, if any.
std::uint32_t TraceRidgesJob::cross(std::size_t pixel, std::size_t neighbour, glm::vec2 at, glm::vec2 step) {
    if (image.owners[pixel] != image.owners[neighbour]) return no_ridge;
    const glm::vec2 tangent_a(image.directions[pixel]);
    glm::vec2 tangent_b(image.directions[neighbour]);
    const float cosine = glm::dot(tangent_a, tangent_b);
    if (!(std::abs(cosine) >= least_cosine)) return no_ridge;
    if (cosine < 0.0f) tangent_b = -tangent_b;
    const glm::vec2 tangent = glm::normalize(tangent_a + tangent_b);
    const glm::vec2 normal = normal_of(tangent);
    const float a = glm::dot(glm::vec2(image.points[pixel]), normal);
    const float b = glm::dot(glm::vec2(image.points[neighbour]), normal);
    if ((a < 0.0f) == (b < 0.0f)) return no_ridge;
    const float between = glm::dot(step, normal);
    const float nearer = between < 0.0f ? b - a + between : a - b - between;
    if (!(nearer >= -most_less && nearer <= most_more)) return no_ridge;
    const float t = a / (a - b);
    RidgeNode node{{}, tangent, image.owners[pixel]};
    node.point.place = at + t * step;
    node.point.width = glm::mix(image.directions[pixel].z, image.directions[neighbour].z, t);
    node.point.opacity = glm::mix(image.points[pixel].w, image.points[neighbour].w, t);
    nodes.push_back(node);
    return static_cast<std::uint32_t>(nodes.size() - 1);
}

/// The same where the neighbour sees no line: the pixel speaks for both. Of a line along an outline one half is hidden
/// by what lies before it, and its middle may be just beyond the last pixel that sees it.
std::uint32_t TraceRidgesJob::cross_alone(std::size_t pixel, glm::vec2 at, glm::vec2 step) {
    const glm::vec2 tangent(image.directions[pixel]);
    if (!(glm::dot(tangent, tangent) > 0.5f)) return no_ridge;
    const glm::vec2 normal = normal_of(glm::normalize(tangent));
    const float a = glm::dot(glm::vec2(image.points[pixel]), normal), b = a - glm::dot(step, normal);
    if ((a < 0.0f) == (b < 0.0f)) return no_ridge;
    nodes.push_back({{at + a / (a - b) * step, image.directions[pixel].z, image.points[pixel].w},
                     glm::normalize(tangent),
                     image.owners[pixel]});
    return static_cast<std::uint32_t>(nodes.size() - 1);
}

/// The node between two neighbours, whichever of them see a line.
std::uint32_t TraceRidgesJob::cross_link(std::size_t pixel, std::size_t neighbour, glm::vec2 at, glm::vec2 step) {
    const bool here = holds_line(pixel), there = holds_line(neighbour);
    if (here && there) return cross(pixel, neighbour, at, step);
    if (here) return cross_alone(pixel, at, step);
    return there ? cross_alone(neighbour, at + step, -step) : no_ridge;
}

void TraceRidgesJob::cross_right(int y, std::vector<std::uint32_t>& row) {
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t first = static_cast<std::size_t>(y) * width;
    row.assign(width, no_ridge);
    for (std::size_t x = 0; x + 1 < width; ++x)
        row[x] = cross_link(first + x, first + x + 1, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f},
                            {1.0f, 0.0f});
}

void TraceRidgesJob::cross_above(int y, std::vector<std::uint32_t>& row) {
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t first = static_cast<std::size_t>(y) * width;
    row.assign(width, no_ridge);
    if (y + 1 >= image.height) return;
    for (std::size_t x = 0; x < width; ++x)
        row[x] = cross_link(first + x, first + width + x, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f},
                            {0.0f, 1.0f});
}

/// The nodes around the cell whose lower left pixel is at `x` of the row: two are the ends of a piece; more meet in a
/// new node amid them.
void TraceRidgesJob::join_cell(std::size_t x) {
    std::array<std::uint32_t, 4> found{};
    std::size_t count = 0;
    for (const std::uint32_t node : {right[0][x], above[0][x + 1], right[1][x], above[0][x]})
        if (node != no_ridge) found[count++] = node;
    for (std::size_t i = 1; i < count; ++i)
        if (nodes[found[i]].owner != nodes[found[0]].owner) return;
    if (count == 2) segments.push_back({found[0], found[1]});
    if (count < 3) return;
    RidgeNode meeting{{}, {}, nodes[found[0]].owner};
    for (std::size_t i = 0; i < count; ++i) {
        const LinePoint& point = nodes[found[i]].point;
        meeting.point.place += point.place / static_cast<float>(count);
        meeting.point.width += point.width / static_cast<float>(count);
        meeting.point.opacity += point.opacity / static_cast<float>(count);
        segments.push_back({found[i], nodes.size()});
    }
    nodes.push_back(meeting);
}

/// Pixels of a row that see a line, while no_ridge of their neighbours sees it from its other side.
void TraceRidgesJob::add_lone_pixels(int y) {
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t x = 0; x < width; ++x) {
        const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
        if (!holds_line(pixel)) continue;
        const glm::vec2 offset(image.points[pixel]), tangent(image.directions[pixel]);
        if (!(glm::length(offset) <= alone_reach)) continue;
        if (right[0][x] != no_ridge || (x > 0 && right[0][x - 1] != no_ridge)) continue;
        if (above[0][x] != no_ridge || above[1][x] != no_ridge) continue;
        if (!(glm::dot(tangent, tangent) > 0.5f)) continue;
        const glm::vec2 middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        nodes.push_back({{middle + offset, image.directions[pixel].z, image.points[pixel].w},
                         glm::normalize(tangent),
                         image.owners[pixel]});
    }
}

void TraceRidgesJob::run() {
    nodes.clear();
    segments.clear();
    if (image.width < 2 || image.height < 2) return;
    const auto width = static_cast<std::size_t>(image.width);
    cross_right(0, right[0]);
    above[1].assign(width, no_ridge);
    for (int y = 0; y < image.height; ++y) {
        cross_above(y, above[0]);
        add_lone_pixels(y);
        if (y + 1 == image.height) return;
        cross_right(y + 1, right[1]);
        for (std::size_t x = 0; x + 1 < width; ++x) join_cell(x);
        std::swap(right[0], right[1]);
        std::swap(above[0], above[1]);
    }
}

} // namespace hachure::geometry
