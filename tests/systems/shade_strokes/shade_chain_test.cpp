#include <hachure/systems/shade_strokes/shade_ribs.h>

#include <gtest/gtest.h>

#include <numbers>

#include "chain_checks.h"

namespace hachure::test {
namespace {

template <class Visit> void each_segment(const ShadeRig& rig, const Visit& visit) {
    for (std::uint32_t s = 0; s < rig.chains().segments.all().size(); ++s)
        if (const ShadeSegment& segment = rig.chains().segments[s]; segment.cell != no_slot) visit(s, segment);
}

/// Quads of a cylinder of any slope, cut along one diagonal or by turns along either.
geometry::Shape strip(double radius, std::uint32_t around, std::uint32_t up, bool by_turns) {
    geometry::Shape shape;
    for (std::uint32_t j = 0; j <= up; ++j) {
        for (std::uint32_t i = 0; i <= around; ++i) {
            const double a = 0.5 * std::numbers::pi * i / around;
            shape.positions.emplace_back(radius * std::sin(a), 2.0 * j / up, radius * std::cos(a));
            shape.normals.emplace_back(std::sin(a), 0.0, std::cos(a));
        }
    }
    for (std::uint32_t j = 0; j < up; ++j) {
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = j * (around + 1) + i, b = a + 1, c = b + around + 1, d = a + around + 1;
            if (by_turns && (i + j) % 2 == 1)
                shape.indices.insert(shape.indices.end(), {a, b, d, b, c, d});
            else
                shape.indices.insert(shape.indices.end(), {a, b, c, a, c, d});
        }
    }
    return shape;
}

/// A cylinder unrolls, and its straightest paths are straight lines then: a chain goes on from segment to segment with
/// no more than 5 % of a segment to the side, whichever way the diagonals of quads run.
TEST(ShadeChainTest, ChainsDoNotBendOverDiagonals) {
    for (const bool by_turns : {false, true}) {
        ShadeRig rig(strip(1.0, 12, 12, by_turns), 600, {.trueness = 1.0f});
        rig.step({});
        const auto unrolled = [&](std::uint32_t node) {
            const glm::dvec3 p = rig.at(node);
            return glm::dvec2(std::atan2(p.x, p.z), p.y);
        };
        double worst = 0.0;
        std::size_t count = 0;
        each_segment(rig, [&](std::uint32_t, const ShadeSegment& segment) {
            if (segment.before == no_slot) return;
            const glm::dvec2 before = unrolled(rig.chains().segments[segment.before].from),
                             from = unrolled(segment.from), to = unrolled(segment.to);
            const glm::dvec2 along = glm::normalize(to - before), run = from - before;
            const double off = std::abs(along.x * run.y - along.y * run.x);
            worst = std::max(worst, off / std::max(glm::length(run), glm::length(to - from)));
            ++count;
        });
        EXPECT_GT(count, 200u);
        EXPECT_LT(worst, 0.05) << by_turns;
    }
}

/// A chain runs with the direction it was begun in, as far as its normal turns, and not through borders.
TEST(ShadeChainTest, ChainsKeepTheirGeneralDirectionAndTurnNoFurther) {
    ShadeSettings settings{.chain_turn = 0.8f, .trueness = 0.5f};
    ShadeRig rig(geometry::irregular_torus(1.0, 0.4, 120, 60, 0.2, 5), 1500, settings);
    rig.step({});
    EXPECT_GT(rig.chains().chains.live(), 100u);
    std::size_t against = 0, count = 0;
    each_segment(rig, [&](std::uint32_t, const ShadeSegment& segment) {
        const ShadeChain& chain = rig.chains().chains[segment.chain];
        const glm::dvec3 run = rig.at(segment.to) - rig.at(segment.from);
        against += glm::dot(run, glm::dvec3(chain.general)) < 0.0 ? 1 : 0;
        ++count;
        for (const std::uint32_t node : {segment.from, segment.to}) {
            const glm::dvec3 p = rig.at(node);
            const glm::dvec3 middle = glm::normalize(glm::dvec3(p.x, 0.0, p.z));
            const double cosine = glm::dot(glm::normalize(p - middle), glm::dvec3(chain.normal));
            // Joined chains keep the normal of the first; triangles are flat.
            EXPECT_GT(cosine, std::cos(0.8 + 0.1));
        }
    });
    EXPECT_EQ(against, 0u) << "of " << count;
}

/// Trueness 1 follows the second principal direction; less wanders around it, evenly to both sides.
TEST(ShadeChainTest, TruenessWeighsDirectionAgainstDisturbance) {
    const auto turn = [](float trueness) {
        ShadeRig rig(geometry::irregular_torus(1.0, 0.4, 120, 60, 0.2, 5), 1500, {.trueness = trueness});
        rig.step({});
        double sum = 0.0, signed_sum = 0.0, weight = 0.0;
        each_segment(rig, [&](std::uint32_t, const ShadeSegment& segment) {
            const glm::dvec3 a = rig.at(segment.from), run = rig.at(segment.to) - a;
            const glm::dvec3 around = glm::normalize(glm::dvec3(-a.z, 0.0, a.x));
            const glm::dvec3 outward = a - glm::normalize(glm::dvec3(a.x, 0.0, a.z));
            const glm::dvec3 side = glm::normalize(glm::cross(outward, around));
            const double along = glm::dot(run, around), across = glm::dot(run, side);
            sum += std::atan2(std::abs(across), std::abs(along)) * glm::length(run);
            signed_sum += std::atan(across / (std::abs(along) + 1e-9)) * (along < 0.0 ? -1.0 : 1.0) * glm::length(run);
            weight += glm::length(run);
        });
        EXPECT_LT(std::abs(signed_sum / weight), 0.1);
        return sum / weight;
    };
    const double exact = turn(1.0f), usual = turn(0.8f), wild = turn(0.3f);
    EXPECT_LT(exact, 0.09);
    EXPECT_GT(usual, exact);
    EXPECT_GT(wild, 2.0 * usual);
}

/// On a plane ribs are straight, perpendicular to the chain and as wide as the amplitude, which is finite.
TEST(ShadeChainTest, RibsOnAPlane) {
    const ShadeMesh mesh = [] {
        const geometry::Shape shape = geometry::plane(2.0, 7);
        return make_shade_mesh({.positions = shape.positions, .normals = shape.normals, .indices = shape.indices});
    }();
    const ShadeSettings settings{.amplitude_by_curvature = 1.0f};
    const std::uint32_t t = static_cast<std::uint32_t>(mesh.sheets.triangles.size() / 2);
    const geometry::WalkPlace place{t, {0.3, 0.3, 0.4}};
    EXPECT_FLOAT_EQ(shade_amplitude(mesh, settings, place), settings.max_amplitude * mesh.size);
    const glm::dvec3 heading = glm::normalize(glm::dvec3(1.0, 0.0, 0.7));
    const ShadeNode node = make_shade_rib(mesh, settings, place, heading, 0.0).node;
    const glm::dvec3 left = glm::cross(glm::dvec3(0, 1, 0), heading);
    const double a = settings.max_amplitude * mesh.size;
    EXPECT_NEAR(node.amplitude, a, 1e-6);
    for (std::size_t k = 0; k < rib_points; ++k) {
        const glm::dvec3 off = mesh.at(node.rib[k]) - mesh.at(node.rib[2]) - (0.5 * double(k) - 1.0) * a * left;
        EXPECT_LT(glm::length(off), 1e-6);
    }
}

/// On a cylinder a rib across the axis is an arc: its points lie on the triangles, at the right distance along them.
TEST(ShadeChainTest, RibsHugTheSurfaceAndEndAtBorders) {
    ShadeRig rig(strip(1.0, 200, 20, false), 600,
                 {.amplitude = 0.05f, .amplitude_by_curvature = 0.0f, .max_amplitude = 0.1f, .trueness = 1.0f});
    rig.step({});
    std::size_t whole = 0, cut = 0;
    const double a = 0.05 * rig.mesh().size;
    each_segment(rig, [&](std::uint32_t, const ShadeSegment& segment) {
        const ShadeNode& node = rig.chains().nodes[segment.from];
        double angle[rib_points], lowest = 1.0, highest = 0.0;
        for (std::size_t k = 0; k < rib_points; ++k) {
            const glm::dvec3 p = rig.at(segment.from, k);
            EXPECT_NEAR(std::hypot(p.x, p.z), 1.0, 1e-4);
            EXPECT_GE(std::min(p.x, p.z), -1e-6) << "not over the border";
            angle[k] = std::atan2(p.x, p.z);
            lowest = std::min(lowest, p.y);
            highest = std::max(highest, p.y);
        }
        if (lowest < 1e-6 || highest > 2.0 - 1e-6) return; // cut by the border that the chain ends at
        const double middle = angle[2], room = std::min(middle, 0.5 * std::numbers::pi - middle);
        if (room > a + 1e-3) {
            EXPECT_NEAR(node.amplitude, a, 1e-4);
            EXPECT_NEAR(std::abs(angle[4] - angle[0]), 2.0 * a, 2e-3);
            EXPECT_NEAR(std::abs(angle[3] - angle[1]), double{node.bend[1] - node.bend[0]} * a, 2e-3);
            ++whole;
        } else if (room < 0.9 * a) {
            EXPECT_NEAR(node.amplitude, 0.5 * (a + room), 2e-3);
            ++cut;
        }
    });
    EXPECT_GT(whole, 50u);
    EXPECT_GT(cut, 5u);
}

/// The patch between the ribs of a segment stays within half a line's width of folded surfaces, convex and concave.
TEST(ShadeChainTest, PatchesStayAtTheSurfaceOverFolds) {
    for (const double fold : {0.5, -0.5}) {
        geometry::Shape shape = geometry::plane(2.0, 24);
        shape.normals.clear();
        for (glm::vec3& p : shape.positions) p.y = static_cast<float>(-fold * std::abs(p.x));
        ShadeRig rig(std::move(shape), 800, {.amplitude_by_curvature = 0.0f, .trueness = 0.3f});
        rig.step({});
        double worst = 0.0, sum = 0.0;
        std::size_t count = 0;
        each_segment(rig, [&](std::uint32_t, const ShadeSegment& segment) {
            for (std::size_t k = 0; k < rib_points; ++k) {
                const glm::dvec3 p = 0.5 * (rig.at(segment.from, k) + rig.at(segment.to, k));
                const double height = -fold * std::abs(p.x);
                const double off = std::abs(p.y - height) / std::sqrt(1.0 + fold * fold);
                worst = std::max(worst, off);
                sum += off;
                ++count;
            }
        });
        EXPECT_LT(sum / double(count), 0.0005 * rig.mesh().size);
        EXPECT_LT(worst, 0.004 * rig.mesh().size) << fold;
    }
}

TEST(ShadeChainTest, AmplitudeFollowsTheRadiusOfCurvature) {
    const auto amplitude = [](double radius) {
        geometry::Shape shape = geometry::icosphere(radius, 4);
        const geometry::Shape far = geometry::icosphere(0.1, 1); // sets the size of the model
        const auto first = static_cast<std::uint32_t>(shape.positions.size());
        for (const glm::vec3& p : far.positions) shape.positions.push_back(p + glm::vec3(9, 9, 9));
        for (const std::uint32_t i : far.indices) shape.indices.push_back(first + i);
        const ShadeMesh mesh = make_shade_mesh({.positions = shape.positions, .indices = shape.indices});
        const ShadeSettings settings{
            .amplitude = 0.008f, .amplitude_by_curvature = 1.0f, .min_amplitude = 1e-5f, .max_amplitude = 1.0f};
        return shade_amplitude(mesh, settings, {0, {0.2, 0.3, 0.5}}) / mesh.size;
    };
    // amplitude * radius / (size / 4), by the formula of shade_ribs.h
    const double size = std::sqrt(3.0) * 10.1; // about: the bounds from -1 to 9.1
    EXPECT_NEAR(amplitude(1.0), 0.008 * 4.0 / size, 0.05 * 0.008 * 4.0 / size);
    EXPECT_NEAR(amplitude(1.0) / amplitude(0.5), 2.0 * 9.6 / 10.1, 0.1);
}

} // namespace
} // namespace hachure::test
