#include <hachure/tests/benchmarks/bench_report.h>
#include <hachure/tests/benchmarks/edge_lines_case.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hachure::bench {

using geometry::no_face;

SilhouetteCase::SilhouetteCase(std::vector<glm::vec3> p, std::vector<std::uint32_t> i)
    : positions(std::move(p)), indices(std::move(i)), bounds(geometry::bounds_of(positions)),
      table(geometry::build_edge_table(positions, indices)), planes(indices.size() / 3), front(planes.size()),
      plain(table.edges.size()), chosen(table.edges.size()) {
    geometry::face_planes(positions, indices, planes);
    const double start = now_ms();
    tree = geometry::edge_tree(table.edges, planes);
    build_ms = now_ms() - start;
    loop = {.edges = table.edges,
            .planes = planes,
            .features = {},
            .wanted = geometry::line_silhouette,
            .front = front,
            .chosen = chosen};
    by_tree = {
        .edges = table.edges, .planes = planes, .features = {}, .tree = &tree, .wanted = geometry::line_silhouette};
}

glm::vec4 SilhouetteCase::eye(int frame) const {
    const double angle = frame * std::numbers::pi / 180.0;
    const glm::vec3 direction(0.9 * std::cos(angle), 0.436, 0.9 * std::sin(angle));
    return {bounds.center() + 2.5f * bounds.radius() * direction, 1.0f};
}

[[gnu::noinline]] void SilhouetteCase::plain_faces(const glm::vec4& eye) {
    for (std::size_t face = 0; face < planes.size(); ++face) front[face] = glm::dot(planes[face], eye) > 0.0f;
}

[[gnu::noinline]] void SilhouetteCase::plain_loop(const glm::vec4& eye) {
    plain_faces(eye);
    plain_count = 0;
    for (std::size_t i = 0; i < table.edges.size(); ++i) {
        const geometry::Edge& edge = table.edges[i];
        const bool other = edge.face1 != no_face &&
                           (front[edge.face1] != 0) != ((edge.flags & geometry::edge_orientation_mismatch) != 0);
        plain[plain_count] = static_cast<std::uint32_t>(i);
        plain_count += edge.face1 != no_face && (front[edge.face0] != 0) != other ? 1 : 0;
    }
}

bool SilhouetteCase::agree() const {
    return std::ranges::equal(by_tree.chosen, std::span(plain).first(plain_count), {}, &geometry::ChosenEdge::edge);
}

std::vector<double> frame_ms(const std::vector<std::function<void(int)>>& jobs, int frames, int rounds) {
    const auto count = static_cast<std::size_t>(frames);
    std::vector<double> best(jobs.size() * count, std::numeric_limits<double>::max());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t frame = 0; frame < count; ++frame)
            for (std::size_t job = 0; job < jobs.size(); ++job) {
                const double start = now_ms();
                jobs[job](static_cast<int>(frame));
                double& ms = best[job * count + frame];
                ms = std::min(ms, now_ms() - start);
            }
    std::vector<double> result;
    for (std::size_t job = 0; job < jobs.size(); ++job) {
        double sum = 0.0;
        for (std::size_t frame = 0; frame < count; ++frame) sum += best[job * count + frame];
        result.push_back(sum / static_cast<double>(count));
    }
    return result;
}

} // namespace hachure::bench
