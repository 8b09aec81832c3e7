#include <hachure/runtime/geometry/skin_weights.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hachure::geometry {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();

SkinWeights pack_one(glm::u16vec4 joints, glm::vec4 weights, std::size_t joint_count = 10) {
    return pack_skin_weights(1, joint_count, {&joints, 1}, {&weights, 1});
}

std::vector<std::pair<std::uint32_t, float>> influences(const SkinWeights& packed, std::size_t vertex) {
    std::vector<std::pair<std::uint32_t, float>> result;
    for (std::size_t k = 0; k < packed.influences(); ++k)
        result.emplace_back(packed.joint(vertex, k), packed.weight(vertex, k));
    return result;
}

TEST(SkinWeights, TheMostSignificantComeFirst) {
    const SkinWeights packed = pack_one({3, 1, 4, 5}, {0.125f, 0.5f, 0.25f, 0.125f});
    EXPECT_THAT(influences(packed, 0),
                ElementsAre(std::pair(1u, 0.5f), std::pair(4u, 0.25f), std::pair(3u, 0.125f), std::pair(5u, 0.125f)));
    EXPECT_FALSE(packed.repairs().any());
}

TEST(SkinWeights, ARepeatedJointCountsOnce) {
    const SkinWeights packed = pack_one({3, 1, 3, 0}, {0.25f, 0.25f, 0.5f, 0.0f});
    EXPECT_THAT(influences(packed, 0),
                ElementsAre(std::pair(3u, 0.75f), std::pair(1u, 0.25f), std::pair(3u, 0.0f), std::pair(3u, 0.0f)));
}

TEST(SkinWeights, SumsAreMadeOne) {
    const SkinWeights packed = pack_one({0, 1, 2, 3}, {3.0f, 1.0f, 2.0f, 2.0f});
    EXPECT_FLOAT_EQ(packed.weight(0, 0), 0.375f);
    EXPECT_EQ(packed.repairs().unnormalised, 1u);
    EXPECT_EQ(pack_one({0, 1, 2, 3}, {0.25f, 0.25f, 0.25f, 0.2502f}).repairs().unnormalised, 0u); // of 8 bits
}

TEST(SkinWeights, AVertexWithoutWeightFollowsTheLastEntry) {
    for (const glm::vec4 weights : {glm::vec4(0.0f), glm::vec4(-1.0f), glm::vec4(nan), glm::vec4(infinite)}) {
        const SkinWeights packed = pack_one({1, 2, 3, 4}, weights);
        EXPECT_EQ(packed.joint(0, 0), 10u);
        EXPECT_EQ(packed.weight(0, 0), 1.0f);
        EXPECT_EQ(packed.repairs().without_weight, 1u);
    }
    const SkinWeights none = pack_skin_weights(3, 10, std::span<const glm::u16vec4>(), {});
    EXPECT_EQ(none.repairs().without_weight, 3u);
    EXPECT_EQ(none.joint(2, 3), 10u);
}

TEST(SkinWeights, WhatIsWrongIsLeftOutAndCounted) {
    const SkinWeights packed = pack_one({1, 10, 3, 4}, {0.25f, 0.25f, -1.0f, nan});
    EXPECT_EQ(packed.joint(0, 0), 1u);
    EXPECT_EQ(packed.weight(0, 0), 1.0f);
    EXPECT_EQ(packed.repairs().out_of_range, 1u);
    EXPECT_EQ(packed.repairs().negative, 1u);
    EXPECT_EQ(packed.repairs().non_finite, 1u);
    EXPECT_EQ(packed.repairs().without_weight, 0u);
    EXPECT_EQ(pack_one({1, 9999, 3, 4}, {1.0f, 0.0f, 0.0f, 0.0f}).repairs().any(), false); // unused: no harm
    EXPECT_THAT(skin_weight_warnings(packed.repairs(), "Fox"),
                testing::Contains(HasSubstr("Fox: 1 vertices have neg")));
    EXPECT_EQ(skin_weight_warnings(packed.repairs(), "Fox").size(), 4u);
}

TEST(SkinWeights, WeightsOfAnySizeHaveASum) {
    const float largest = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
    EXPECT_FLOAT_EQ(pack_one({0, 1, 2, 3}, glm::vec4(largest)).weight(0, 3), 0.25f);
    EXPECT_FLOAT_EQ(pack_one({0, 1, 2, 3}, glm::vec4(least)).weight(0, 3), 0.25f);
}

TEST(SkinWeights, EightInfluencesOnlyWhereAVertexHasThem) {
    const std::vector<glm::u16vec4> first{{0, 1, 2, 3}, {0, 1, 2, 3}}, second{{4, 5, 6, 7}, {4, 5, 6, 7}};
    std::vector<glm::vec4> low(2, glm::vec4(0.125f)), high(2, glm::vec4(0.0f));
    EXPECT_EQ(pack_skin_weights(2, 8, first, low, second, high).influences(), 4u);
    high[1] = {0.0f, 0.5f, 0.0f, 0.0f};
    const SkinWeights packed = pack_skin_weights(2, 8, first, low, second, high);
    EXPECT_EQ(packed.influences(), 8u);
    EXPECT_EQ(packed.joint(1, 0), 5u);
    EXPECT_FLOAT_EQ(packed.weight(1, 4), 0.125f);
    const SkinWeights four = pack_skin_weights(2, 8, first, low, second, high, InfluenceLimit::four);
    EXPECT_EQ(four.influences(), 4u);
    EXPECT_EQ(four.repairs().truncated, 1u);
    EXPECT_FLOAT_EQ(four.weight(1, 0), 0.5f / 0.875f);
}

TEST(SkinWeights, IndicesAreAsWideAsTheSkinNeeds) {
    for (const auto& [joints, bytes] : {std::pair(255u, 1u), std::pair(256u, 2u), std::pair(65535u, 2u),
                                        std::pair(65536u, 4u), std::pair(100000u, 4u)}) {
        const glm::uvec4 last{joints - 1, 0, 0, 0};
        const glm::vec4 weights{0.5f, 0.5f, 0.0f, 0.0f};
        const SkinWeights packed = pack_skin_weights(1, joints, {&last, 1}, {&weights, 1});
        EXPECT_EQ(packed.joint_bytes(), bytes);
        EXPECT_EQ(packed.joint(0, 1), joints - 1); // equal weights: by joint
        const SkinWeights none = pack_skin_weights(1, joints, std::span<const glm::uvec4>(), {});
        EXPECT_EQ(none.joint(0, 0), joints);
    }
}

} // namespace
} // namespace hachure::geometry
