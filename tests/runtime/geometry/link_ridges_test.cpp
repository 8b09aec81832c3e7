#include <hachure/runtime/geometry/link_ridges.h>
#include <hachure/tests/runtime/geometry/ridge_fields.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace hachure::geometry {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// The lines of a field, traced and linked.
struct Linked {
    TraceRidgesJob trace;
    LinkRidgesJob link;
    std::vector<LineLimits> limits;

    explicit Linked(const RidgeField& field, float sign = 1.0f, float min_length = 0.0f)
        : limits(3, {min_length, min_length == 0.0f}) {
        trace.image = field.image();
        trace.sign = sign;
        trace.validate();
        trace.run();
        link.nodes = trace.nodes;
        link.segments = trace.segments;
        link.limits = limits;
        link.validate();
        link.run();
    }
    Linked(const Linked&) = delete;
    Linked& operator=(const Linked&) = delete;

    [[nodiscard]] const PolylineSet& set() const { return link.lines; }
    [[nodiscard]] std::size_t count() const { return set().lines.size(); }

    /// Root mean square and maximum of `distance` over the points for which it is a number.
    template <class Distance> [[nodiscard]] std::pair<double, double> deviation(Distance&& distance) const {
        double sum = 0.0, most = 0.0;
        int n = 0;
        for (const LinePoint& point : set().points) {
            const double d = distance(glm::dvec2(point.place));
            if (std::isnan(d)) continue;
            sum += d * d;
            most = std::max(most, std::abs(d));
            ++n;
        }
        return {std::sqrt(sum / std::max(n, 1)), most};
    }

    /// The different points in which lines end that others end in, too.
    [[nodiscard]] std::vector<glm::dvec2> junctions() const {
        std::set<std::pair<float, float>> found;
        for (const Polyline& line : set().lines) {
            const glm::vec2 start = set().points[line.first].place,
                            end = set().points[line.first + line.count - 1].place;
            if (line.start_joined) found.emplace(start.x, start.y);
            if (line.end_joined) found.emplace(end.x, end.y);
        }
        std::vector<glm::dvec2> result;
        for (const auto& [x, y] : found) result.emplace_back(x, y);
        return result;
    }
};

const double nothing = std::numeric_limits<double>::quiet_NaN();

struct Bar {
    glm::dvec2 middle, along;
    [[nodiscard]] double across(glm::dvec2 p) const { return along.x * (p - middle).y - along.y * (p - middle).x; }
    [[nodiscard]] double ahead(glm::dvec2 p) const { return glm::dot(p - middle, along); }
};

Bar bar_at(double degrees, glm::dvec2 middle) {
    return {middle, {std::cos(degrees * degree), std::sin(degrees * degree)}};
}

RidgeField field_of(const Bar& bar, double width, double half_length) {
    return find_ridges(120, 120, width, [&](glm::dvec2 p) {
        return 1.0 - blurred_bar(bar.across(p), width) * blurred_step(half_length - std::abs(bar.ahead(p)), width);
    });
}

TEST(LinkRidges, ACircleIsOneClosedLine) {
    const glm::dvec2 middle(80.3, 79.6);
    for (const double width : {3.0, 4.0, 6.0}) {
        const Linked lines(find_ridges(
            160, 160, width, [&](glm::dvec2 p) { return 1.0 - blurred_bar(glm::distance(p, middle) - 50.0, width); }));
        ASSERT_EQ(lines.count(), 1u) << width;
        EXPECT_TRUE(lines.set().lines[0].closed);
        EXPECT_EQ(lines.set().points.front().place, lines.set().points.back().place);
        EXPECT_NEAR(double(lines.set().lines[0].length), 100.0 * std::numbers::pi, 0.5);
        EXPECT_LE(lines.deviation([&](glm::dvec2 p) { return glm::distance(p, middle) - 50.0; }).first, 0.05) << width;
    }
}

TEST(LinkRidges, BarsOfAllAnglesAreOneLineWithinATwentiethOfAPixel) {
    for (int i = 0; i < 36; ++i) {
        const Bar bar = bar_at(5.0 * i, {60.0 + std::fmod(0.37 * i, 1.0), 60.0 + std::fmod(0.61 * i, 1.0)});
        const Linked lines(field_of(bar, 4.0, 40.0), 1.0f, 6.0f); // tones fork at the ends of a bar
        ASSERT_EQ(lines.count(), 1u) << 5 * i;
        EXPECT_FALSE(lines.set().lines[0].closed || lines.set().lines[0].start_joined ||
                     lines.set().lines[0].end_joined);
        EXPECT_NEAR(double(lines.set().lines[0].length), 80.0, 6.0) << 5 * i;
        // At its very ends the tone of a bar bends round.
        const auto [rms, most] =
            lines.deviation([&](glm::dvec2 p) { return std::abs(bar.ahead(p)) < 36.0 ? bar.across(p) : nothing; });
        EXPECT_LE(rms, 0.01) << 5 * i;
        EXPECT_LE(most, 0.05) << 5 * i;
        for (const LinePoint& point : lines.set().points) EXPECT_FLOAT_EQ(point.width, 4.0f);
    }
}

TEST(LinkRidges, CrossingLinesMeetInOnePoint) {
    const glm::dvec2 middle(60.37, 60.21);
    for (const double turn : {0.0, 10.0, 27.0, 33.0, 45.0, 62.0}) {
        const Bar a = bar_at(turn, middle), b = bar_at(turn + 90.0, middle);
        const Linked lines(find_ridges(120, 120, 4.0, [&](glm::dvec2 p) {
            return (1.0 - blurred_bar(a.across(p), 4.0)) * (1.0 - blurred_bar(b.across(p), 4.0));
        }));
        EXPECT_EQ(lines.count(), 4u) << turn;
        ASSERT_EQ(lines.junctions().size(), 1u) << turn;
        EXPECT_LE(glm::distance(lines.junctions()[0], middle), 0.05) << turn;
        const auto [rms, most] =
            lines.deviation([&](glm::dvec2 p) { return std::min(std::abs(a.across(p)), std::abs(b.across(p))); });
        EXPECT_LE(rms, 0.05) << turn;
        EXPECT_LE(most, 0.2) << turn;
    }
}

/// Where lines cross at an acute angle their ridges merge for a while, as the pixels do: two junctions with a link.
TEST(LinkRidges, AcuteCrossingsStayConnected) {
    const glm::dvec2 middle(60.37, 60.21);
    for (const double angle : {30.0, 45.0, 60.0, 75.0}) {
        const Bar a = bar_at(12.0, middle), b = bar_at(12.0 + angle, middle);
        const Linked lines(find_ridges(120, 120, 4.0, [&](glm::dvec2 p) {
            return (1.0 - blurred_bar(a.across(p), 4.0)) * (1.0 - blurred_bar(b.across(p), 4.0));
        }));
        EXPECT_GE(lines.count(), 4u) << angle;
        EXPECT_LE(lines.count(), 5u) << angle;
        int free_ends = 0;
        for (const Polyline& line : lines.set().lines)
            free_ends += (line.start_joined ? 0 : 1) + (line.end_joined ? 0 : 1);
        EXPECT_EQ(free_ends, 4) << angle << ": those at the rim of the picture";
    }
}

TEST(LinkRidges, ALineThatEndsAtAnotherMeetsIt) {
    const glm::dvec2 middle(60.37, 60.21);
    for (const double turn : {0.0, 10.0, 27.0, 45.0}) {
        const Bar bar = bar_at(turn, middle), stem = bar_at(turn + 90.0, middle);
        const Linked lines(find_ridges(120, 120, 4.0, [&](glm::dvec2 p) {
            return (1.0 - blurred_bar(bar.across(p), 4.0)) *
                   (1.0 - blurred_bar(stem.across(p), 4.0) * blurred_step(stem.ahead(p), 4.0));
        }));
        EXPECT_EQ(lines.count(), 3u) << turn;
        ASSERT_EQ(lines.junctions().size(), 1u) << turn;
        EXPECT_LE(glm::distance(lines.junctions()[0], middle), 1.2) << turn << ": the stem draws the bar's tone to it";
        const auto away = [&](glm::dvec2 p) {
            return glm::distance(p, middle) < 8.0 ? nothing
                                                  : std::min(std::abs(bar.across(p)), std::abs(stem.across(p)));
        };
        EXPECT_LE(lines.deviation(away).first, 0.05) << turn;
    }
}

TEST(LinkRidges, GapsOfAPixelAreClosedAndLongOnesAreNot) {
    const Bar bar = bar_at(20.0, {60.3, 60.8});
    for (const int gap : {1, 2, 14}) {
        RidgeField field = field_of(bar, 4.0, 40.0);
        for (int y = 0; y < 120; ++y)
            for (int x = 60; x < 60 + gap; ++x) field.points[static_cast<std::size_t>(y * 120 + x)].w = 0.0f;
        EXPECT_EQ(Linked(field, 1.0f, 6.0f).count(), gap < 14 ? 1u : 2u) << gap;
    }
}

TEST(LinkRidges, LinesOfDifferentOwnersStayApart) {
    RidgeField field = field_of(bar_at(20.0, {60.3, 60.8}), 4.0, 40.0);
    for (int y = 0; y < 120; ++y)
        for (int x = 60; x < 120; ++x) field.owners[static_cast<std::size_t>(y * 120 + x)] *= 2;
    const Linked lines(field, 1.0f, 6.0f);
    ASSERT_EQ(lines.count(), 2u);
    EXPECT_EQ(lines.set().lines[0].owner + lines.set().lines[1].owner, 3u);
    for (const Polyline& line : lines.set().lines) EXPECT_FALSE(line.start_joined || line.end_joined);
}

TEST(LinkRidges, KindsStayApartAndParallelLinesToo) {
    const Bar bar = bar_at(35.0, {60.3, 60.8});
    const RidgeField field = find_ridges(120, 120, 4.0, [&](glm::dvec2 p) {
        return 0.5 - blurred_bar(bar.across(p) - 6.0, 4.0, 0.4) - blurred_bar(bar.across(p) + 6.0, 4.0, 0.4) +
               blurred_bar(bar.across(p), 4.0, 0.4);
    });
    const Linked valleys(field, 1.0f), ridges(field, -1.0f);
    EXPECT_EQ(valleys.count(), 2u);
    EXPECT_EQ(ridges.count(), 1u);
    EXPECT_LE(ridges.deviation([&](glm::dvec2 p) { return bar.across(p); }).second, 0.05);
    // Each is pushed away from the bright one between them; how far is the tone's business.
    EXPECT_LE(valleys.deviation([&](glm::dvec2 p) { return std::abs(bar.across(p)) - 6.0; }).second, 0.5);
}

TEST(LinkRidges, ShortLinesAndSpursAreLeftOut) {
    const Bar bar = bar_at(0.0, {60.3, 60.8}), dash = bar_at(0.0, {60.3, 90.3}), spur = bar_at(90.0, {60.3, 60.8});
    const RidgeField field = find_ridges(120, 120, 4.0, [&](glm::dvec2 p) {
        const double spurs = blurred_bar(spur.across(p), 4.0) * blurred_step(8.0 - std::abs(spur.ahead(p) - 6.0), 4.0);
        const double dashes = blurred_bar(dash.across(p), 4.0) * blurred_step(4.0 - std::abs(dash.ahead(p)), 4.0);
        return (1.0 - blurred_bar(bar.across(p), 4.0)) * (1.0 - spurs) * (1.0 - dashes);
    });
    EXPECT_EQ(Linked(field).count(), 4u) << "a dash, and three lines that meet";
    const Linked pruned(field, 1.0f, 20.0f);
    ASSERT_EQ(pruned.count(), 1u);
    EXPECT_GT(pruned.set().lines[0].length, 110.0f);
}

TEST(LinkRidges, WhatIsNoNumberIsNoLine) {
    RidgeField field = field_of(bar_at(20.0, {60.3, 60.8}), 4.0, 40.0);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (std::size_t i = 0; i < field.points.size(); i += 7) field.points[i] = glm::vec4(nan);
    for (std::size_t i = 0; i < field.points.size(); i += 11) field.directions[i] = glm::vec4(nan);
    const Linked lines(field);
    EXPECT_GT(lines.count(), 0u);
    for (const LinePoint& point : lines.set().points)
        EXPECT_TRUE(std::isfinite(point.place.x) && std::isfinite(point.place.y) && std::isfinite(point.opacity));
}

/// What only two pixels saw is a short line, not nothing.
TEST(LinkRidges, DotsAreLines) {
    RidgeField field(20, 20);
    field.set(9, 10, {0.6, 0.0}, 0.1, 0.7, {0.0, 1.0}, 4.0);
    field.set(10, 10, {-0.4, 0.0}, 0.1, 0.5, {0.0, 1.0}, 4.0);
    const Linked lines(field);
    ASSERT_EQ(lines.count(), 1u);
    EXPECT_FLOAT_EQ(lines.set().lines[0].length, 1.0f);
    for (const LinePoint& point : lines.set().points) EXPECT_NEAR(double(point.place.x), 10.1, 1e-4);
    EXPECT_NEAR(double(lines.set().points[0].opacity), 0.58, 1e-4);
    EXPECT_EQ(Linked(field, 1.0f, 2.0f).count(), 0u);
}

TEST(LinkRidges, PicturesWithoutLinesHaveNone) {
    EXPECT_EQ(Linked(RidgeField(64, 48)).count(), 0u);
    EXPECT_EQ(Linked(RidgeField(1, 1)).count(), 0u);
    EXPECT_EQ(Linked(RidgeField(0, 0)).count(), 0u);
}

/// Equivariance: the input moves by whole pixels, and so do the lines.
TEST(LinkRidges, LinesMoveWithThePicture) {
    const auto scene = [](glm::dvec2 shift) {
        const Bar a = bar_at(27.0, glm::dvec2(60.37, 60.21) + shift), b = bar_at(117.0, a.middle);
        return find_ridges(128, 128, 4.0, [=](glm::dvec2 p) {
            return (1.0 - blurred_bar(a.across(p), 4.0) * blurred_step(30.0 - std::abs(a.ahead(p)), 4.0)) *
                   (1.0 - blurred_bar(b.across(p), 4.0) * blurred_step(30.0 - std::abs(b.ahead(p)), 4.0));
        });
    };
    const Linked here(scene({0.0, 0.0})), there(scene({4.0, -3.0}));
    ASSERT_EQ(here.set().points.size(), there.set().points.size());
    ASSERT_EQ(here.count(), there.count());
    for (std::size_t i = 0; i < here.set().points.size(); ++i)
        EXPECT_LE(glm::distance(here.set().points[i].place + glm::vec2(4.0f, -3.0f), there.set().points[i].place),
                  1e-3f);
}

} // namespace
} // namespace hachure::geometry
