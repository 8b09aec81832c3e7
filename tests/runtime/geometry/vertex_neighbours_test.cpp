#include <hachure/runtime/geometry/shapes.h>
#include <hachure/runtime/geometry/vertex_neighbours.h>
#include <hachure/runtime/geometry/vertex_rings.h>
#include <hachure/runtime/geometry/weld.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace hachure::geometry {
namespace {

/// The same by sets.
std::vector<std::set<std::uint32_t>> plain_neighbours(std::span<const std::uint32_t> indices,
                                                      std::span<const std::uint32_t> weld) {
    std::vector<std::set<std::uint32_t>> result(weld.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
        for (std::size_t k = i - i % 3; k < i - i % 3 + 3; ++k)
            if (weld[indices[i]] != weld[indices[k]]) result[weld[indices[i]]].insert(weld[indices[k]]);
    return result;
}

void expect_same(const VertexNeighbours& neighbours, std::span<const std::uint32_t> indices,
                 std::span<const std::uint32_t> weld) {
    const auto plain = plain_neighbours(indices, weld);
    ASSERT_EQ(neighbours.first.size(), weld.size() + 1);
    for (std::uint32_t v = 0; v < weld.size(); ++v) {
        const std::span<const std::uint32_t> found = neighbours.of(v);
        ASSERT_EQ(std::vector<std::uint32_t>(found.begin(), found.end()),
                  std::vector<std::uint32_t>(plain[v].begin(), plain[v].end()))
            << v;
    }
}

TEST(VertexNeighbours, AreThoseThatTrianglesJoin) {
    VertexNeighbours neighbours;
    for (const Shape& shape : {torus(1.0, 0.4, 30, 12), icosphere(1.0, 3), cube(1.0), cone(1.0, 1.0, 40)}) {
        const std::vector<std::uint32_t> weld = weld_positions(shape.positions);
        neighbours.build(shape.indices, weld);
        expect_same(neighbours, shape.indices, weld);
    }
    const std::vector<std::uint32_t> weld{0, 1, 2, 3, 1, 5};
    const std::vector<std::uint32_t> broken{0, 1, 2, 0, 1, 2, 2, 1, 0, 3, 3, 0, 1, 4, 2};
    neighbours.build(broken, weld);
    expect_same(neighbours, broken, weld);
    EXPECT_TRUE(neighbours.of(5).empty());
    neighbours.build({}, {});
    EXPECT_EQ(neighbours.first.size(), 1u);
}

TEST(VertexRings, HoldWhatSoManyEdgesLeadTo) {
    const Shape ball = icosphere(1.0, 4);
    const std::vector<std::uint32_t> weld = weld_positions(ball.positions);
    VertexNeighbours neighbours;
    neighbours.build(ball.indices, weld);
    VertexRings rings;
    rings.resize(ball.positions.size());
    for (const std::uint32_t start : {0u, 100u, 0u}) {
        std::set<std::uint32_t> reached{start}, edge{start};
        rings.start(start);
        for (int step = 0; step < 6; ++step) {
            std::set<std::uint32_t> beyond;
            for (const std::uint32_t v : edge)
                for (const std::uint32_t other : neighbours.of(v))
                    if (reached.insert(other).second) beyond.insert(other);
            edge = beyond;
            EXPECT_TRUE(rings.grow(neighbours));
            const auto last = rings.last_ring();
            EXPECT_EQ(std::set<std::uint32_t>(last.begin(), last.end()), edge);
            EXPECT_EQ(rings.vertices().size(), reached.size());
            if (step == 0) {
                EXPECT_EQ(rings.first_ring().size(), last.size());
            }
        }
    }
}

} // namespace
} // namespace hachure::geometry
