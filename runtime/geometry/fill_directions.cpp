#include <hachure/runtime/assert.h>
#include <hachure/runtime/geometry/direction_field.h>
#include <hachure/runtime/geometry/fill_directions.h>
#include <hachure/runtime/geometry/triangle_frame.h>
#include <hachure/runtime/parallel.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hachure::geometry {
namespace {

using Line = FillDirectionsJob::Line;

constexpr float sure_enough = 0.5f;      // to begin from
constexpr float held = 0.95f;            // from here on a direction is not touched
constexpr float default_weight = 1e-3f;  // of the default, beside one neighbour
constexpr std::size_t line_block = 2048; // vertices that one task works on

Line unit_line_or(const Line& line, const Line& otherwise) {
    const float size = std::abs(line);
    return size > 1e-6f ? line / size : otherwise;
}

/// The line of a tangent vector.
Line line_of(const glm::dvec3& direction, const Frame& frame) {
    const std::complex<double> z(glm::dot(direction, frame.u), glm::dot(direction, frame.v));
    const double square = std::norm(z);
    return square > 0.0 ? Line(z * z / square) : Line(0.0f);
}

/// How much a direction counts against those around it.
float own_weight(float confidence) { return std::min(1.0f, confidence / held); }

template <class Body> void each_in_blocks(std::size_t count, const Body& body) {
    parallel_for((count + line_block - 1) / line_block, [&](std::size_t block) {
        for (std::size_t i = block * line_block; i < std::min(count, (block + 1) * line_block); ++i) body(i);
    });
}

} // namespace

void FillDirectionsJob::validate() const {
    const std::size_t count = normals.size();
    HACHURE_ASSERT(neighbours && neighbours->first.size() == count + 1, "neighbours are of this mesh");
    for (const std::size_t size : {weld.size(), directions.size(), confidences.size(), filled.size()})
        HACHURE_ASSERT(size == count, "one element per vertex");
}

void FillDirectionsJob::run() {
    const std::size_t count = normals.size();
    for (std::vector<Line>* values : {&wanted, &otherwise, &lines, &next}) values->resize(count);
    turns.resize(neighbours->neighbour.size());
    each_in_blocks(count, [&](std::size_t v) {
        if (weld[v] == v) read_vertex(static_cast<std::uint32_t>(v));
    });
    open.clear();
    for (std::uint32_t v = 0; v < count; ++v)
        if (weld[v] == v && own_weight(confidences[v]) < 1.0f) open.push_back(v);
    reach_open_parts();
    relax();
    each_in_blocks(count, [&](std::size_t v) {
        const std::uint32_t place = weld[v];
        const Frame frame = frame_of(glm::dvec3(normals[place]));
        const double angle = 0.5 * double{std::arg(unit_line_or(lines[place], otherwise[place]))};
        filled[v] = glm::vec3(std::cos(angle) * frame.u + std::sin(angle) * frame.v);
    });
}

void FillDirectionsJob::read_vertex(std::uint32_t vertex) {
    const Frame frame = frame_of(glm::dvec3(normals[vertex]));
    wanted[vertex] = line_of(glm::dvec3(directions[vertex]), frame);
    otherwise[vertex] = unit_line_or(Line(default_line(frame.u, frame.v)), Line(1.0f));
    if (own_weight(confidences[vertex]) >= 1.0f) return;
    for (std::uint32_t k = neighbours->first[vertex]; k < neighbours->first[vertex + 1]; ++k)
        turns[k] = turn(neighbours->neighbour[k], vertex);
}

/// What a line in the frame of a vertex is multiplied with to be one in that of another, carried there without a twist.
Line FillDirectionsJob::turn(std::uint32_t from, std::uint32_t to) const {
    const glm::dvec3 from_normal(normals[from]), to_normal(normals[to]);
    return line_of(turned(frame_of(from_normal), from_normal, to_normal).u, frame_of(to_normal));
}

/// The sum of the lines around a vertex, in its frame.
Line FillDirectionsJob::around(std::uint32_t vertex) const {
    Line sum(0.0f);
    for (std::uint32_t k = neighbours->first[vertex]; k < neighbours->first[vertex + 1]; ++k)
        sum += turns[k] * lines[neighbours->neighbour[k]];
    return sum;
}

/// A first guess, edge by edge from where directions are sure into the parts without any, however large they are.
void FillDirectionsJob::reach_open_parts() {
    reached.assign(lines.size(), 0);
    std::ranges::fill(lines, Line(0.0f));
    front.clear();
    for (std::uint32_t v = 0; v < lines.size(); ++v) {
        if (weld[v] != v || confidences[v] < sure_enough) continue;
        reached[v] = 1;
        lines[v] = wanted[v];
        front.push_back(v);
    }
    while (!front.empty()) {
        beyond.clear();
        for (const std::uint32_t v : front)
            for (const std::uint32_t other : neighbours->of(v))
                if (!reached[other]) {
                    reached[other] = 1;
                    beyond.push_back(other);
                }
        // All of them before any is written: none follows another of the same step.
        for (const std::uint32_t v : beyond) next[v] = unit_line_or(around(v), otherwise[v]);
        for (const std::uint32_t v : beyond) lines[v] = next[v];
        front.swap(beyond);
    }
    for (const std::uint32_t v : open)
        if (!reached[v]) lines[v] = otherwise[v];
}

/// Jacobi's method: each line is the mean of what its vertex wants and of those around it, by confidence.
void FillDirectionsJob::relax() {
    for (std::uint32_t sweep = 0; sweep < sweeps; ++sweep) {
        each_in_blocks(open.size(), [&](std::size_t i) {
            const std::uint32_t v = open[i];
            const auto count = static_cast<float>(neighbours->of(v).size());
            const Line mean = (around(v) + default_weight * otherwise[v]) / (count + default_weight);
            const float own = own_weight(confidences[v]);
            next[v] = own * wanted[v] + (1.0f - own) * mean;
        });
        each_in_blocks(open.size(), [&](std::size_t i) { lines[open[i]] = next[open[i]]; });
    }
}

} // namespace hachure::geometry
