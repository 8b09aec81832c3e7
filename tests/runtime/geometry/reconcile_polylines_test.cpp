#include <hachure/runtime/geometry/reconcile_polylines.h>
#include <hachure/tests/runtime/geometry/ridge_fields.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace hachure::geometry {
namespace {

/// Pixels of 40 x 20 that see level lines, each `width` wide.
RidgeField level_lines(std::vector<double> heights, double width) {
    RidgeField field(40, 20);
    for (int y = 0; y < field.height; ++y)
        for (int x = 4; x < 36; ++x)
            for (const double height : heights)
                if (std::abs(height - y - 0.5) <= 0.5 * width)
                    field.set(x, y, {0.0, height - y - 0.5}, 1.0, 0.9, {1.0, 0.0}, width);
    return field;
}

PolylineSet through(const std::vector<glm::vec2>& places, float width = 4.0f) {
    PolylineSet set;
    for (const glm::vec2 place : places) set.points.push_back({place, width, 0.9f});
    set.lines.push_back({.first = 0, .count = static_cast<std::uint32_t>(places.size()), .owner = 1});
    for (std::size_t i = 1; i < places.size(); ++i) set.lines[0].length += glm::distance(places[i - 1], places[i]);
    return set;
}

struct Reconciled {
    std::vector<LineLimits> limits{{}, {.gaps = true}};
    ReconcilePolylinesJob job;

    Reconciled(const RidgeField& field, const PolylineSet& lines, bool gaps = true) {
        limits[1].gaps = gaps;
        job.lines = &lines;
        job.image = field.image();
        job.limits = limits;
        job.validate();
        job.run();
    }
    Reconciled(const Reconciled&) = delete;
    Reconciled& operator=(const Reconciled&) = delete;

    [[nodiscard]] const PolylineSet& set() const { return job.reconciled; }
    [[nodiscard]] double lowest(const Polyline& line, int axis) const {
        double low = 1e9;
        for (std::uint32_t i = line.first; i < line.first + line.count; ++i)
            low = std::min(low, double(set().points[i].place[axis]));
        return low;
    }
    [[nodiscard]] double highest(const Polyline& line, int axis) const {
        double high = -1e9;
        for (std::uint32_t i = line.first; i < line.first + line.count; ++i)
            high = std::max(high, double(set().points[i].place[axis]));
        return high;
    }
};

TEST(ReconcilePolylines, WhatPixelsShowStaysAsItIs) {
    const PolylineSet lines = through({{4.5f, 10.1f}, {20.0f, 10.3f}, {35.5f, 10.1f}});
    const Reconciled found(level_lines({10.2}, 4.0), lines);
    ASSERT_EQ(found.set().lines.size(), 1u);
    EXPECT_NEAR(found.set().lines[0].length, lines.lines[0].length, 1e-3);
    EXPECT_NEAR(found.lowest(found.set().lines[0], 1), 10.1, 1e-5);
    EXPECT_NEAR(found.highest(found.set().lines[0], 1), 10.3, 1e-5);
    for (const LinePoint& point : found.set().points) EXPECT_EQ(point.width, 4.0f);
}

TEST(ReconcilePolylines, WhatPixelsDoNotShowIsCutOut) {
    RidgeField field = level_lines({10.2}, 4.0);
    for (int y = 0; y < 20; ++y)
        for (int x = 15; x < 25; ++x) field.set(x, y, {}, 0.0, 0.0, {}, 0.0, 0);
    const PolylineSet lines = through({{4.5f, 10.2f}, {35.5f, 10.2f}});
    const Reconciled found(field, lines);
    ASSERT_EQ(found.set().lines.size(), 2u);
    EXPECT_NEAR(found.highest(found.set().lines[0], 0), 14.5, 0.5 + 1e-5);
    EXPECT_NEAR(found.lowest(found.set().lines[1], 0), 25.5, 0.5 + 1e-5);
}

TEST(ReconcilePolylines, ACornerThatCutsIntoTheGroundIsMovedBack) {
    const PolylineSet lines = through({{4.5f, 10.2f}, {18.0f, 10.2f}, {20.0f, 11.1f}, {22.0f, 10.2f}, {35.5f, 10.2f}});
    const Reconciled found(level_lines({10.2}, 4.0), lines);
    ASSERT_EQ(found.set().lines.size(), 1u) << "whole";
    EXPECT_LE(found.highest(found.set().lines[0], 1), 10.2 + double(found.job.reach) + 1e-5);
}

TEST(ReconcilePolylines, WhatNoLineSaysBecomesALineAsWideAsItIsSeen) {
    const PolylineSet lines = through({{4.5f, 5.2f}, {35.5f, 5.2f}});
    const Reconciled found(level_lines({5.2, 14.7}, 4.0), lines);
    ASSERT_EQ(found.set().lines.size(), 2u) << "the second line is one";
    const Polyline& line = found.set().lines[1];
    EXPECT_NEAR(found.lowest(line, 0), 4.5, 0.51);
    EXPECT_NEAR(found.highest(line, 0), 35.5, 0.51);
    EXPECT_NEAR(found.lowest(line, 1), 14.7, 1e-4);
    EXPECT_EQ(found.set().points[line.first + line.count / 2].width, 4.0f);
    EXPECT_EQ(line.owner, 1u);
}

TEST(ReconcilePolylines, APixelAloneIsADotOfItsSize) {
    RidgeField field = level_lines({5.2}, 4.0);
    field.set(20, 12, {0.2, 0.1}, 1.0, 0.7, {0.6, 0.8}, 4.0);
    field.set(30, 12, {0.2, 0.1}, 1.0, 0.3, {0.6, 0.8}, 4.0); // too faint to be missed
    const PolylineSet lines = through({{4.5f, 5.2f}, {35.5f, 5.2f}});
    const Reconciled found(field, lines);
    ASSERT_EQ(found.set().lines.size(), 2u);
    const LinePoint& dot = found.set().points[found.set().lines[1].first];
    EXPECT_NEAR(glm::distance(dot.place, glm::vec2(20.7f, 12.6f)), 0.0, 0.1);
    EXPECT_FLOAT_EQ(dot.width, 1.0f);
    EXPECT_FLOAT_EQ(dot.opacity, 0.7f);
}

TEST(ReconcilePolylines, LinesThatCloseTheirGapsAreLeftAlone) {
    const PolylineSet lines = through({{2.0f, 2.0f}, {35.5f, 17.0f}});
    const Reconciled found(level_lines({5.2}, 4.0), lines, false);
    ASSERT_EQ(found.set().lines.size(), 1u);
    EXPECT_EQ(found.set().points.size(), 2u);
}

} // namespace
} // namespace hachure::geometry
