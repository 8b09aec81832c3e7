#include <hachure/runtime/parallel.h>

#include <gtest/gtest.h>

#include <memory>
#include <numbers>

#include "chain_checks.h"

namespace hachure::test {
namespace {

constexpr double band = 0.04;

geometry::Shape knot() { return geometry::irregular_torus(1.0, 0.4, 90, 45, 0.3, 5); }

/// What the issue asks of any sequence of lights.
void expect_shaded(const ShadeRig& rig, const char* when) {
    const ShadeError error = rig.error();
    EXPECT_LE(error.mean, band) << when;
    EXPECT_LE(error.largest, 2.0 * band) << when;
    EXPECT_LT(error.unmet, rig.mesh().cell_count() / 50) << when;
}

TEST(ShadeUpdateTest, DeliversWhatIsNeededAfterAnyLights) {
    ShadeRig rig(knot(), 1500);
    rig.step_sun(0.0);
    expect_shaded(rig, "first");
    expect_sound(rig.mesh(), rig.chains());
    for (int i = 0; i < 40; ++i) {
        const double angle = 137.5 * i * i; // jumps and turns
        switch (i % 4) {
        case 0:
            rig.step_sun(angle);
            break;
        case 1:
            rig.step({shade_sun({std::sin(angle), 1, std::cos(angle)}, 0.5f)});
            break;
        case 2:
            rig.step({{.position = glm::vec4(2 * std::sin(angle), 1, 2 * std::cos(angle), 1), .range = 4.0f}});
            break;
        default:
            rig.step({shade_sun({1, 0, 0}, 0.4f), shade_sun({0, 0, 1}, 0.7f)});
        }
        expect_shaded(rig, "after a jump");
    }
    expect_sound(rig.mesh(), rig.chains());
    EXPECT_GT(rig.chains().segments.live(), 500u);
}

/// Ten thousand steps of a light that goes round and up and down leave no more strokes and no worse ones than the first
/// round did.
TEST(ShadeUpdateTest, TenThousandStepsDoNotDrift) {
    ShadeRig rig(geometry::irregular_torus(1.0, 0.4, 40, 20, 0.3, 5), 400);
    std::size_t segments = 0, chains = 0, slots = 0;
    double ink = 0.0;
    const auto turn = [&](int first, int end) {
        for (int i = first; i < end; ++i) {
            const double a = 2.0 * std::numbers::pi * i / 500.0;
            rig.step({shade_sun({std::sin(a), std::sin(3.0 * a), std::cos(a)})});
        }
    };
    turn(0, 1001);
    segments = rig.chains().segments.live();
    chains = rig.chains().chains.live();
    slots = rig.chains().segments.all().size();
    ink = rig.ink();
    expect_shaded(rig, "after 1000 steps");
    turn(1001, 10001);
    expect_shaded(rig, "after 10000 steps");
    expect_sound(rig.mesh(), rig.chains());
    EXPECT_NEAR(rig.ink(), ink, 0.02);
    EXPECT_LT(static_cast<double>(rig.chains().segments.live()), 1.15 * static_cast<double>(segments));
    EXPECT_LT(static_cast<double>(rig.chains().chains.live()), 1.15 * static_cast<double>(chains));
    EXPECT_LT(static_cast<double>(rig.chains().segments.all().size()), 1.25 * static_cast<double>(slots));
}

/// Each step changes less than the dead band: what is compared is what is there, so that steps add up.
TEST(ShadeUpdateTest, SlowFadesAreNoticed) {
    ShadeRig rig(knot(), 800);
    rig.light.tone.no_shade = 0.5f;
    const auto all_round = [&](float strength) {
        std::vector<ShadingLight> lights;
        for (const glm::vec3& v : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)})
            for (const float sign : {1.0f, -1.0f}) lights.push_back(shade_sun(sign * v, strength));
        rig.step(lights);
    };
    all_round(1.0f);
    EXPECT_EQ(rig.chains().segments.live(), 0u) << "nothing is dark";
    for (int i = 1; i <= 600; ++i) all_round(1.0f - static_cast<float>(i) / 600.0f);
    for (std::uint32_t c = 0; c < rig.mesh().cell_count(); ++c) {
        EXPECT_EQ(rig.needed()[c], 1.0f);
        if (rig.chains().cells[c].unmet < 0.0f) {
            EXPECT_GE(rig.chains().cells[c].delivered, 1.0f - 2.0f * band);
        }
    }
    expect_shaded(rig, "dark");
    expect_sound(rig.mesh(), rig.chains());
    for (int i = 1; i <= 600; ++i) all_round(static_cast<float>(i) / 600.0f);
    EXPECT_EQ(rig.chains().segments.live(), 0u);
    EXPECT_EQ(rig.chains().chains.live(), 0u);
    EXPECT_EQ(rig.chains().nodes.live(), 0u);
    for (const float delivered : rig.delivered()) EXPECT_EQ(delivered, 0.0f);
}

TEST(ShadeUpdateTest, ThereAndBackRestoresTheShade) {
    ShadeRig rig(knot(), 1000);
    rig.step_sun(0.0);
    const std::vector<float> before = rig.delivered();
    const double ink = rig.ink();
    for (int i = 1; i <= 40; ++i) rig.step_sun(2.0 * i);
    for (int i = 39; i >= 0; --i) rig.step_sun(2.0 * i);
    const std::vector<float> after = rig.delivered();
    double sum = 0.0;
    for (std::size_t c = 0; c < before.size(); ++c) {
        sum += std::abs(after[c] - before[c]);
        if (rig.chains().cells[c].unmet < 0.0f) {
            EXPECT_LE(std::abs(after[c] - before[c]), 2.0 * band);
        }
    }
    EXPECT_LE(sum / static_cast<double>(before.size()), band);
    EXPECT_NEAR(rig.ink(), ink, band);
}

/// Strengthening gives every segment what the cell lacks over the sum of their shade, and hands round what clips.
TEST(ShadeUpdateTest, WhatIsAskedForArrives) {
    ShadeRig rig(knot(), 500);
    rig.step({shade_sun({0, 1, 0}, 0.9f)});
    rig.step({shade_sun({0, 1, 0}, 0.6f)});
    std::size_t touched = 0;
    for (std::size_t c = 0; c < rig.needed().size(); ++c) {
        const ShadeCellState& cell = rig.chains().cells[c];
        const double off = rig.needed()[c] - cell.delivered;
        if (cell.unmet < 0.0f && std::abs(off) < 1e-4) ++touched;
    }
    EXPECT_GT(touched, rig.needed().size() / 4) << "cells that were touched get it all, not a share of it";
}

/// The paper's chains grow back into gaps: chains are extended and joined, and segments that faded in the middle split
/// them.
TEST(ShadeUpdateTest, ChainsSplitExtendAndJoin) {
    const ShadeSettings narrow{.amplitude = 0.006f, .min_amplitude = 0.002f, .max_amplitude = 0.01f}; // many chains
    ShadeRig rig(geometry::irregular_torus(1.0, 0.4, 90, 45, 0.2, 5), 1500, narrow);
    rig.step({});
    const std::size_t whole = rig.chains().chains.live();
    const ShadingLight spot{.position = glm::vec4(3, 0, 0, 1),
                            .direction = {-1, 0, 0},
                            .spot = true,
                            .inner_cone = 0.05f,
                            .outer_cone = 0.08f};
    rig.step({spot});
    EXPECT_GT(rig.update.stats.removed, 10u);
    expect_sound(rig.mesh(), rig.chains());
    rig.step({});
    EXPECT_GT(rig.update.stats.extended, 5u);
    EXPECT_GT(rig.update.stats.joined, 2u);
    expect_sound(rig.mesh(), rig.chains());
    EXPECT_LT(rig.chains().chains.live(), whole + whole / 10);
}

TEST(ShadeUpdateTest, NothingMovedNothingVisited) {
    ShadeRig rig(knot(), 800);
    rig.step_sun(10.0);
    ASSERT_TRUE(rig.chains().segments.changed());
    ShadeChains chains = rig.chains();
    chains.segments.forget_changes();
    chains.nodes.forget_changes();
    rig.update.chains = &chains;
    rig.step_sun(10.0);
    EXPECT_EQ(rig.update.stats.swept, 0u);
    EXPECT_EQ(rig.update.stats.touched, 0u);
    EXPECT_FALSE(chains.segments.changed());
    EXPECT_FALSE(chains.nodes.changed());
    rig.step_sun(10.02); // less than a dead band
    EXPECT_LT(rig.update.stats.touched, rig.mesh().cell_count() / 20);
    std::size_t patched = 0;
    chains.segments.each_change([&](std::size_t, std::size_t count) { patched += count; });
    EXPECT_LT(patched, chains.segments.all().size() / 2);
}

TEST(ShadeUpdateTest, TheSameBitsOnAnyThreadsAndWhenReplayed) {
    const auto played = [](int threads) {
        set_thread_limit(threads);
        auto rig = std::make_unique<ShadeRig>(knot(), 800);
        for (int i = 0; i < 30; ++i) rig->step_sun(7.0 * i);
        return rig;
    };
    const auto one = played(1), two = played(2);
    EXPECT_TRUE(same_chains(one->chains(), two->chains()));
    EXPECT_EQ(one->needed(), two->needed());
    // A job that has played something else, and is told to begin anew.
    two->update.reset();
    for (int i = 0; i < 30; ++i) two->step_sun(7.0 * i);
    EXPECT_TRUE(same_chains(one->chains(), two->chains()));
    two->update.settings.seed = 2;
    two->update.changed = true;
    two->update.run();
    EXPECT_FALSE(same_chains(one->chains(), two->chains()));
    set_thread_limit(2);
}

} // namespace
} // namespace hachure::test
