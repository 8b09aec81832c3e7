// Strokes get delicate where a surface bends more than it did at rest, without being laid anew.

#include <hachure/systems/shade_strokes/shade_narrowing.h>
#include <hachure/tests/support/bent_cylinder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "chain_checks.h"

namespace hachure::test {
namespace {

constexpr ShadeSettings by_radius{
    .amplitude = 0.02f, .amplitude_by_curvature = 1.0f, .min_amplitude = 1e-4f, .max_amplitude = 1.0f};

std::vector<float> shares_of(const CylinderMesh& tube, const std::vector<glm::vec2>& curvatures,
                             const ShadeSettings& settings) {
    ShadeNarrowingJob job{.positions = tube.positions,
                          .indices = tube.indices,
                          .curvatures = curvatures,
                          .settings = settings,
                          .size = 7.0};
    job.validate();
    job.run();
    return job.shares;
}

/// Exact ones.
std::vector<glm::vec2> curvatures_of(const CylinderMesh& tube, double angle) {
    const BentCylinder bent{.angle = angle};
    std::vector<glm::vec2> result;
    for (std::size_t v = 0; v < tube.positions.size(); ++v) {
        const BentCylinder::Exact exact = bent.exact(tube.longitude(v), tube.height(v));
        result.emplace_back(exact.k1, exact.k2);
    }
    return result;
}

TEST(ShadeNarrowingTest, AmplitudesAreInverseToCurvatureWhereTheyFollowItAlone) {
    // The radius of the tube is 1 at rest: what is left is the radius that there is now.
    const CylinderMesh tube(72);
    const std::vector<glm::vec2> now = curvatures_of(tube, std::numbers::pi / 3.0);
    const std::vector<float> shares = shares_of(tube, now, by_radius);
    std::size_t narrow = 0;
    double square = 0.0, count = 0.0;
    for (std::size_t v = 0; v < shares.size(); ++v) {
        if (std::abs(tube.height(v)) > 0.8 * BentCylinder::half_length) continue; // one-sided at the borders
        const double wanted = std::min(1.0, 1.0 / std::abs(double{now[v].x}));
        EXPECT_NEAR(shares[v], wanted, 0.2) << tube.longitude(v) << " " << tube.height(v);
        EXPECT_LE(shares[v], 1.0f);
        square += std::pow(shares[v] - wanted, 2);
        count += 1.0;
        narrow += wanted < 0.7 ? 1 : 0;
    }
    EXPECT_LT(std::sqrt(square / count), 0.03) << "curvatures are smoothed over a few edges";
    EXPECT_GT(narrow, 50u);
}

TEST(ShadeNarrowingTest, ByHalfTheyAreNarrowedByLessAndByNothingNotAtAll) {
    const CylinderMesh tube(48);
    const std::vector<glm::vec2> now(tube.positions.size(), glm::vec2(2.0f, 0.0f));
    const auto share = [&](float by) {
        ShadeSettings settings = by_radius;
        settings.amplitude_by_curvature = by;
        return double{shares_of(tube, now, settings)[tube.positions.size() / 2]};
    };
    // The radius goes from 1 / 7 of the size to half of that; a quarter of the size has the set amplitude.
    const auto amplitude = [](double by, double radius) { return 1.0 - by + by * radius * 4.0 / 7.0; };
    for (const float by : {1.0f, 0.5f, 0.2f})
        EXPECT_NEAR(share(by), amplitude(by, 0.5) / amplitude(by, 1.0), 0.01) << by;
    EXPECT_EQ(share(0.0f), 1.0);
}

TEST(ShadeNarrowingTest, WhatStraightensOrStaysKeepsItsAmplitude) {
    const CylinderMesh tube(48);
    for (const float curvature : {0.0f, 0.3f, 0.99f}) {
        const std::vector<glm::vec2> now(tube.positions.size(), glm::vec2(curvature, 0.0f));
        for (const float share : shares_of(tube, now, by_radius)) EXPECT_GT(share, 0.98f) << curvature;
    }
}

/// Shares of a mesh whose upper half is narrow.
std::vector<float> narrow_above(const geometry::Shape& shape, float share) {
    std::vector<float> result;
    for (const glm::vec3& p : shape.positions) result.push_back(p.y > 0.0f ? share : 1.0f);
    return result;
}

void narrow(ShadeRig& rig, const std::vector<float>& shares) {
    rig.update.narrowing = {shares, rig.shape().indices};
    rig.update.narrowed = true;
    rig.update.changed = false;
    rig.update.run();
    rig.update.narrowed = false;
}

/// Narrow strokes deliver less; so others come beside them, and go again. Those that were there stay where they are.
TEST(ShadeNarrowingTest, NeedsAreMetByMoreStrokesWhereTheyAreNarrow) {
    ShadeRig rig(geometry::irregular_torus(1.0, 0.4, 80, 32, 0.2, 5), 1200);
    rig.step_sun(20.0);
    const ShadeChains wide = rig.chains();
    const std::vector<float> shares = narrow_above(rig.shape(), 0.5f);
    narrow(rig, shares);
    expect_sound(rig.mesh(), rig.chains());
    EXPECT_LT(rig.error().largest, 0.05);
    EXPECT_LT(rig.error().unmet, 25u);
    EXPECT_GT(rig.chains().segments.live(), wide.segments.live() + wide.segments.live() / 8);
    for (std::uint32_t s = 0; s < wide.segments.all().size(); ++s) {
        if (wide.segments[s].cell == no_slot) continue;
        const ShadeSegment& now = rig.chains().segments[s];
        ASSERT_EQ(now.from, wide.segments[s].from) << "strokes are not laid anew";
        ASSERT_EQ(std::memcmp(&rig.chains().nodes[now.from], &wide.nodes[now.from], sizeof(ShadeNode)), 0);
        const float share = rig.update.narrowing.of(rig.chains().nodes[now.from]);
        EXPECT_GT(share, 0.499f);
    }
    narrow(rig, {});
    expect_sound(rig.mesh(), rig.chains());
    EXPECT_LT(rig.error().largest, 0.05);
    for (std::uint32_t s = 0; s < rig.chains().segments.all().size(); ++s)
        EXPECT_EQ(rig.chains().links[s].shade, rig.chains().links[s].laid);
}

TEST(ShadeNarrowingTest, CellsThatCouldNotMeetTheirNeedTryAgain) {
    ShadeRig rig(geometry::icosphere(1.0, 2), 12, {.density = 0.01f});
    rig.step_sun(0.0);
    const std::size_t before = rig.chains().segments.live();
    ASSERT_GT(rig.error().unmet, 0u) << "strokes are too faint for it";
    narrow(rig, std::vector<float>(rig.shape().positions.size(), 0.3f));
    expect_sound(rig.mesh(), rig.chains());
    EXPECT_GT(rig.chains().segments.live(), before + before / 2);
}

TEST(ShadeNarrowingTest, SharesOfOneChangeNothing) {
    ShadeRig plain(geometry::torus(1.0, 0.4, 64, 32), 800), narrowed(geometry::torus(1.0, 0.4, 64, 32), 800);
    const std::vector<float> shares(plain.shape().positions.size(), 1.0f);
    for (int i = 0; i < 6; ++i) {
        plain.step_sun(15.0 * i);
        narrowed.step_sun(15.0 * i);
        narrow(narrowed, shares);
    }
    EXPECT_TRUE(same_chains(plain.chains(), narrowed.chains()));
}

} // namespace
} // namespace hachure::test
