// Strokes that keep a share of their amplitude, as the GPU draws them.

#include <hachure/systems/shade_strokes/shade_buffers.h>
#include <hachure/tests/support/gl_fixture.h>
#include <hachure/tests/support/shade_picture.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hachure::test {
namespace {

/// Half of a rib as it was laid, in double: two straight pieces.
struct LaidHalf {
    glm::dvec3 middle, bend, outer;
    double bend_side; ///< in (0, 1)

    LaidHalf(const ShadeRig& rig, std::uint32_t n, bool left)
        : middle(rig.at(n)), bend(rig.at(n, left ? 3 : 1)), outer(rig.at(n, left ? 4 : 0)),
          bend_side(std::abs(double{rig.chains().nodes[n].bend[left ? 1 : 0]})) {}

    [[nodiscard]] glm::dvec3 at(double side) const {
        return side <= bend_side ? glm::mix(middle, bend, side / bend_side)
                                 : glm::mix(bend, outer, (side - bend_side) / (1.0 - bend_side));
    }
};

std::vector<float> uneven_shares(const geometry::Shape& shape) {
    std::vector<float> shares;
    for (const glm::vec3& p : shape.positions) shares.push_back(0.6f + 0.4f * std::sin(5.0f * p.x + 3.0f * p.y));
    return shares;
}

using ShadeNarrowingGlTest = GlTest;

TEST_P(ShadeNarrowingGlTest, RibsAreDrawnInAlongThemselves) {
    ShadeRig rig(geometry::torus(1.0, 0.4, 30, 15), 800);
    rig.step_sun(20.0);
    const std::vector<float> shares = uneven_shares(rig.shape());
    const StrokeNarrowing narrowing{shares, rig.shape().indices};
    ShadePicture picture(rig);
    picture.narrow(shares);
    picture.draw(shade_view({1.0f, 3.0f, 3.0f}, 200, 200));
    std::vector<glm::vec4> ribs(rib_points * picture.buffers.node_count());
    picture.buffers.ribs.read(std::span<glm::vec4>(ribs));
    std::size_t bent_in = 0;
    for (const ShadeSegment& segment : rig.chains().segments.all()) {
        if (segment.cell == no_slot) continue;
        const glm::vec4* rib = &ribs[rib_points * segment.from];
        const double share = narrowing.of(rig.chains().nodes[segment.from]);
        ASSERT_LT(glm::distance(glm::dvec3(rib[2]), rig.at(segment.from)), 1e-5);
        for (const bool left : {false, true}) {
            const LaidHalf laid(rig, segment.from, left);
            const glm::vec4 &outer = rib[left ? 4 : 0], &inner = rib[left ? 3 : 1];
            const double sign = left ? 1.0 : -1.0;
            ASSERT_FLOAT_EQ(outer.w, static_cast<float>(sign));
            ASSERT_LT(glm::distance(glm::dvec3(outer), laid.at(share)), 1e-5);
            ASSERT_GT(sign * inner.w, 0.0f);
            ASSERT_LT(sign * inner.w, 1.0f);
            // It stays where it was as long as it lies within what is left.
            ASSERT_LT(glm::distance(glm::dvec3(inner), laid.at(sign * inner.w * share)), 1e-5);
            if (laid.bend_side > 0.95 * share) continue;
            ++bent_in;
            ASSERT_LT(glm::distance(glm::dvec3(inner), laid.bend), 1e-5);
        }
    }
    EXPECT_GT(bent_in, 100u);
}

/// Narrow strokes, and more of them, are as dark as wide ones.
TEST_P(ShadeNarrowingGlTest, DarknessStays) {
    ShadeRig rig(geometry::icosphere(1.0, 4), 3000);
    rig.step({shade_sun({0.2f, 1.0f, 0.1f})});
    const auto ink = [&] {
        ShadePicture picture(rig);
        picture.narrow({rig.update.narrowing.shares.begin(), rig.update.narrowing.shares.end()});
        double sum = 0.0;
        for (const float coverage : picture.draw(shade_view({0.8f, 1.1f, 3.6f}, 500, 500))) sum += coverage;
        return sum;
    };
    const double wide = ink();
    for (const float share : {0.8f, 0.5f}) {
        const std::vector<float> shares(rig.shape().positions.size(), share);
        rig.update.narrowing = {shares, rig.shape().indices};
        const double narrow_alone = ink();
        EXPECT_LT(narrow_alone, (0.45 + 0.55 * share) * wide) << "they cover less";
        rig.update.narrowed = true;
        rig.update.run();
        EXPECT_NEAR(ink(), wide, 0.06 * wide) << share;
        rig.update.narrowing = {};
    }
}

TEST_P(ShadeNarrowingGlTest, UploadsSharesWhenTheyChangeAlone) {
    ShadeRig rig(geometry::icosphere(1.0, 3), 1000);
    rig.step_sun(30.0);
    ShadeBuffers buffers;
    buffers.update(*rig.update.chains);
    EXPECT_FALSE(buffers.shares) << "nobody asked";
    const ShadeUploads before = buffers.uploads();
    const std::vector<float> shares(rig.shape().positions.size(), 0.5f);
    rig.update.narrowing = {shares, rig.shape().indices};
    rig.update.narrowed = true;
    std::vector<float> less; // needed: so that what is delivered changes, but no stroke
    for (const ShadeCellState& cell : rig.chains().cells) less.push_back(0.5f * cell.delivered);
    rig.update.needed = less;
    rig.update.run();
    ASSERT_EQ(rig.update.stats.touched, 0u);
    buffers.update(*rig.update.chains, shares, 1);
    std::vector<float> read(shares.size()), delivered(less.size());
    buffers.shares.read(std::span<float>(read));
    buffers.delivered.read(std::span<float>(delivered));
    EXPECT_EQ(read, shares);
    for (std::size_t c = 0; c < less.size(); ++c) EXPECT_NEAR(delivered[c], less[c], 1e-5f);
    EXPECT_LE(buffers.uploads().bytes - before.bytes, 4 * (shares.size() + less.size()));
    const ShadeUploads after = buffers.uploads();
    buffers.update(*rig.update.chains, shares, 1);
    EXPECT_EQ(buffers.uploads(), after);
    buffers.update(*rig.update.chains, {}, 2);
    EXPECT_FALSE(buffers.shares);
}

HACHURE_INSTANTIATE_GL_TESTS_ONCE(ShadeNarrowingGlTest);

} // namespace
} // namespace hachure::test
