#include <hachure/runtime/gpu/frame_graph_key.h>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <bit>
#include <set>
#include <string>
#include <vector>

namespace hachure::gpu {
namespace {

TEST(FrameGraphKey, EqualValuesHaveEqualKeys) {
    const std::vector<float> numbers{1, 2, 3};
    EXPECT_EQ(key_of(1, 2.5f, "ink", std::span(numbers)), key_of(1, 2.5f, std::string("ink"), std::span(numbers)));
    EXPECT_EQ(key_of(glm::mat4(2)), key_of(glm::mat4(2)));
}

TEST(FrameGraphKey, EveryPartCounts) {
    const std::vector<float> a{1, 2}, b{1, 2, 0};
    const std::set<std::uint64_t> keys{key_of(),
                                       key_of(0),
                                       key_of(0, 0),
                                       key_of(1, 2),
                                       key_of(2, 1),
                                       key_of("ab", "c"),
                                       key_of("a", "bc"),
                                       key_of("abc"),
                                       key_of(""),
                                       key_of(std::span(a)),
                                       key_of(std::span(b)),
                                       key_of(0.0f, 1),
                                       key_of(-0.0f, 1),
                                       key_of(glm::vec3(1, 2, 3)),
                                       key_of(glm::vec3(1, 3, 2))};
    EXPECT_EQ(keys.size(), 15u);
}

TEST(FrameGraphKey, TheSmallestMoveOfACameraShows) {
    glm::mat4 view = glm::lookAt(glm::vec3(0, 0, 5), glm::vec3(0), glm::vec3(0, 1, 0));
    const std::uint64_t before = key_of(view);
    view[3][2] = std::nextafter(view[3][2], 0.0f);
    EXPECT_NE(key_of(view), before);
}

// One flipped bit of input flips about half of the output: 32 of 64, with a deviation of 4 per sample.
TEST(FrameGraphKey, BitsAvalanche) {
    int flipped = 0;
    for (int bit = 0; bit < 64; ++bit) {
        flipped += std::popcount(key_of(std::uint64_t{12345}) ^ key_of(std::uint64_t{12345} ^ std::uint64_t{1} << bit));
    }
    EXPECT_NEAR(flipped / 64.0, 32.0, 3.0);
}

TEST(FrameGraphKey, CountersDoNotCollide) {
    std::set<std::uint64_t> keys;
    for (std::uint32_t i = 0; i < 300; ++i) {
        for (std::uint32_t j = 0; j < 300; ++j) keys.insert(key_of(i, j));
    }
    EXPECT_EQ(keys.size(), 300u * 300u);
}

} // namespace
} // namespace hachure::gpu
