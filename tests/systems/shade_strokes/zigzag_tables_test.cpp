#include <hachure/systems/shade_strokes/zigzag_tables.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace hachure {
namespace {

std::span<const glm::vec2> zigzag(const ZigzagTables& tables, std::size_t set) {
    return std::span(tables.point).subspan(set * ZigzagTables::points, ZigzagTables::points);
}

TEST(ZigzagTablesTest, BeginsAtNothingAndRisesToItsEnd) {
    const ZigzagTables tables = make_zigzag_tables();
    for (std::size_t set = 0; set < ZigzagTables::sets; ++set) {
        const auto points = zigzag(tables, set);
        EXPECT_EQ(points.front().x, 0.0f); // an inclusive sum would leave a gap there
        for (std::size_t i = 0; i < points.size(); ++i) {
            const float next = i + 1 < points.size() ? points[i + 1].x : 256.0f; // the end vertex is the next begin
            EXPECT_LT(points[i].x, next) << set << " " << i;
            EXPECT_LT(next - points[i].x, 2.5f) << set << " " << i;
        }
    }
}

/// Of n points that a level adds, each n-th part of [-1, 1] holds one: also among every 4th or 64th.
TEST(ZigzagTablesTest, SidesAreSpreadEvenlyAtEachLevel) {
    const ZigzagTables tables = make_zigzag_tables();
    for (std::size_t set = 0; set < ZigzagTables::sets; ++set)
        for (std::size_t stride = 2; stride <= 128; stride *= 2) {
            std::vector<float> sides;
            for (std::size_t i = stride / 2; i < ZigzagTables::points; i += stride)
                sides.push_back(zigzag(tables, set)[i].y);
            std::ranges::sort(sides);
            for (std::size_t i = 0; i < sides.size(); ++i) {
                const double part = (sides[i] + 1.0) / 2.0 * static_cast<double>(sides.size());
                EXPECT_EQ(static_cast<std::size_t>(part), i) << set << " stride " << stride;
            }
        }
}

/// As ink.glsl counts on: two uniform numbers in [-1, 1] are 2/3 apart.
TEST(ZigzagTablesTest, NeighboursAreAsFarApartAsRandomNumbers) {
    const ZigzagTables tables = make_zigzag_tables();
    for (std::size_t stride = 1; stride <= 16; stride *= 2) {
        double sum = 0.0, count = 0.0;
        for (std::size_t set = 0; set < ZigzagTables::sets; ++set)
            for (std::size_t i = 0; i < ZigzagTables::points; i += stride) {
                const auto points = zigzag(tables, set);
                sum += std::abs(points[(i + stride) % ZigzagTables::points].y - points[i].y);
                count += 1.0;
            }
        EXPECT_NEAR(sum / count, 2.0 / 3.0, 0.06) << stride;
    }
}

TEST(ZigzagTablesTest, ChainsStartInAllSetsAtAllPoints) {
    std::vector<int> sets(ZigzagTables::sets), points(ZigzagTables::points);
    for (std::uint32_t random = 0; random < 256 * 1280; ++random) {
        const ZigzagStart start = zigzag_start(random);
        ++sets.at(start.set);
        ++points.at(start.point);
    }
    EXPECT_EQ(std::ranges::count(sets, 256 * 256), 5);
    EXPECT_EQ(std::ranges::count(points, 1280), 256);
}

} // namespace
} // namespace hachure
