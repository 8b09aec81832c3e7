// Where strokes lie: on the surface, also across folds and when it deforms, and along straight paths.

#include <hachure/systems/shade_strokes/stroke_layout.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/shade_picture.h>
#include <hachure/tests/support/stroke_points.h>
#include <hachure/tests/support/stroke_reference.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace hachure::test {
namespace {

double distance_to_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const auto inside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return glm::dot(glm::cross(to - from, p - from), normal) >= 0.0;
    };
    if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(glm::dot(p - a, glm::normalize(normal)));
    const auto to_edge = [&](const glm::dvec3& from, const glm::dvec3& to) {
        const glm::dvec3 edge = to - from;
        const double t = std::clamp(glm::dot(p - from, edge) / glm::dot(edge, edge), 0.0, 1.0);
        return glm::distance(p, from + t * edge);
    };
    return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

double distance_to_surface(const glm::dvec3& p, const std::vector<glm::vec3>& places,
                           const std::vector<std::uint32_t>& indices) {
    double least = 1e30;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const glm::dvec3 a(places[indices[i]]), b(places[indices[i + 1]]), c(places[indices[i + 2]]);
        const glm::dvec3 middle = (a + b + c) / 3.0;
        const double reach = std::max({glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)});
        if (glm::distance(p, middle) - reach < least) least = std::min(least, distance_to_triangle(p, a, b, c));
    }
    return least;
}

/// A sheet folded by `angle` (radians, positive: a ridge, negative: a valley) along z, its normals smooth across.
geometry::Shape folded_sheet(double angle) {
    constexpr int rows = 12, columns = 25; // an odd number of cells: the fold is at x = 0
    geometry::Shape sheet;
    for (int i = 0; i <= rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double z = 2.0 * i / rows - 1.0, x = 2.0 * j / (columns - 1) - 1.0;
            const double half = 0.5 * angle, side = x < 0.0 ? -1.0 : x > 0.0 ? 1.0 : 0.0;
            sheet.positions.emplace_back(x * std::cos(half), -std::abs(x) * std::sin(half), z);
            sheet.normals.emplace_back(side * std::sin(half), std::cos(half), 0.0);
            sheet.normals.back() = glm::normalize(sheet.normals.back());
        }
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j + 1 < columns; ++j) {
            const auto v = static_cast<std::uint32_t>(i * columns + j);
            const std::uint32_t w = v + static_cast<std::uint32_t>(columns);
            sheet.indices.insert(sheet.indices.end(), {v, w, v + 1, v + 1, w, w + 1});
        }
    return sheet;
}

/// A flat sheet with a round hole, whose rim is a polygon.
geometry::Shape sheet_with_hole() {
    constexpr int spokes = 24, rings = 5;
    geometry::Shape sheet;
    for (int i = 0; i <= rings; ++i)
        for (int k = 0; k < spokes; ++k) {
            const double r = 0.35 + 0.65 * i / rings, angle = 2.0 * std::numbers::pi * k / spokes;
            sheet.positions.emplace_back(r * std::cos(angle), 0.0, -r * std::sin(angle));
            sheet.normals.emplace_back(0.0f, 1.0f, 0.0f);
        }
    for (int i = 0; i < rings; ++i)
        for (int k = 0; k < spokes; ++k) {
            const auto a = static_cast<std::uint32_t>(i * spokes + k);
            const auto b = static_cast<std::uint32_t>(i * spokes + (k + 1) % spokes);
            sheet.indices.insert(sheet.indices.end(), {a, a + spokes, b, b, a + spokes, b + spokes});
        }
    return sheet;
}

/// Distances of drawn strokes from the surface, over the size of the model, sorted: of every stroke, or of about
/// `most`.
std::vector<double> distances_off(ShadePicture& picture, const std::vector<glm::vec3>& places,
                                  const std::vector<std::uint32_t>& indices, double size, std::size_t most = 1500) {
    std::vector<double> result;
    const std::vector<DrawnStroke> strokes = read_strokes(picture);
    for (std::size_t s = 0; s < strokes.size(); s += 1 + strokes.size() / most)
        for (std::size_t k = 0; k < 4; ++k)
            for (const double x : {0.0, 0.5}) {
                const glm::dvec3 place = glm::mix(strokes[s].point[k], strokes[s].point[k + 1], x);
                result.push_back(distance_to_surface(place, places, indices) / size);
            }
    std::ranges::sort(result);
    return result;
}

// A model whose size is 1000 pixels on the screen has strokes of about 1 pixel.
constexpr double a_line = 0.001;

/// All strokes of a shape that the sun is on are within half a line's width of it.
void expect_hugged(const geometry::Shape& shape, std::uint32_t cells, float trueness, const glm::vec3& sun) {
    ShadeSettings settings;
    settings.trueness = trueness;
    ShadeRig rig(shape, cells, settings);
    rig.step({shade_sun(sun)});
    ShadePicture picture(rig);
    picture.draw(shade_view(2.0f * rig.mesh().size * glm::normalize(glm::vec3(0.3f, 1.0f, 0.6f)), 1000, 1000));
    const std::vector<double> off = distances_off(picture, rig.shape().positions, rig.shape().indices, rig.mesh().size);
    ASSERT_GT(off.size(), 2000u);
    EXPECT_LT(off.back(), 0.5 * a_line);
}

using StrokeSurfaceTest = GlTest;

/// Also where strokes run aslant over a fold, or end at one that is too sharp for them.
TEST_P(StrokeSurfaceTest, HugsFolds) {
    for (const double degrees : {-120.0, -60.0, -20.0, 40.0, 90.0, 110.0})
        for (const float trueness : {0.0f, 0.9f}) {
            SCOPED_TRACE(::testing::Message() << degrees << " degrees, trueness " << trueness);
            expect_hugged(folded_sheet(glm::radians(degrees)), 400, trueness, {0.3f, 0.1f, 0.2f});
        }
}

TEST_P(StrokeSurfaceTest, HugsRoundForms) {
    for (const int level : {2, 3}) {
        SCOPED_TRACE(::testing::Message() << "sphere " << level);
        expect_hugged(geometry::icosphere(1.0, level), 800, 0.9f, {1.0f, 0.1f, 0.2f});
    }
    expect_hugged(geometry::torus(1.0, 0.4, 30, 15), 800, 0.9f, {1.0f, 0.1f, 0.2f});
    expect_hugged(geometry::torus(1.0, 0.15, 40, 8), 800, 0.9f, {1.0f, 0.1f, 0.2f});
}

/// Nothing is drawn over a hole: its rim is where ribs end.
TEST_P(StrokeSurfaceTest, LeavesHolesOpen) {
    for (const float trueness : {0.0f, 0.9f}) expect_hugged(sheet_with_hole(), 400, trueness, {1.0f, 0.2f, 0.2f});
}

/// A sheet that was flat when its strokes were laid and is rolled up now: they lie on what it has become.
TEST_P(StrokeSurfaceTest, RidesOnDeformedSurfaces) {
    ShadeRig rig(geometry::plane(2.0, 24), 800);
    rig.step({shade_sun({1.0f, 0.3f, 0.2f})});
    std::vector<glm::vec3> rolled;
    for (const glm::vec3& p : rig.shape().positions)
        rolled.emplace_back(std::sin(p.x), std::cos(p.x) - 1.0f, p.z + 0.2f * p.x);
    ShadePicture picture(rig);
    picture.deform(rolled);
    picture.draw(shade_view({0.3f, 7.0f, 1.0f}, 1000, 1000));
    const std::vector<double> off = distances_off(picture, rolled, rig.shape().indices, rig.mesh().size);
    ASSERT_GT(off.size(), 1000u);
    // Nodes were laid on the plane, as far apart as that allows for: in between the patch is straight.
    EXPECT_LT(off[off.size() / 2], 0.5 * a_line);
    EXPECT_LT(off[off.size() * 99 / 100], 2.0 * a_line);
}

/// Chains over the diagonals of squares are straight, where the paper's curves sway to and fro (section 2.3.5): a
/// segment leaves the straight line by 5 % of its length at most.
TEST_P(StrokeSurfaceTest, DoesNotBendOverDiagonals) {
    for (const geometry::Shape& shape : {geometry::plane(2.0, 12), geometry::cylinder(0.6, 2.0, 24)}) {
        ShadeSettings settings;
        settings.trueness = 1.0f;
        ShadeRig rig(shape, 800, settings);
        rig.step({shade_sun({0.2f, 0.4f, -1.0f})});
        ShadePicture picture(rig);
        picture.draw(shade_view({0.5f, 5.0f, 5.0f}, 800, 800));
        std::vector<float> seen(std::size_t{picture.buffers.segment_count()} * stroke_layout::seen_bytes /
                                sizeof(float));
        picture.buffers.seen.read(std::span<float>(seen));
        std::size_t count = 0;
        for (std::uint32_t s = 0; s < picture.buffers.segment_count(); ++s) {
            const ShadeSegment& segment = rig.chains().segments[s];
            if (segment.cell == no_slot) continue;
            const double chord = glm::distance(rig.at(segment.from), rig.at(segment.to));
            const float* at = seen.data() + s * stroke_layout::seen_bytes / sizeof(float);
            const glm::dvec2 first(at[0], at[1]), second(at[2], at[3]);
            const double reach = glm::distance(rig.at(segment.from, 4), rig.at(segment.from, 0)) / 2.0;
            for (const double v : {0.2, 0.4, 0.6, 0.8}) {
                const glm::dvec2 off = 3.0 * v * (1.0 - v) * ((1.0 - v) * first + v * second);
                EXPECT_LT(glm::length(off * glm::dvec2(chord, reach)), 0.05 * chord) << s;
            }
            count += glm::length(first) > 0.0 ? 1 : 0;
        }
        EXPECT_GT(count, 50u); // they do bend a little: of rounding, and where chains were joined
    }
}

/// Stroke by stroke, what the GPU makes of segments is what the reference does.
TEST_P(StrokeSurfaceTest, IsWhatTheReferenceSays) {
    constexpr int most_read = 64;
    ShadeRig rig(geometry::torus(1.0, 0.4, 48, 24), 1500);
    rig.step_sun(40.0);
    ShadePicture picture(rig);
    for (const float distance : {3.0f, 9.0f}) {
        const View view = shade_view(glm::normalize(glm::vec3(0.3f, 1.0f, 1.0f)) * distance, 700, 700);
        picture.draw(view);
        std::vector<std::vector<DrawnStroke>> by_segment(picture.buffers.segment_count());
        for (const DrawnStroke& stroke : read_strokes(picture, most_read)) by_segment[stroke.segment].push_back(stroke);
        const StrokeReference reference(rig, view, picture.style);
        std::size_t compared = 0, other_count = 0;
        double worst = 0.0;
        for (std::uint32_t s = 0; s < by_segment.size(); ++s) {
            if (by_segment[s].empty() || by_segment[s].size() == most_read) continue;
            const auto points = reference.points(rig.chains().segments[s]);
            if (!points) continue;
            ++compared;
            if (points->size() != by_segment[s].size() + 1) { // a value next to where the level changes
                ++other_count;
                continue;
            }
            for (std::size_t i = 0; i < by_segment[s].size(); ++i) {
                worst = std::max(worst, glm::distance((*points)[i], by_segment[s][i].point[0]));
                worst = std::max(worst, glm::distance((*points)[i + 1], by_segment[s][i].point[4]));
            }
        }
        EXPECT_GT(compared, 300u);
        EXPECT_LT(other_count, compared / 100);
        EXPECT_LT(worst, 3e-4 * rig.mesh().size) << distance; // a third of a pixel where that is 1000 pixels
    }
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(StrokeSurfaceTest);

} // namespace
} // namespace hachure::test
