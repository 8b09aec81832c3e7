#include <hachure/runtime/gpu/buffer.h>
#include <hachure/tests/support/gl_fixture.h>

#include <gmock/gmock.h>

#include <cstring>
#include <vector>

namespace hachure::gpu {
namespace {

using ::testing::ElementsAre;
using BufferTest = test::GlTest;

TEST_P(BufferTest, HoldsWhatItWasMadeWith) {
    const std::vector<float> values = {1.0f, 2.5f, -3.0f};
    const Buffer buffer(std::span<const float>(values), "values");
    EXPECT_EQ(buffer.bytes(), 12u);
    std::vector<float> back(3);
    buffer.read(std::span(back));
    EXPECT_EQ(back, values);
}

TEST_P(BufferTest, StartsZeroedAndTakesUpdates) {
    Buffer buffer(4 * sizeof(int), BufferUsage::dynamic, "integers");
    const std::vector<int> values = {7, 8};
    buffer.update(std::span<const int>(values), 2 * sizeof(int));
    std::vector<int> back(4, -1);
    buffer.read(std::span(back));
    EXPECT_THAT(back, ElementsAre(0, 0, 7, 8));
    buffer.clear();
    buffer.read(std::span(back));
    EXPECT_THAT(back, ElementsAre(0, 0, 0, 0));
}

TEST_P(BufferTest, MapsAPart) {
    Buffer buffer(8, BufferUsage::dynamic, "mapped");
    {
        BufferMapping mapping = buffer.map(4, 4);
        ASSERT_EQ(mapping.bytes().size(), 4u);
        const BufferMapping moved = std::move(mapping);
        std::memset(moved.bytes().data(), 0x11, 4);
    }
    std::vector<std::uint32_t> back(2);
    buffer.read(std::span(back));
    EXPECT_THAT(back, ElementsAre(0u, 0x11111111u));
}

TEST_P(BufferTest, MovesItsObject) {
    Buffer first(1, BufferUsage::immutable, "moved");
    const GLuint name = first.name();
    Buffer second = std::move(first);
    EXPECT_EQ(second.name(), name);
    EXPECT_FALSE(first); // NOLINT(bugprone-use-after-move): that it is empty is the point
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_P(BufferTest, BindsToIndexedPoints) {
    const Buffer buffer(64, BufferUsage::immutable, "storage");
    buffer.bind_base(BufferBinding::storage, 3);
    GLint name = 0;
    gl().GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 3, &name);
    EXPECT_EQ(static_cast<GLuint>(name), buffer.name());
}

TEST_P(BufferTest, MisuseIsAnAssertion) {
    Buffer fixed(4, BufferUsage::immutable, "fixed");
    const std::vector<int> one = {1};
    EXPECT_DEATH(fixed.update(std::span<const int>(one)), "immutable buffer");
    Buffer dynamic(4, BufferUsage::dynamic, "dynamic");
    EXPECT_DEATH(dynamic.update(std::span<const int>(one), 1), "past the end");
    EXPECT_DEATH((void)dynamic.map(2, 3), "past the end");
    EXPECT_DEATH(Buffer(0, BufferUsage::dynamic, "empty"), "at least one byte");
}

HACHURE_INSTANTIATE_GL_TESTS(BufferTest);

} // namespace
} // namespace hachure::gpu
