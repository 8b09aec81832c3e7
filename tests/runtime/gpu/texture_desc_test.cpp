#include <hachure/runtime/gpu/texture_desc.h>

#include <gtest/gtest.h>

namespace hachure::gpu {
namespace {

TEST(TextureDesc, CountsBytesOfEveryLevel) {
    // 8x4, 4x2, 2x1, 1x1: 32 + 8 + 2 + 1 texels.
    EXPECT_EQ((TextureDesc{8, 4, Format::rgba8, 4, 1}).bytes(), 43u * 4u);
    EXPECT_EQ((TextureDesc{8, 4, Format::r8, 1, 1}).bytes(), 32u);
}

TEST(TextureDesc, CountsBytesOfEverySample) {
    EXPECT_EQ((TextureDesc{5, 3, Format::rgba16f, 1, 4}).bytes(), 5u * 3u * 8u * 4u);
}

TEST(TextureDesc, DoesNotOverflowOnLargeTextures) {
    EXPECT_EQ((TextureDesc{32768, 32768, Format::rgba32f, 1, 1}).bytes(), std::size_t{1} << 34);
}

TEST(TextureDesc, KnowsDepthFormats) {
    EXPECT_TRUE(is_depth(Format::depth32f));
    EXPECT_TRUE(is_depth(Format::depth24));
    EXPECT_FALSE(is_depth(Format::r32f));
}

} // namespace
} // namespace hachure::gpu
