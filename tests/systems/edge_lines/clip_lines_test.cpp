#include <hachure/runtime/parallel.h>
#include <hachure/systems/edge_lines/clip_lines.h>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <random>
#include <vector>

// Lines clipped against a heap of triangles, where the clip space is the world: x and y from -1 to 1, z the window
// depth.
namespace hachure::test {
namespace {

using glm::dvec2;

constexpr std::uint32_t segments_per_line = 3;

struct Heap {
    explicit Heap(int triangles, std::uint32_t line_count) {
        view.width = 320;
        view.height = 240;
        SurfaceMesh mesh;
        for (int i = 0; i < triangles; ++i) {
            const glm::vec3 middle(number(-1, 1), number(-1, 1), number(0.2f, 0.8f));
            for (int corner = 0; corner < 3; ++corner)
                mesh.positions.push_back(middle +
                                         glm::vec3(number(-0.3f, 0.3f), number(-0.3f, 0.3f), number(-0.2f, 0.2f)));
        }
        for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) mesh.indices.push_back(i);
        SurfaceMaterial material;
        material.double_sided = true;
        mesh.submeshes = {{0, static_cast<std::uint32_t>(mesh.indices.size()), material}};
        corners = mesh.positions;
        DrawItem item;
        item.mesh = store.add(std::move(mesh));
        list.items.push_back(item);
        for (std::uint32_t i = 0; i < line_count; ++i) add_line(i * segments_per_line);
        occluders.begin(view);
        for (const PreciseEnds& e : ends) occluders.want(e.start, e.end);
        occluders.fill(list, store, view);
    }

    float number(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); }

    /// A polygon; along it arc goes from the number of each segment to the next.
    void add_line(std::uint32_t first) {
        glm::vec3 at(number(5, 315), number(5, 235), number(0, 1));
        for (std::uint32_t i = first; i < first + segments_per_line; ++i) {
            const glm::vec3 next(glm::clamp(at.x + number(-40, 40), 1.0f, 319.0f),
                                 glm::clamp(at.y + number(-40, 40), 1.0f, 239.0f), number(0, 1));
            segments.push_back({.start = at,
                                .end = next,
                                .depth = {at.z, next.z},
                                .half_width = {1, 1},
                                .weight = {1, 1},
                                .arc = {float(i), float(i + 1)},
                                .ends = {0, 0}});
            ends.push_back({dvec2(at), dvec2(next), {double(at.z), double(next.z)}});
            at = next;
        }
        lines.push_back({first, segments_per_line});
    }

    ClipLinesJob job(std::vector<LineSegment>& pieces) {
        const auto all = static_cast<std::uint32_t>(segments.size());
        ClipLinesJob job{.segments = segments, .ends = ends, .lines = lines};
        job.kinds[1] = {0, all / 2 / segments_per_line * segments_per_line};
        job.kinds[5] = {job.kinds[1].count, all - job.kinds[1].count};
        job.occluders = &occluders;
        job.viewport = {view.width, view.height};
        job.pieces = &pieces;
        return job;
    }

    /// How far triangles are before a point of a segment; negative where none is.
    double before(std::size_t segment, double t) const {
        const PreciseEnds& e = ends[segment];
        const dvec2 p = glm::mix(e.start, e.end, t);
        double nearest = -1.0;
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            std::array<dvec2, 3> c;
            for (std::size_t k = 0; k < 3; ++k)
                c[k] = {(0.5 + 0.5 * double(corners[i + k].x)) * view.width,
                        (0.5 + 0.5 * double(corners[i + k].y)) * view.height};
            const auto area = [](const dvec2& a, const dvec2& b, const dvec2& d) {
                return (b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x);
            };
            const double whole = area(c[0], c[1], c[2]);
            const glm::dvec3 shares = glm::dvec3(area(p, c[1], c[2]), area(c[0], p, c[2]), area(c[0], c[1], p)) / whole;
            if (shares.x < 0.0 || shares.y < 0.0 || shares.z < 0.0) continue;
            const double depth = shares.x * double(corners[i].z) + shares.y * double(corners[i + 1].z) +
                                 shares.z * double(corners[i + 2].z);
            nearest = std::max(nearest, depth - glm::mix(e.depth.x, e.depth.y, t));
        }
        return nearest;
    }

    std::mt19937 random{7};
    View view;
    MeshStore store;
    DrawList list;
    std::vector<glm::vec3> corners;
    std::vector<LineSegment> segments;
    std::vector<PreciseEnds> ends;
    std::vector<SegmentRange> lines;
    Occluders occluders;
};

/// Whether some piece of a range holds a place on the scale of arcs.
bool holds(const std::vector<LineSegment>& pieces, const std::array<SegmentRange, drawn_kinds>& ranges, double arc) {
    for (const SegmentRange& range : ranges)
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i)
            if (arc > double(pieces[i].arc.x) && arc < double(pieces[i].arc.y)) return true;
    return false;
}

TEST(ClipLinesTest, WhatIsSeenAndHiddenIsWhatTrianglesLeave) {
    Heap heap(60, 80);
    std::vector<LineSegment> pieces;
    ClipLinesJob job = heap.job(pieces);
    job.validate();
    job.run();
    int seen = 0, hidden = 0;
    for (std::size_t i = 0; i < heap.segments.size(); ++i)
        for (double t = 0.01; t < 1.0; t += 0.07) {
            // Not where it changes within a thousandth of the segment: arcs are floats.
            const double here = heap.before(i, t);
            if ((heap.before(i, t - 1e-3) > 0.0) != (here > 0.0) || (heap.before(i, t + 1e-3) > 0.0) != (here > 0.0))
                continue;
            const double arc = double(i) + t;
            ASSERT_EQ(holds(pieces, job.hidden, arc), here > 0.0) << "segment " << i << " at " << t;
            ASSERT_EQ(holds(pieces, job.seen, arc), here <= 0.0) << "segment " << i << " at " << t;
            (here > 0.0 ? hidden : seen) += 1;
        }
    EXPECT_GT(seen, 500);
    EXPECT_GT(hidden, 500);
}

TEST(ClipLinesTest, ThreadsChangeNothing) {
    Heap heap(300, 700);
    std::vector<LineSegment> expected;
    const int limit = thread_limit();
    set_thread_limit(1);
    ClipLinesJob alone = heap.job(expected);
    alone.run();
    ASSERT_GT(expected.size(), heap.segments.size());
    std::vector<LineSegment> pieces;
    ClipLinesJob job = heap.job(pieces);
    for (const int threads : {2, 3, 8, 1}) {
        set_thread_limit(threads);
        job.run();
        ASSERT_EQ(pieces.size(), expected.size()) << threads;
        EXPECT_EQ(std::memcmp(pieces.data(), expected.data(), pieces.size() * sizeof(LineSegment)), 0) << threads;
        EXPECT_EQ(std::memcmp(&job.seen, &alone.seen, sizeof job.seen), 0) << threads;
        EXPECT_EQ(std::memcmp(&job.hidden, &alone.hidden, sizeof job.hidden), 0) << threads;
    }
    set_thread_limit(limit);
}

/// Memory of the first run is all that the next ones need.
TEST(ClipLinesTest, ScratchStaysWhereItIs) {
    Heap heap(100, 200);
    std::vector<LineSegment> pieces;
    ClipLinesJob job = heap.job(pieces);
    job.run();
    const auto places = [&] {
        std::vector<const void*> all{pieces.data(), job.chunks.data(), job.hidden_pieces.data()};
        for (const ClipLinesJob::Chunk& chunk : job.chunks) {
            all.push_back(chunk.intervals.data());
            all.push_back(chunk.counts.data());
        }
        return all;
    };
    const std::vector<const void*> before = places();
    for (int i = 0; i < 3; ++i) job.run();
    EXPECT_EQ(places(), before);
}

} // namespace
} // namespace hachure::test
