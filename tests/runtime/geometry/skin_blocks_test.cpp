#include <hachure/runtime/geometry/skin_weights.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

namespace hachure::geometry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Vertices that follow `per_vertex` joints from that of their own on.
SkinWeights packed(std::size_t count, std::size_t joint_count, int per_vertex, auto joint_of) {
    std::vector<glm::u16vec4> joints(count);
    std::vector<glm::vec4> weights(count, glm::vec4(0.0f));
    for (std::size_t v = 0; v < count; ++v)
        for (int k = 0; k < per_vertex; ++k) {
            joints[v][k] = static_cast<std::uint16_t>((joint_of(v) + static_cast<std::size_t>(k)) % joint_count);
            weights[v][k] = static_cast<float>(4 - k);
        }
    return pack_skin_weights(count, joint_count, joints, weights);
}

TEST(SkinBlocks, ListEachJointOnce) {
    const SkinWeights weights = packed(20, 10, 2, [](std::size_t v) { return v / 16; });
    ASSERT_EQ(weights.blocks().block_count(), 2u);
    EXPECT_THAT(weights.blocks().joints(0), ElementsAre(0u, 1u));
    EXPECT_THAT(weights.blocks().joints(1), ElementsAre(1u, 2u));
    EXPECT_FLOAT_EQ(weights.blocks().weights(1)[0].of_vertex[3], 4.0f / 7.0f);
    EXPECT_EQ(weights.blocks().weights(1)[0].of_vertex[4], 0.0f); // past the mesh
}

TEST(SkinBlocks, SayWhatTheVerticesSay) {
    std::mt19937 random(7);
    const SkinWeights weights = packed(1003, 30, 4, [&](std::size_t v) { return v / 4 + random() % 3; });
    std::size_t listed = 0;
    for (std::size_t b = 0; b < weights.blocks().block_count(); ++b) {
        const auto joints = weights.blocks().joints(b);
        listed += !joints.empty();
        for (std::size_t v = 16 * b; !joints.empty() && v < std::min<std::size_t>(16 * b + 16, 1003); ++v) {
            std::map<std::uint32_t, float> of_vertex, of_block;
            for (std::size_t k = 0; k < 4; ++k) of_vertex[weights.joint(v, k)] += weights.weight(v, k);
            for (std::size_t k = 0; k < joints.size(); ++k)
                if (const float weight = weights.blocks().weights(b)[k].of_vertex[v % 16]; weight > 0.0f)
                    of_block[joints[k]] = weight;
            EXPECT_EQ(of_block, of_vertex) << v;
        }
    }
    EXPECT_GT(listed, 50u);
}

TEST(SkinBlocks, OneThatFollowsManyListsNone) {
    const SkinWeights weights = packed(48, 100, 1, [](std::size_t v) { return v < 16 ? v % 12 : v < 32 ? v % 13 : 5; });
    EXPECT_EQ(weights.blocks().joints(0).size(), SkinBlocks::joint_limit);
    EXPECT_THAT(weights.blocks().joints(1), IsEmpty());
    EXPECT_THAT(weights.blocks().joints(2), ElementsAre(5u));
}

TEST(SkinBlocks, VerticesWithoutWeightFollowTheLastEntry) {
    const SkinWeights weights = pack_skin_weights(3, 10, std::span<const glm::u16vec4>(), {});
    EXPECT_THAT(weights.blocks().joints(0), ElementsAre(10u));
    EXPECT_EQ(SkinWeights().blocks().block_count(), 0u);
}

} // namespace
} // namespace hachure::geometry
