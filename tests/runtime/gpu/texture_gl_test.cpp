#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/gl_format.h>
#include <hachure/runtime/gpu/sampler.h>
#include <hachure/runtime/gpu/texture.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

namespace hachure::gpu {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using TextureTest = test::GlTest;

constexpr std::array all_formats = {Format::r8,      Format::rg8,    Format::rgba8,    Format::srgb8_alpha8,
                                    Format::rg16,    Format::rgba16, Format::r16f,     Format::rg16f,
                                    Format::rgba16f, Format::r32f,   Format::rg32f,    Format::rgba32f,
                                    Format::r32ui,   Format::rg32ui, Format::depth32f, Format::depth24};

std::string label_of(GLenum kind, GLuint name) {
    std::array<char, 256> label{};
    gl().GetObjectLabel(kind, name, static_cast<GLsizei>(label.size()), nullptr, label.data());
    return label.data();
}

/// Values k/255, which 8-bit formats hold exactly and the others nearly.
std::vector<float> ramp(std::size_t count) {
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>((i * 37) % 256) / 255.0f;
    return values;
}

TEST_P(TextureTest, TakesAndGivesBackFloatsInEveryFormat) {
    for (const Format format : all_formats) {
        const GlFormat& info = gl_format(format);
        if (info.kind == FormatKind::unsigned_integer) continue;
        Texture texture({5, 3, format}, info.name);
        const std::vector<float> values = ramp(static_cast<std::size_t>(15 * texture.channels()));
        texture.upload(values);
        const std::vector<float> back = texture.read_floats();
        // Half floats have 11 bits; the driver may round toward zero.
        const bool half = bytes_per_texel(format) == 2u * static_cast<std::size_t>(info.channels) &&
                          info.kind == FormatKind::floating;
        const float tolerance = half ? 1.0f / 1024.0f : 1e-6f;
        for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(back[i], values[i], tolerance) << info.name << i;
    }
}

TEST_P(TextureTest, TakesAndGivesBackBytesExactly) {
    for (const Format format : {Format::r8, Format::rg8, Format::rgba8, Format::srgb8_alpha8}) {
        Texture texture({7, 5, format}, "bytes");
        std::vector<std::uint8_t> values(static_cast<std::size_t>(35 * texture.channels()));
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint8_t>(i * 29);
        texture.upload(values);
        EXPECT_EQ(texture.read_bytes(), values) << gl_format(format).name;
    }
}

TEST_P(TextureTest, TakesAndGivesBackIntegersExactly) {
    for (const Format format : {Format::r32ui, Format::rg32ui}) {
        Texture texture({3, 3, format}, "integers");
        std::vector<std::uint32_t> values(static_cast<std::size_t>(9 * texture.channels()));
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = 0xFFFFFFFFu - static_cast<std::uint32_t>(i) * 0x01234567u;
        texture.upload(values);
        EXPECT_EQ(texture.read_uints(), values);
    }
}

TEST_P(TextureTest, KeepsFloatsOutsideTheUnitRange) {
    Texture texture({2, 1, Format::rg32f}, "wide");
    const std::vector<float> values = {-1e30f, 3.25f, 1e-30f, -0.0f};
    texture.upload(values);
    EXPECT_EQ(texture.read_floats(), values);
}

TEST_P(TextureTest, OrdersRowsAsAsked) {
    Texture texture({2, 3, Format::r8}, "rows");
    const std::vector<std::uint8_t> top_first = {1, 2, 3, 4, 5, 6};
    texture.upload(top_first, RowOrder::top_first);
    EXPECT_THAT(texture.read_bytes(RowOrder::top_first), ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_THAT(texture.read_bytes(RowOrder::bottom_first), ElementsAre(5, 6, 3, 4, 1, 2));
    texture.upload(top_first, RowOrder::bottom_first);
    EXPECT_THAT(texture.read_bytes(RowOrder::top_first), ElementsAre(5, 6, 3, 4, 1, 2));
}

TEST_P(TextureTest, ClearsEveryFormatAndLevel) {
    for (const Format format : all_formats) {
        const GlFormat& info = gl_format(format);
        Texture texture({4, 4, format, 3}, "cleared");
        if (info.kind == FormatKind::unsigned_integer) {
            texture.clear(std::array<std::uint32_t, 4>{4000000000u, 4000000000u, 0, 0});
            EXPECT_THAT(texture.read_uints(RowOrder::top_first, 2), Each(4000000000u)) << info.name;
        } else {
            texture.clear(std::array{1.0f, 1.0f, 1.0f, 1.0f});
            EXPECT_THAT(texture.read_floats(), Each(1.0f)) << info.name;
            EXPECT_THAT(texture.read_floats(RowOrder::top_first, 2), Each(1.0f)) << info.name;
        }
    }
}

TEST_P(TextureTest, HalvesSizesFromLevelToLevel) {
    const Texture texture({5, 2, Format::r8, 3}, "levels");
    EXPECT_EQ(texture.width(1), 2);
    EXPECT_EQ(texture.height(1), 1);
    EXPECT_EQ(texture.width(2), 1);
    EXPECT_EQ(texture.height(2), 1);
    EXPECT_EQ(mip_levels(5, 2), 3);
    EXPECT_EQ(mip_levels(1, 1), 1);
    EXPECT_EQ(mip_levels(1024, 1), 11);
}

TEST_P(TextureTest, AveragesMipmaps) {
    Texture texture({4, 4, Format::r32f, mip_levels(4, 4)}, "mipmaps");
    std::vector<float> values(16);
    std::iota(values.begin(), values.end(), 0.0f);
    texture.upload(values, RowOrder::bottom_first);
    texture.generate_mipmaps();
    EXPECT_THAT(texture.read_floats(RowOrder::bottom_first, 1), ElementsAre(2.5f, 4.5f, 10.5f, 12.5f));
    EXPECT_THAT(texture.read_floats(RowOrder::bottom_first, 2), ElementsAre(7.5f));
}

TEST_P(TextureTest, MovesItsObject) {
    Texture first({2, 2, Format::rgba8}, "moved");
    const GLuint name = first.name();
    EXPECT_EQ(label_of(GL_TEXTURE, name), "moved");
    Texture second = std::move(first);
    EXPECT_FALSE(first); // NOLINT(bugprone-use-after-move): that it is empty is the point
    EXPECT_EQ(second.name(), name);
    second = Texture({1, 1, Format::r8}, "other");
    EXPECT_NE(second.name(), name);
    GLint width = 0;
    gl().GetTextureLevelParameteriv(second.name(), 0, GL_TEXTURE_WIDTH, &width);
    EXPECT_EQ(width, 1);
}

TEST_P(TextureTest, SetsSampling) {
    Texture texture({4, 4, Format::rgba8, 3}, "sampled");
    const auto parameter = [&](GLenum what) {
        GLint value = 0;
        gl().GetTextureParameteriv(texture.name(), what, &value);
        return value;
    };
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), GL_LINEAR);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_CLAMP_TO_EDGE);
    texture.set_sampling({.min = Filter::linear,
                          .mag = Filter::nearest,
                          .mipmaps = true,
                          .wrap_u = Wrap::repeat,
                          .wrap_v = Wrap::mirrored_repeat,
                          .max_anisotropy = 1000.0f});
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), GL_LINEAR_MIPMAP_LINEAR);
    EXPECT_EQ(parameter(GL_TEXTURE_MAG_FILTER), GL_NEAREST);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_REPEAT);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_T), GL_MIRRORED_REPEAT);
}

TEST_P(TextureTest, SamplersBindAndUnbind) {
    const Sampler sampler(Sampling::nearest(), "nearest");
    EXPECT_EQ(label_of(GL_SAMPLER, sampler.name()), "nearest");
    const auto bound = [] {
        GLint name = 0;
        gl().ActiveTexture(GL_TEXTURE2);
        gl().GetIntegerv(GL_SAMPLER_BINDING, &name);
        return static_cast<GLuint>(name);
    };
    sampler.bind(2);
    EXPECT_EQ(bound(), sampler.name());
    Sampler::unbind(2);
    EXPECT_EQ(bound(), 0u);
}

TEST_P(TextureTest, RefusesWhatTheDeviceCannotHold) {
    const int side = context().limits().max_texture_size + 1;
    EXPECT_THROW(Texture({side, 1, Format::r8}, "too wide"), Error);
    EXPECT_THROW(Texture({1, 1, Format::rgba8, 1, context().limits().max_samples + 1}, "too many samples"), Error);
}

TEST_P(TextureTest, PixelsMustSuitFormatAndSize) {
    Texture texture({2, 2, Format::r32ui}, "integers");
    EXPECT_DEATH(texture.upload(std::vector<float>(4)), "do not suit");
    EXPECT_DEATH(texture.upload(std::vector<std::uint32_t>(5)), "do not have the level's size");
    EXPECT_DEATH((void)texture.read_uints(RowOrder::top_first, 1), "no such level");
}

HACHURE_INSTANTIATE_GL_TESTS(TextureTest);

} // namespace
} // namespace hachure::gpu
