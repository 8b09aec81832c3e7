#include <hachure/runtime/error.h>
#include <hachure/runtime/gpu/framebuffer.h>
#include <hachure/runtime/gpu/state.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gmock/gmock.h>

namespace hachure::gpu {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

class FramebufferTest : public test::GlTest {
protected:
    void SetUp() override {
        test::GlTest::SetUp();
        if (!IsSkipped()) apply({});
    }
};

TEST_P(FramebufferTest, ClearsEachAttachment) {
    Texture color({2, 3, Format::rgba16f}, "color"), id({2, 3, Format::rg32ui}, "id"),
        depth({2, 3, Format::depth24}, "depth");
    const Framebuffer framebuffer({&color, &id}, &depth, "targets");
    EXPECT_EQ(framebuffer.width(), 2);
    EXPECT_EQ(framebuffer.height(), 3);
    framebuffer.clear_color(0, std::array{0.5f, 0.5f, 0.5f, 0.5f});
    framebuffer.clear_color(1, std::array<std::uint32_t, 4>{0xFFFFFFFFu, 0xFFFFFFFFu, 0, 0});
    framebuffer.clear_depth();
    EXPECT_THAT(color.read_floats(), Each(0.5f));
    EXPECT_THAT(id.read_uints(), Each(0xFFFFFFFFu));
    EXPECT_THAT(depth.read_floats(), Each(1.0f));
}

TEST_P(FramebufferTest, DrawsIntoALevel) {
    Texture texture({4, 4, Format::r8, 2}, "levels");
    texture.clear(std::array{0.0f, 0.0f, 0.0f, 0.0f});
    const Attachment level{&texture, 1};
    const Framebuffer framebuffer({&level, 1}, {}, "level 1");
    EXPECT_EQ(framebuffer.width(), 2);
    framebuffer.clear_color(0, std::array{1.0f, 0.0f, 0.0f, 0.0f});
    EXPECT_THAT(texture.read_bytes(), Each(0));
    EXPECT_THAT(texture.read_bytes(RowOrder::top_first, 1), Each(255));
}

TEST_P(FramebufferTest, CopiesOneAttachmentAndNoOther) {
    Texture a({2, 2, Format::rgba8}, "a"), b({2, 2, Format::rgba8}, "b");
    Texture c({2, 2, Format::rgba8}, "c"), d({2, 2, Format::rgba8}, "d");
    for (Texture* texture : {&a, &c, &d}) texture->clear(std::array{0.0f, 0.0f, 0.0f, 0.0f});
    b.clear(std::array{1.0f, 1.0f, 1.0f, 1.0f});
    const Framebuffer source({&a, &b}, nullptr, "source"), target({&c, &d}, nullptr, "target");
    source.blit_color(target, 1, 1);
    EXPECT_THAT(c.read_bytes(), Each(0));
    EXPECT_THAT(d.read_bytes(), Each(255));
    // Both outputs are open again.
    target.clear_color(0, std::array{1.0f, 1.0f, 1.0f, 1.0f});
    EXPECT_THAT(c.read_bytes(), Each(255));
}

TEST_P(FramebufferTest, StretchesBetweenSizes) {
    Texture small({2, 1, Format::r8}, "small"), large({4, 2, Format::r8}, "large");
    small.upload(std::vector<std::uint8_t>{10, 200});
    const Framebuffer source({&small}, nullptr, "small"), target({&large}, nullptr, "large");
    source.blit_color(target);
    EXPECT_THAT(large.read_bytes(), ElementsAre(10, 10, 200, 200, 10, 10, 200, 200));
}

TEST_P(FramebufferTest, CopiesDepth) {
    Texture near({2, 2, Format::depth32f}, "near"), far({2, 2, Format::depth32f}, "far");
    near.upload(std::vector<float>{0.1f, 0.2f, 0.3f, 0.4f});
    const Framebuffer source({}, &near, "near"), target({}, &far, "far");
    source.blit_depth(target);
    EXPECT_EQ(far.read_floats(), near.read_floats());
}

TEST_P(FramebufferTest, ResolvesSamples) {
    if (context().limits().max_samples < 4) GTEST_SKIP() << "this device has no multisampling";
    Texture samples({2, 2, Format::rgba8, 1, 4}, "samples"), resolved({2, 2, Format::rgba8}, "resolved");
    const Framebuffer source({&samples}, nullptr, "samples"), target({&resolved}, nullptr, "resolved");
    source.clear_color(0, std::array{0.2f, 0.4f, 0.6f, 0.8f});
    source.blit_color(target);
    EXPECT_THAT(resolved.read_bytes(),
                ElementsAre(51, 102, 153, 204, 51, 102, 153, 204, 51, 102, 153, 204, 51, 102, 153, 204));
}

TEST_P(FramebufferTest, SaysWhyItIsIncomplete) {
    if (context().limits().max_samples < 4) GTEST_SKIP() << "this device has no multisampling";
    const Texture one({2, 2, Format::rgba8}, "one"), four({2, 2, Format::rgba8, 1, 4}, "four");
    try {
        const Framebuffer framebuffer({&one, &four}, nullptr, "mixed");
        FAIL() << "samples were mixed";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "mixed: the framebuffer is incomplete: the textures differ in their number of samples");
    }
    EXPECT_THROW(Framebuffer({}, nullptr, "empty"), Error);
}

TEST_P(FramebufferTest, SizesMustAgree) {
    const Texture small({2, 2, Format::rgba8}, "small"), large({4, 4, Format::rgba8}, "large");
    EXPECT_DEATH(Framebuffer({&small, &large}, nullptr, "sizes"), "have one size");
    EXPECT_DEATH(Framebuffer({}, &small, "color as depth"), "colour as depth");
}

TEST_P(FramebufferTest, MovesItsObject) {
    const Texture color({1, 1, Format::r8}, "color");
    Framebuffer first({&color}, nullptr, "moved");
    const GLuint name = first.name();
    const Framebuffer second = std::move(first);
    EXPECT_EQ(second.name(), name);
    EXPECT_EQ(second.width(), 1);
    EXPECT_FALSE(first); // NOLINT(bugprone-use-after-move): that it is empty is the point
}

TEST_P(FramebufferTest, ShowsOnTheWindow) {
    if (context().window() == nullptr) GTEST_SKIP() << "this back end has no window";
    Texture color({64, 64, Format::rgba8}, "color");
    color.clear(std::array{0.2f, 0.4f, 0.6f, 1.0f});
    const Framebuffer framebuffer({&color}, nullptr, "picture");
    framebuffer.blit_to_window({0, 0, 64, 64});
    Framebuffer::bind_window();
    std::array<std::uint8_t, 4> pixel{};
    gl().ReadPixels(32, 32, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    EXPECT_THAT(std::vector<int>(pixel.begin(), pixel.begin() + 3), ElementsAre(51, 102, 153));
    context().swap_buffers();
    context().poll_events();
}

HACHURE_INSTANTIATE_GL_TESTS(FramebufferTest);

} // namespace
} // namespace hachure::gpu
